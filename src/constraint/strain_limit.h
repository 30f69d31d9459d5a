/// Correction of over-stretched springs, between kick and drift: Provot, and Tarantino with it.
///
/// Provot: one pass over the springs, structural, shear, flexion, at the positions that the
/// particles are about to reach; a spring over (1 + threshold) times its rest length has its ends
/// moved together to that length, half each, or all at the free end where the other is held. A
/// moved particle's velocity is then v = (x_corrected - x) / h, that of its actual motion; else
/// energy without motion remains. Tarantino: such a spring exerts no force in the next step.
/// Sources: X. Provot, Deformation constraints in a mass-spring model to describe rigid cloth
/// behaviour, 1995; the mass-spring balloon paper, "Particle Position Correction".
#ifndef BALLOON_CONSTRAINT_STRAIN_LIMIT_H
#define BALLOON_CONSTRAINT_STRAIN_LIMIT_H

#include "body/body.h"

typedef struct StrainLimit {
    bool on;
    bool tarantino;
    bool phantom; ///< keep the uncorrected velocities, to show the energy that this adds
    double threshold[SPRING_KINDS]; ///< ratio over rest length; 0: this kind is not corrected
    real4* ahead;                   ///< [count] positions after the coming drift [m]
    int corrected;                  ///< springs that the last step corrected
} StrainLimit;

/// Change the velocities so that the coming drift of length h leaves no spring over its limit, as
/// far as one pass achieves that. Does nothing when off. whole: the substep of which this drift is a
/// part. A spring that is too long already keeps 1 - h / whole of its excess: to undo all in a short
/// part would take a speed in proportion to 1 / h, and energy from nowhere.
void strain_limit_velocity(StrainLimit* correct, Body* body, double h, double whole);

/// Turn correction on or off; off gives every spring its force back.
void strain_limit_switch(StrainLimit* correct, Body* body, bool on);

void strain_limit_free(StrainLimit* correct);

#endif
