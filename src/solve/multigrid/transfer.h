/// P between a level of multigrid.h and the next coarser one, by smoothed aggregation (P. Vanek, J.
/// Mandel, M. Brezina, Algebraic multigrid by smoothed aggregation, 1996).
///
/// Neighbors in the matrix's graph form aggregates; an aggregate g is a node of the coarser level,
/// with the translation T_g and, on coarser levels, also the rotation R_g about the mean c_g of its
/// nodes' positions. Averaging over neighbors smooths P: with w_ig the sum of shares, and m_ig the
/// sum of shares times x_j - c_g, over node i and its neighbors j in aggregate g,
///
///     t_i = sum over g  w_ig T_g + R_g x m_ig        r_i = sum over g  w_ig R_g
///
/// A skin's softest motions strain it little, but rotate it by an amount that varies along the
/// skin. Translations alone approximate such motions poorly: with rotations a solve takes a quarter
/// fewer cycles, and the coarse levels are so small that the second row costs almost nothing.
#ifndef BALLOON_SOLVE_MULTIGRID_TRANSFER_H
#define BALLOON_SOLVE_MULTIGRID_TRANSFER_H

#include <stdint.h>

#include <stdbool.h>

#include "base/vec.h"
#include "force/block_matrix.h"

/// P or P^T, eight rows side by side (SELL-8, as in body/slices.h).
///
///     out_i = sum over the slots of row i  weight in_j + in_j x arm
typedef struct TransferSlices {
    int count;                 ///< slices
    int* from;                 ///< [count + 1] first slot of each
    uint32_t (*offset)[LANES]; ///< [slots] of in_j, in bytes from the start of a real4 array
    real (*weight)[LANES];     ///< [slots]
    real (*arm)[3][LANES];     ///< [slots] [m]; NULL where no node rotates
    int (*term)[LANES];        ///< [slots] term that the arm belongs to, or NONE; NULL as the arms
} TransferSlices;

typedef struct Transfer {
    int nodes;          ///< of the finer level
    int aggregates;     ///< nodes of the coarser level
    int rows;           ///< of a finer node: 1 (t), or 2 where nodes rotate (t and r)
    int aggregate_rows; ///< the same of a coarser node
    int* neighbor_from; ///< [nodes + 1] first neighbor of each node
    int* neighbor;      ///< [neighbor_from[nodes]] a node's neighbors; the first is the node itself
    int* aggregate;     ///< [nodes] that each node belongs to
    int* from;          ///< [nodes + 1] first term of each node: a term is a pair (i, g)
    int* term_aggregate; ///< [from[nodes]] g
    real* weight;        ///< [from[nodes]] w_ig; a node's sum is 1, a held node has no terms
    real4* arm;          ///< [from[nodes]] m_ig [m]; NULL where no aggregate rotates
    TransferSlices prolongation; ///< P
    TransferSlices restriction;  ///< P^T
} Transfer;

/// Find aggregates in the matrix's graph. nodes_rotate: the matrix has two rows for each node;
/// aggregates_rotate: so will the coarser one. A node of inverse_mass 0 is held; NULL: none is.
/// Returns false, with an empty transfer, where no two nodes can be joined.
bool transfer_make(Transfer* transfer, const BlockMatrix* matrix, const real* inverse_mass,
                   bool nodes_rotate, bool aggregates_rotate);

/// Follow the nodes' places; finds those of the aggregates.
void transfer_update(Transfer* transfer, const real4* position, real4* aggregate_position);

/// coarse = P^T fine
void transfer_restrict(const Transfer* transfer, const real4* fine, real4* coarse);

/// fine += P coarse
void transfer_prolong(const Transfer* transfer, const real4* coarse, real4* fine);

void transfer_free(Transfer* transfer);

/// out = slices in, or out += slices in with `add`; compiled once for each kind of machine
/// (base/cpu.h). Arrays have capacity up to the next multiple of eight.
typedef void (*TransferKernel)(const TransferSlices* slices, const real4* in, bool add, real4* out);

void transfer_multiply_baseline(const TransferSlices* slices, const real4* in, bool add,
                                real4* out);
#ifdef __x86_64__
void transfer_multiply_v3(const TransferSlices* slices, const real4* in, bool add, real4* out);
#endif

#endif
