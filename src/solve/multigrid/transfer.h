/// From a level of multigrid.h to the next coarser one, and back: P of smoothed aggregation
/// (P. Vanek, J. Mandel, M. Brezina, Algebraic multigrid by smoothed aggregation, 1996).
///
/// Neighbours in the matrix's graph join into groups, and a coarse node is a group's motion: where
/// it goes, T, and on coarser levels also how it turns, R, about the mean c of the group's places.
/// A node at a group's edge belongs in part to the next. With w_ig, m_ig the sums of shares and of
/// shares times x_j - c_g over node i itself and its neighbours j that are of group g,
///
///     t_i = sum over g  w_ig T_g + R_g x m_ig        r_i = sum over g  w_ig R_g
///
/// What a skin is softest against strains it least, and turns it from place to place. Coarse nodes
/// that only go cannot follow it; those that turn take a quarter of the cycles away, and are too
/// few to cost anything.
#ifndef BALLOON_SOLVE_MULTIGRID_TRANSFER_H
#define BALLOON_SOLVE_MULTIGRID_TRANSFER_H

#include <stdbool.h>

#include "base/lanes.h"
#include "force/block_matrix.h"

/// P, or P^T: eight rows side by side (SELL-8, as body/slices.h).
///
///     out_i = sum over slots  weight in_place + in_place x arm
typedef struct Sums {
    int count;                ///< slices
    int* from;                ///< [count + 1] first slot of each
    uint32_t (*place)[LANES]; ///< [slots] in bytes from the start of a real4 array
    real (*weight)[LANES];    ///< [slots]
    real (*arm)[3][LANES];    ///< [slots] [m]; NULL where nothing turns
    int (*part)[LANES];       ///< [slots] whose arm it is, or NONE; NULL as the arms
} Sums;

typedef struct Transfer {
    int nodes;      ///< of the finer level
    int groups;     ///< nodes of the coarser one
    int rows;       ///< of a finer node: 1, or 2 where it turns, t and r
    int group_rows; ///< of a coarser one
    int* near_from; ///< [nodes + 1] the graph
    int* near;      ///< [near_from[nodes]] a node's neighbours, itself first
    int* group;     ///< [nodes]
    int* from;      ///< [nodes + 1] P's parts
    int* coarse;    ///< [from[nodes]] group
    real* weight;   ///< [from[nodes]] w; they add up to 1, or to 0 where the node is held
    real4* arm;     ///< [from[nodes]] m [m]; NULL where nothing turns
    Sums up;        ///< P
    Sums down;      ///< P^T
} Transfer;

/// Find groups in a matrix's graph; turned: its nodes have two rows each; turns: so do the groups.
/// inverse_mass: 0 holds a node; NULL: none is held. False where no two nodes join, and nothing is
/// made.
bool transfer_make(Transfer* transfer, const BlockMatrix* matrix, const real* inverse_mass,
                   bool turned, bool turns);

/// Follow the nodes' places; finds those of the groups.
void transfer_place(Transfer* transfer, const real4* place, real4* group_place);

/// coarse = P^T fine
void transfer_restrict(const Transfer* transfer, const real4* fine, real4* coarse);

/// fine += P coarse
void transfer_prolong(const Transfer* transfer, const real4* coarse, real4* fine);

void transfer_free(Transfer* transfer);

/// The loop over slices, in as many compilations as there are kinds of machine (base/cpu.h); `add`
/// to what is there. Arrays have room up to the next multiple of eight.
typedef void (*SumsKernel)(const Sums* sums, const real4* in, bool add, real4* out);

void sums_baseline(const Sums* sums, const real4* in, bool add, real4* out);
#ifdef __x86_64__
void sums_v3(const Sums* sums, const real4* in, bool add, real4* out);
#endif

#endif
