/// What a balloon's def asks of its mesh and of the state.
#ifndef BALLOON_WORLD_BALLOON_CHECK_H
#define BALLOON_WORLD_BALLOON_CHECK_H

#include "world/balloon.h"

/// Check the def against the mesh: numbers of particles, that a mesh to be inflated is closed, and
/// the number of springs around a vertex.
bool balloon_check_mesh(const Balloon* balloon, const char* location, int number, Fault* fault);

/// Check of a balloon or a thing that the state's type resolves the shape where the balloon is: far from the origin the
/// coordinates of neighbors round to the same number.
bool balloon_check_position(const Body* body, const char* location, const char* name, Fault* fault);

#endif
