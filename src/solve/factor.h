/// The matrix of projective dynamics, factored by CHOLMOD: one matrix for x, y and z,
///
///     A(h) = M + h C + h^2 L        M mass, C drag, L the graph Laplacian of springs and strings:
///                                   stiffness k on two diagonal entries, -k on the two between
///
/// It does not depend on positions, so it is factored once for a step h, and again only when h, the
/// drag or the strings change. Substeps have other h, of any length where balls are near. They use
/// the factors of the next longer step h1 2^(-k/2), h1 the longest step so far. That matrix is at
/// least A(h) and at most twice A(h), so iterations still converge, by a factor of 1/2 or better
/// each. Springs that strain limiting has put to rest stay in the matrix, for the same reason.
///
/// Always in double, and simplicial: no BLAS, whose kernels differ from machine to machine.
#ifndef BALLOON_SOLVE_FACTOR_H
#define BALLOON_SOLVE_FACTOR_H

#include "body/body.h"

typedef struct Factor Factor;

Factor* factor_open(const Body* body);

/// Select the factors for steps h. False: CHOLMOD failed. *made is the number of new factors.
bool factor_select(Factor* factor, const Body* body, double h, int* made);

/// The right-hand side, [3][count]: all x, all y, all z.
double* factor_right(Factor* factor);

/// A^-1 times the right-hand side, [3][count]; valid until the next call. NULL: CHOLMOD failed.
const double* factor_solve(Factor* factor);

void factor_close(Factor* factor);

#endif
