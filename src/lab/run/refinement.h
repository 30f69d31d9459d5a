/// A scene on coarser or finer meshes, if its models are built-in shapes with numbers.
///
/// One refinement doubles the edges in each direction (below 0: halves them), or splits an
/// icosphere once more. The skin's total mass and damping stay; stiffnesses of springs stay,
/// because those of a sheet do not depend on its cells.
#ifndef BALLOON_LAB_RUN_REFINEMENT_H
#define BALLOON_LAB_RUN_REFINEMENT_H

#include "lab/run/overrides.h"
#include "world/world.h"

/// Add the overrides that refine (> 0) or coarsen (< 0) every balloon so many times. Returns false,
/// with nothing added, if no balloon has such a refinement; refinement 0 is the scene's own mesh.
bool refinement_add(const World* world, int refinement, Overrides* sets);

#endif
