/// Sorts triangles from far to near. Translucent triangles are blended in this order, so that the
/// nearer one lies over the farther one, within a shape and between shapes.
#ifndef BALLOON_DRAW_DEPTH_H
#define BALLOON_DRAW_DEPTH_H

#include <stdint.h>

/// order[k] is the index of the k-th largest depth. Equal depths keep their order, so the same
/// picture gives the same pixels. Depths are resolved to 1/65535 of their range. Linear in count.
/// scratch: 2 count elements.
void depth_sort(const float* depth, int count, int* order, uint64_t* scratch);

#endif
