/// Compiled for each kind of machine: base/cpu.h.
#include "solve/multigrid/coarsest.h"

#define ALWAYS inline __attribute__((always_inline))

/// A row or column of a tile, in as many registers as the machine needs for it.
typedef real eight __attribute__((vector_size(LANES * sizeof(real))));

static ALWAYS eight load(const real* a) {
    eight v;
    __builtin_memcpy(&v, a, sizeof v);
    return v;
}

static ALWAYS void store(real* a, eight v) {
    __builtin_memcpy(a, &v, sizeof v);
}

/// The tile in row c and column d of tiles.
static ALWAYS Tile* tile_of(const Coarsest* coarsest, int c, int d) {
    return &coarsest->tile[coarsest->from[c] + d - coarsest->first[c]];
}

/// columns -= L_ce L_de^T; `ce` is transposed
static ALWAYS void subtract_product(eight columns[LANES], const Tile* ce, const Tile* de) {
    for (int k = 0; k < LANES; k++) {
        const eight column = load(ce->row[k]);
        for (int s = 0; s < LANES; s++)
            columns[s] -= de->row[s][k] * column;
    }
}

/// columns = columns L_dd^-T
static ALWAYS void solve_triangle(eight columns[LANES], const Tile* dd, const real* inverse) {
    for (int s = 0; s < LANES; s++) {
        for (int k = 0; k < s; k++)
            columns[s] -= dd->row[s][k] * columns[k];
        columns[s] *= inverse[s];
    }
}

/// A pivot that is a smaller share of A's diagonal element counts as zero: in float, rounding
/// errors alone can be as large. [1]
static const real pivot_share_min = (real)1e-4;

/// Replace the columns of A_cc - sum L_ce L_ce^T by those of L_cc; `inverse` gets 1 / its diagonal.
/// diagonal: A_cc's own.
static ALWAYS void factor_diagonal(eight columns[LANES], const real* diagonal, real* inverse) {
    for (int s = 0; s < LANES; s++) {
        const real pivot = columns[s][s];
        inverse[s] = pivot > pivot_share_min * diagonal[s] ? 1 / real_sqrt(pivot) : 0;
        for (int r = 0; r < s; r++)
            columns[s][r] = 0;
        columns[s] *= inverse[s];
        for (int k = s + 1; k < LANES; k++)
            columns[k] -= columns[s][k] * columns[s];
    }
}

static ALWAYS void transpose(const Tile* tile, Tile* transposed) {
    for (int s = 0; s < LANES; s++)
        for (int r = 0; r < LANES; r++)
            transposed->row[s][r] = tile->row[r][s];
}

static void factor(Coarsest* coarsest) {
    for (int c = 0; c < coarsest->count; c++)
        for (int d = coarsest->first[c]; d <= c; d++) {
            Tile *tile = tile_of(coarsest, c, d), *transposed = &coarsest->transposed[d];
            transpose(tile, transposed);
            eight columns[LANES];
            real diagonal[LANES];
            for (int s = 0; s < LANES; s++) {
                columns[s] = load(transposed->row[s]);
                diagonal[s] = tile->row[s][s];
            }
            const int from =
                coarsest->first[c] > coarsest->first[d] ? coarsest->first[c] : coarsest->first[d];
            for (int e = from; e < d; e++)
                subtract_product(columns, &coarsest->transposed[e], tile_of(coarsest, d, e));
            if (d < c)
                solve_triangle(columns, tile_of(coarsest, d, d), &coarsest->inverse[d * LANES]);
            else
                factor_diagonal(columns, diagonal, &coarsest->inverse[c * LANES]);
            for (int s = 0; s < LANES; s++)
                store(transposed->row[s], columns[s]);
            transpose(transposed, tile);
        }
}

/// Sum in a fixed order of the lanes, so that every machine rounds alike.
static ALWAYS real sum_of(eight a) {
    return ((a[0] + a[1]) + (a[2] + a[3])) + ((a[4] + a[5]) + (a[6] + a[7]));
}

/// y = L^-1 y
static ALWAYS void substitute_forward(const Coarsest* coarsest, real* y) {
    for (int c = 0; c < coarsest->count; c++) {
        const Tile* tile = tile_of(coarsest, c, coarsest->first[c]);
        eight known[LANES] = {{0}, {0}, {0}, {0}, {0}, {0}, {0}, {0}};
        for (int e = coarsest->first[c]; e < c; e++, tile++) {
            const eight above = load(&y[e * LANES]);
            for (int r = 0; r < LANES; r++)
                known[r] += load(tile->row[r]) * above;
        }
        real* own = &y[c * LANES];
        for (int r = 0; r < LANES; r++) {
            real rest = own[r] - sum_of(known[r]);
            for (int k = 0; k < r; k++)
                rest -= tile->row[r][k] * own[k];
            own[r] = rest * coarsest->inverse[c * LANES + r];
        }
    }
}

/// y = L^-T y
static ALWAYS void substitute_back(const Coarsest* coarsest, real* y) {
    for (int c = coarsest->count - 1; c >= 0; c--) {
        const Tile* tile = tile_of(coarsest, c, c);
        eight rest = load(&y[c * LANES]);
        real own[LANES];
        for (int s = LANES - 1; s >= 0; s--) {
            own[s] = rest[s] * coarsest->inverse[c * LANES + s];
            rest -= own[s] * load(tile->row[s]);
        }
        for (int s = 0; s < LANES; s++)
            y[c * LANES + s] = own[s];
        for (int e = c - 1; e >= coarsest->first[c]; e--) {
            tile--;
            eight above = load(&y[e * LANES]);
            for (int s = 0; s < LANES; s++)
                above -= own[s] * load(tile->row[s]);
            store(&y[e * LANES], above);
        }
    }
}

static void solve(const Coarsest* coarsest, real* y) {
    substitute_forward(coarsest, y);
    substitute_back(coarsest, y);
}

#ifdef KERNEL_V3
const CoarsestKernels coarsest_kernels_v3 = {factor, solve};
#else
const CoarsestKernels coarsest_kernels_baseline = {factor, solve};
#endif
