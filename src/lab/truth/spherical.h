/// Whether a balloon of a scene is one that has a closed form: a round skin, alike all over, of
/// rubber or of springs that make a sheet. Then its pressure over its stretch is known
/// (lab/truth/truth.h), whatever blows it up.
///
/// A membrane has its material's form. Quads of springs are a sheet of equibiaxial stiffness
/// B = ks + 4 kf + 2 kd with their law, Hooke's or rubber's: within a few per cent where the kinds
/// are as unlike as the mass-spring paper's.
#ifndef BALLOON_LAB_TRUTH_SPHERICAL_H
#define BALLOON_LAB_TRUTH_SPHERICAL_H

#include "lab/truth/truth.h"
#include "world/balloon.h"

typedef struct Spherical {
    TruthBalloon truth;
    double volume; ///< V0, of the mesh at rest: the stretch is (V/V0)^(1/3) [m^3]
} Spherical;

/// False where no closed form is known.
bool spherical_find(const Balloon* balloon, Spherical* round);

#endif
