/// Finds the closed form of a balloon: a homogeneous sphere of rubber, or of springs that form a
/// sheet, has a known pressure over its stretch (lab/truth/truth.h) under any inflation law.
///
/// A membrane has its material's form. Quads of springs are a sheet of equibiaxial stiffness
/// B = ks + 4 kf + 2 kd with their law, Hooke's or rubber's: accurate to a few percent when the
/// kinds have stiffnesses as different as in the mass-spring paper.
#ifndef BALLOON_LAB_TRUTH_SPHERICAL_H
#define BALLOON_LAB_TRUTH_SPHERICAL_H

#include "lab/truth/truth.h"
#include "world/balloon.h"

typedef struct Spherical {
    TruthBalloon truth;
    double volume; ///< V0, of the mesh at rest: the stretch is (V/V0)^(1/3) [m^3]
} Spherical;

/// Returns false if no closed form is known.
bool spherical_find(const Balloon* balloon, Spherical* spherical);

#endif
