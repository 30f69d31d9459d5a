/// The neighbors of each particle, eight particles side by side (SELL-8): sliced ELLPACK with
/// slices of eight rows. Source: M. Kreutzer et al., A unified sparse matrix data format
/// (SELL-C-sigma), 2014.
///
/// A slice is eight consecutive particles; a slot holds one neighbor of each of them, and the
/// spring to it. Each spring is in two slots, one for each end: to compute it twice is cheaper than
/// to scatter its force. The slots of a particle a begin with its faces, in order around it:
///
///            c0  b1             b0 c0  b1 c1  …  then the remaining springs
///             \ /
///        b0 - a - b2            face k of a has the corners a, b_k, c_k, b_(k+1); the last one
///             / \               closes the ring at b_0; a triangle has c_k = b_k
///            …   c1
///
/// Padding: where a particle has fewer faces than another one of its slice, its ring repeats b_0;
/// where a slot has no spring, its stiffness is 0. The faces around a rim particle are an open fan:
/// an extra pair (b_n, c_n = a) ends it, and a pair with c_k = a is not a face.
///
/// A sum over all faces counts each face once, at its corner of the lowest number; a closed ring
/// begins with such faces.
///
/// Particles are numbered along fronts (mesh/reorder.h), so the eight neighbors in a slot often
/// have consecutive numbers: in 47 % of the slots of the teddy (11,120 particles), in 81 % on a
/// regular mesh of that size. Such a slot is contiguous: it is read without a gather, from one
/// array for each coordinate.
#ifndef BALLOON_BODY_SLICES_H
#define BALLOON_BODY_SLICES_H

#include <stdint.h>

#include "base/vec.h"
#include "body/springs.h"

/// Work is split into parts of fixed size, independent of the thread count, so that sums have one
/// order.
enum { PART_SLICES = 64, PART_PARTICLES = PART_SLICES * LANES };

typedef struct Slices {
    int count;                 ///< slices
    int* from;                 ///< [count + 1] first slot of each
    int* faces;                ///< [count] pairs of slots of the longest ring in each slice
    int* counted_from;         ///< [count + 1] first element of each slice in `counted`
    real (*counted)[LANES];    ///< [pairs] 1 where a face is counted here, else 0
    uint32_t (*offset)[LANES]; ///< [slots] neighbor, in bytes from the start of a real4 array
    real (*stiffness)[LANES];  ///< [slots] present stiffness [N/m]; NULL without springs
    real (*rest)[LANES];       ///< [slots] rest length [m]
    int (*spring)[2];          ///< [springs] slot * LANES + lane of either end
    bool open;                 ///< the skin has a rim
    bool* contiguous;          ///< [slots] its eight neighbors have consecutive numbers
    real* coordinate[3];       ///< [particles] x, y, z, of the present sweep [m]
    double (*sum)[5];          ///< [parts] workspace: sums over the slices of each part
} Slices;

/// Slices of `count` particles. mesh NULL: no rings; springs NULL: rings only.
void slices_make(Slices* slices, int count, const Mesh* mesh, const Springs* springs);

/// Number of parts of `count` slices or particles, `part` in each.
static inline int parts_of(int count, int part) {
    return (count + part - 1) / part;
}

/// Set the present stiffness of a spring [N/m].
static inline void slices_set_stiffness(const Slices* slices, int spring, real stiffness) {
    for (int end = 0; end < 2; end++) {
        const int at = slices->spring[spring][end];
        slices->stiffness[at / LANES][at % LANES] = stiffness;
    }
}

void slices_free(Slices* slices);

#endif
