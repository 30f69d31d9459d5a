/// A scene on coarser or finer meshes, where its models are shapes that the program makes itself.
///
/// A shape without numbers is meant as it is. A level is half as many edges each way, or twice as
/// many; of an icosphere one split less or more. The skin's whole mass and damping stay; springs of
/// a sheet do not change with its cells.
#ifndef BALLOON_LAB_RUN_REFINEMENT_H
#define BALLOON_LAB_RUN_REFINEMENT_H

#include "lab/run/overrides.h"
#include "world/world.h"

/// Add the overrides that bring every balloon `level` levels up (finer) or down (below 0). False,
/// with nothing added, where no balloon has such a level: level 0 is the scene as it is.
bool refinement_add(const World* world, int level, Overrides* sets);

#endif
