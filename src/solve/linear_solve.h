/// The linear equation of a Newton iteration (newton.c), by preconditioned conjugate gradients.
///
///     A dv = -R,  A = M + h D + h^2 K        M mass, D drag, K = -df/dx
///
/// K's sparse part is assembled in blocks (force/tangent.h). Dense parts, such as the gas's
/// rank-one part, are not: each force multiplies its own by a vector. The preconditioner is a
/// multigrid cycle (multigrid/multigrid.h). Its coarse levels are rebuilt only when the number of
/// products of a solve has grown, for an old tangent often preconditions a new one well enough.
#ifndef BALLOON_SOLVE_LINEAR_SOLVE_H
#define BALLOON_SOLVE_LINEAR_SOLVE_H

#include "force/tangent.h"
#include "solve/group.h"
#include "solve/multigrid/multigrid.h"

typedef struct LinearSolve {
    Tangent tangent;       ///< A
    Multigrid levels;      ///< the preconditioner
    double levels_h;       ///< step for which the coarse levels were built [s]; 0: rebuild them
    int levels_age;        ///< tangents since the coarse levels were built
    int first_products;    ///< products of the first solve with these levels; 0: not known yet
    bool has_held;         ///< some particles do not move
    real4* residual;       ///< [count] r = -R - A dv
    real4* preconditioned; ///< [count] z, r after a multigrid cycle
    real4* direction;      ///< [count] p, search direction
    real4* image;          ///< [count] A p
} LinearSolve;

void linear_solve_open(LinearSolve* linear, Body* body);

/// Before a step: note whether some particles are held.
void linear_solve_begin(LinearSolve* linear, const Body* body);

/// Compute A of a group at the present positions and velocities. Returns an estimate of the rounding
/// error of R, as |R|_(1/M): positions and velocities are exact to half of their last bit, and K makes
/// forces of the positions' error, contacts impulses of the velocities'. Converged iterations reach 1/2 to 3/4 of it, in both precisions.
double linear_solve_update(Group* group, double h);

/// Solve A dv = -R to a residual of `tolerance` [1], in the preconditioner's norm. Where A is not
/// positive, K is replaced by its positive part, whose solution is a descent direction too. Adds
/// the number of products to *products.
void linear_solve_run(Group* group, double h, double tolerance, int* products);

void linear_solve_close(LinearSolve* linear);

#endif
