/// The matrix of projective dynamics, factored by CHOLMOD: the same for x, y and z,
///
///     A(h) = M + h C + h^2 L        mass, drag, and L the springs' and strings' stiffness as if
///                                   they had no length: k on two diagonals, -k between
///
/// It does not depend on positions, so it is factored once for a step h, and again only where h,
/// the drag or the strings change. Parts of a step have other h, any at all where balls are near:
/// they take the factors of h1 2^(-k/2), h1 the longest step so far, the next one above h. A(h) is
/// below that, so iterations still converge, by a half each at least. Springs that correction has
/// put to rest stay in the matrix, for the same reason.
///
/// Always in double, and simplicial: no BLAS, whose kernels differ from machine to machine.
#ifndef BALLOON_SOLVE_FACTOR_H
#define BALLOON_SOLVE_FACTOR_H

#include "body/body.h"

typedef struct Factor Factor;

Factor* factor_open(const Body* body);

/// Take the factors for steps h. False: none could be made. *made is how many were.
bool factor_take(Factor* factor, const Body* body, double h, int* made);

/// The right-hand side, [3][count]: all x, all y, all z.
double* factor_right(Factor* factor);

/// A^-1 times it, as long; good until the next call. NULL where CHOLMOD failed.
const double* factor_solve(Factor* factor);

void factor_close(Factor* factor);

#endif
