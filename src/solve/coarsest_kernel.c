/// Compiled for each kind of machine: base/cpu.h.
#include "solve/coarsest.h"

#define ALWAYS inline __attribute__((always_inline))

/// The tile of a row of tiles and a column.
static ALWAYS Tile* tile_of(const Coarsest* coarsest, int c, int d) {
    return &coarsest->tile[coarsest->from[c] + d - coarsest->first[c]];
}

/// columns -= L_ce L_de^T, eight columns of eight rows
static ALWAYS void take_product(lanes columns[LANES], const Tile* ce, const Tile* de) {
    for (int k = 0; k < LANES; k++) {
        const lanes column = lanes_load(ce->column[k]);
        for (int s = 0; s < LANES; s++)
            columns[s] -= de->row[s][k] * column;
    }
}

/// columns = columns L_dd^-T
static ALWAYS void divide(lanes columns[LANES], const Tile* dd, const real* inverse) {
    for (int s = 0; s < LANES; s++) {
        for (int k = 0; k < s; k++)
            columns[s] -= dd->row[s][k] * columns[k];
        columns[s] *= inverse[s];
    }
}

/// A pivot below this share of its diagonal is what rounding left of none. [1]
static const real least = (real)1e-4;

/// L_cc in place of A_cc - …, by columns; of its diagonal, the inverse.
static ALWAYS void take_root(lanes columns[LANES], const real* whole, real* inverse) {
    for (int s = 0; s < LANES; s++) {
        const real pivot = columns[s][s];
        inverse[s] = pivot > least * whole[s] ? 1 / real_sqrt(pivot) : 0;
        for (int r = 0; r < s; r++)
            columns[s][r] = 0;
        columns[s] *= inverse[s];
        for (int k = s + 1; k < LANES; k++)
            columns[k] -= columns[s][k] * columns[s];
    }
}

static ALWAYS void put(const lanes columns[LANES], Tile* tile) {
    for (int s = 0; s < LANES; s++)
        lanes_store(tile->column[s], columns[s]);
    for (int s = 0; s < LANES; s++)
        for (int r = 0; r < LANES; r++)
            tile->row[r][s] = tile->column[s][r];
}

static void factor(Coarsest* coarsest) {
    for (int c = 0; c < coarsest->count; c++)
        for (int d = coarsest->first[c]; d <= c; d++) {
            Tile* tile = tile_of(coarsest, c, d);
            lanes columns[LANES];
            real whole[LANES];
            for (int s = 0; s < LANES; s++) {
                columns[s] = lanes_load(tile->column[s]);
                whole[s] = tile->column[s][s];
            }
            const int from =
                coarsest->first[c] > coarsest->first[d] ? coarsest->first[c] : coarsest->first[d];
            for (int e = from; e < d; e++)
                take_product(columns, tile_of(coarsest, c, e), tile_of(coarsest, d, e));
            if (d < c)
                divide(columns, tile_of(coarsest, d, d), &coarsest->inverse[d * LANES]);
            else
                take_root(columns, whole, &coarsest->inverse[c * LANES]);
            put(columns, tile);
        }
}

/// y = L^-1 y: what is known of y goes into the next rows.
static ALWAYS void go_down(const Coarsest* coarsest, real* y) {
    for (int c = 0; c < coarsest->count; c++) {
        lanes left[4] = {lanes_load(&y[c * LANES])}; // four sums side by side
        const Tile* tile = tile_of(coarsest, c, coarsest->first[c]);
        for (int e = coarsest->first[c]; e < c; e++, tile++)
            for (int k = 0; k < LANES; k++)
                left[k % 4] -= y[e * LANES + k] * lanes_load(tile->column[k]);
        lanes rest = (left[0] + left[1]) + (left[2] + left[3]);
        const real* inverse = &coarsest->inverse[c * LANES];
        for (int s = 0; s < LANES; s++) {
            const real own = rest[s] * inverse[s];
            y[c * LANES + s] = own;
            rest -= own * lanes_load(tile->column[s]);
        }
    }
}

/// y = L^-T y, from the last.
static ALWAYS void go_up(const Coarsest* coarsest, real* y) {
    for (int c = coarsest->count - 1; c >= 0; c--) {
        const Tile* tile = tile_of(coarsest, c, c);
        const real* inverse = &coarsest->inverse[c * LANES];
        lanes rest = lanes_load(&y[c * LANES]);
        real own[LANES];
        for (int s = LANES - 1; s >= 0; s--) {
            own[s] = rest[s] * inverse[s];
            rest -= own[s] * lanes_load(tile->row[s]);
        }
        for (int s = 0; s < LANES; s++)
            y[c * LANES + s] = own[s];
        for (int e = c - 1; e >= coarsest->first[c]; e--) {
            tile--;
            lanes left = lanes_load(&y[e * LANES]);
            for (int s = 0; s < LANES; s++)
                left -= own[s] * lanes_load(tile->row[s]);
            lanes_store(&y[e * LANES], left);
        }
    }
}

static void solve(const Coarsest* coarsest, real* y) {
    go_down(coarsest, y);
    go_up(coarsest, y);
}

#ifdef KERNEL_V3
const CoarsestKernels coarsest_kernels_v3 = {factor, solve};
#else
const CoarsestKernels coarsest_kernels_baseline = {factor, solve};
#endif
