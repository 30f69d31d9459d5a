/// Sorts far to near: see-through triangles are blended in this order, so that what is behind is
/// seen through what is in front, on any shape and across shapes.
#ifndef BALLOON_DRAW_DEPTH_H
#define BALLOON_DRAW_DEPTH_H

#include <stdint.h>

/// order[k] is the index of the k-th farthest of `depth`; equal ones keep their order, so the same
/// picture gives the same pixels. Depth is told apart to 1/65535 of its range. Linear in count.
/// scratch: 2 count elements.
void depth_sort(const float* depth, int count, int* order, uint64_t* scratch);

#endif
