/// The neighbourhoods of the particles, eight particles side by side (SELL-8).
///
/// A slice is eight particles that follow each other; a slot is one neighbour of each of them, and
/// the spring to it. Each spring is in two slots, one for each end: computing it twice is cheaper
/// than scattering its pull. Slots of a particle, with its faces in the order in which they lie
/// around it:
///
///            c0  b1             b0 c0  b1 c1  …  then the springs that are left
///             \ /
///        b0 - a - b2            face k of a has the corners a, b_k, c_k, b_(k+1); the last one
///             / \               closes the ring at b_0; a triangle has c_k = b_k
///            …   c1
///
/// Particles are numbered along fronts (mesh/reorder.h), so the eight neighbours in a slot often
/// follow each other as the particles do: in 47 % of the slots of the teddy (11,120 particles), in
/// 81 % on a regular mesh of that size. Such a row is read straight from arrays of each coordinate.
///
/// Where something is summed up over the faces, each is counted at its corner of the lowest number;
/// a closed ring begins with these. On a rim the faces are an open fan: its last edge is one more
/// pair (b_n, c_n = a), and a pair whose c is the particle a itself is not a face. Where a particle has fewer faces than the others of its
/// slice, its ring stays at b_0; where a slot has no spring, its stiffness is 0. Source: M.
/// Kreutzer et al., A unified sparse matrix data format (SELL-C-sigma), 2014.
#ifndef BALLOON_BODY_SLICES_H
#define BALLOON_BODY_SLICES_H

#include "base/lanes.h"
#include "body/springs.h"

/// Work is split into parts of fixed size, independent of the thread count, so that sums have one
/// order.
enum { PART_SLICES = 64, PART_PARTICLES = PART_SLICES * LANES };

typedef struct Slices {
    int count;                ///< slices
    int* from;                ///< [count + 1] first slot of each
    int* faces;               ///< [count] pairs of slots of the longest ring in it
    int* counted_from;        ///< [count + 1] first of each in `counted`
    real (*counted)[LANES];   ///< [pairs] 1 where a face is counted, else 0: the first pairs alone
    uint32_t (*place)[LANES]; ///< [slots] neighbour, in bytes from the start of a real4 array
    real (*stiffness)[LANES]; ///< [slots] that acts in this step [N/m]; NULL without springs
    real (*rest)[LANES];      ///< [slots] rest length [m]
    int (*spring)[2];         ///< [springs] where a spring's two ends are: slot * LANES + lane
    bool open;                ///< there is a rim
    bool* row;                ///< [slots] its eight neighbours follow each other
    real* line[3];            ///< [particles] x, y and z of the sweep at hand, for rows [m]
    double (*sum)[5];         ///< [parts] room for sums over the slices of each part
} Slices;

/// Slices of `count` particles. mesh or springs may be NULL: then there are no rings, or only them.
void slices_make(Slices* slices, int count, const Mesh* mesh, const Springs* springs);

/// Parts of so many slices or particles.
static inline int parts_of(int count, int part) {
    return (count + part - 1) / part;
}

/// Which stiffness of a spring acts in this step [N/m].
static inline void slices_stiffen(const Slices* slices, int spring, real stiffness) {
    for (int end = 0; end < 2; end++) {
        const int at = slices->spring[spring][end];
        slices->stiffness[at / LANES][at % LANES] = stiffness;
    }
}

void slices_free(Slices* slices);

#endif
