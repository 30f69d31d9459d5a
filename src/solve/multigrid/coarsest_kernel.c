/// Compiled for each kind of machine: base/cpu.h.
#include "solve/multigrid/coarsest.h"

#define ALWAYS inline __attribute__((always_inline))

/// A row or column of a tile, whatever the machine's registers hold.
typedef real eight __attribute__((vector_size(LANES * sizeof(real))));

static ALWAYS eight load(const real* a) {
    eight v;
    __builtin_memcpy(&v, a, sizeof v);
    return v;
}

static ALWAYS void store(real* a, eight v) {
    __builtin_memcpy(a, &v, sizeof v);
}

/// The tile of a row of tiles and a column.
static ALWAYS Tile* tile_of(const Coarsest* coarsest, int c, int d) {
    return &coarsest->tile[coarsest->from[c] + d - coarsest->first[c]];
}

/// columns -= L_ce L_de^T, eight columns of eight rows; L_ce by columns
static ALWAYS void take_product(eight columns[LANES], const Tile* ce, const Tile* de) {
    for (int k = 0; k < LANES; k++) {
        const eight column = load(ce->row[k]);
        for (int s = 0; s < LANES; s++)
            columns[s] -= de->row[s][k] * column;
    }
}

/// columns = columns L_dd^-T
static ALWAYS void divide(eight columns[LANES], const Tile* dd, const real* inverse) {
    for (int s = 0; s < LANES; s++) {
        for (int k = 0; k < s; k++)
            columns[s] -= dd->row[s][k] * columns[k];
        columns[s] *= inverse[s];
    }
}

/// A pivot below this share of its diagonal is what rounding, in floats, may leave of none. [1]
static const real least = (real)1e-4;

/// L_cc in place of A_cc - …, by columns; of its diagonal, the inverse.
static ALWAYS void take_root(eight columns[LANES], const real* whole, real* inverse) {
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

static ALWAYS void turn(const Tile* tile, Tile* turned) {
    for (int s = 0; s < LANES; s++)
        for (int r = 0; r < LANES; r++)
            turned->row[s][r] = tile->row[r][s];
}

static void factor(Coarsest* coarsest) {
    for (int c = 0; c < coarsest->count; c++)
        for (int d = coarsest->first[c]; d <= c; d++) {
            Tile *tile = tile_of(coarsest, c, d), *turned = &coarsest->turned[d];
            turn(tile, turned);
            eight columns[LANES];
            real whole[LANES];
            for (int s = 0; s < LANES; s++) {
                columns[s] = load(turned->row[s]);
                whole[s] = tile->row[s][s];
            }
            const int from =
                coarsest->first[c] > coarsest->first[d] ? coarsest->first[c] : coarsest->first[d];
            for (int e = from; e < d; e++)
                take_product(columns, &coarsest->turned[e], tile_of(coarsest, d, e));
            if (d < c)
                divide(columns, tile_of(coarsest, d, d), &coarsest->inverse[d * LANES]);
            else
                take_root(columns, whole, &coarsest->inverse[c * LANES]);
            for (int s = 0; s < LANES; s++)
                store(turned->row[s], columns[s]);
            turn(turned, tile);
        }
}

/// In the order of the lanes, so that every machine rounds alike.
static ALWAYS real sum_of(eight a) {
    return ((a[0] + a[1]) + (a[2] + a[3])) + ((a[4] + a[5]) + (a[6] + a[7]));
}

/// y = L^-1 y
static ALWAYS void go_down(const Coarsest* coarsest, real* y) {
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
            real left = own[r] - sum_of(known[r]);
            for (int k = 0; k < r; k++)
                left -= tile->row[r][k] * own[k];
            own[r] = left * coarsest->inverse[c * LANES + r];
        }
    }
}

/// y = L^-T y, from the last.
static ALWAYS void go_up(const Coarsest* coarsest, real* y) {
    for (int c = coarsest->count - 1; c >= 0; c--) {
        const Tile* tile = tile_of(coarsest, c, c);
        eight left = load(&y[c * LANES]);
        real own[LANES];
        for (int s = LANES - 1; s >= 0; s--) {
            own[s] = left[s] * coarsest->inverse[c * LANES + s];
            left -= own[s] * load(tile->row[s]);
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
    go_down(coarsest, y);
    go_up(coarsest, y);
}

#ifdef KERNEL_V3
const CoarsestKernels coarsest_kernels_v3 = {factor, solve};
#else
const CoarsestKernels coarsest_kernels_baseline = {factor, solve};
#endif
