#include "force/inflation.h"

#include "base/vectors.h"
#include "force/force.h"
#include "force/sweep.h"
#include "mesh/measure.h"

/// The mass-spring paper's factor from k_normal to force [1].
static const double area_factor = 100;

static double pressure_of(const Inflation* inflation, double area, double volume) {
    switch (inflation->law) {
        case INFLATE_AREA:
            return area_factor * inflation->amount / area;
        case INFLATE_PRESSURE:
            return inflation->amount;
        case INFLATE_GAS:
            return gas_pressure(inflation, volume);
        default:
            return 0;
    }
}

double inflation_pressure(const Body* body) {
    const Inflation* inflation = &body->inflation;
    const bool gas = inflation->law == INFLATE_GAS;
    return pressure_of(inflation, measure_area(body->mesh, body->x),
                       gas ? measure_volume(body->mesh, body->x) : 0);
}

static bool present(const Body* body) {
    return body->inflation.law != INFLATE_NONE &&
           (body->inflation.amount != 0 || body->inflation.law == INFLATE_GAS);
}

static unsigned of_sweep(const Body* body) {
    static const unsigned sums[INFLATION_LAWS] = {
        [INFLATE_AREA] = SWEEP_AREA, [INFLATE_GAS] = SWEEP_VOLUME};
    return SWEEP_GRADIENT | sums[body->inflation.law];
}

static void uniform(const Body* body, Uniform* sum) {
    const Inflation* inflation = &body->inflation;
    sum->pressure += pressure_of(inflation, inflation->area, inflation->volume);
}

static double energy(const Body* body) {
    const Inflation* inflation = &body->inflation;
    const double volume = measure_volume(body->mesh, body->x);
    if (inflation->law == INFLATE_GAS)
        return gas_energy(inflation, volume);
    return -inflation_pressure(body) * volume;
}

/// d(p dV/dx)/dx = p d2V/dx2 + dV/dx (dp/dx)^T: a bound on each term, divided by the masses.
static double bound(const Body* body) {
    const Inflation* inflation = &body->inflation;
    const SweepBounds bounds = sweep_bounds(body);
    const SweepSums sums = bounds.sums;
    const double p = pressure_of(inflation, sums.area, sums.volume);
    const double stiff = fabs(p) * bounds.second;
    if (inflation->law == INFLATE_AREA)
        return stiff + fabs(p) / sums.area * sqrt(bounds.area2 * bounds.volume2);
    if (inflation->law == INFLATE_GAS)
        return stiff - gas_slope(inflation, sums.volume) * bounds.volume2;
    return stiff;
}

static Stencils stencils(const Body* body) {
    if (body->inflation.law == INFLATE_NONE)
        return (Stencils){0};
    return (Stencils){body->mesh->face_count, 4, (const int*)body->mesh->face};
}

/// The matrix of d -> factor d x a: columns (0 -a2 a1), (a2 0 -a0), (-a1 a0 0).
static inline Block crossed(real factor, real4 a) {
    a *= factor;
    const real4 m = -a; // spare lanes are zero
    return (Block){{__builtin_shufflevector(a, m, 3, 6, 1, 3),
                    __builtin_shufflevector(a, m, 2, 3, 4, 3),
                    __builtin_shufflevector(a, m, 5, 0, 3, 3)}};
}

static inline void add_block(Block* value, const Block* block) {
    for (int c = 0; c < 3; c++)
        value->column[c] += block->column[c];
}

/// Add a block at corners (i, j), and its negative at (j, i).
static inline void add_pair(Block* value, const int* block_at, int i, int j, const Block* block) {
    Block *there = &value[block_at[4 * i + j]], *across = &value[block_at[4 * j + i]];
    for (int c = 0; c < 3; c++) {
        there->column[c] += block->column[c];
        across->column[c] -= block->column[c];
    }
}

/// A triangle (a, b, c) of a closed skin. When a moves by d, dV/db changes by d x (b - c) / 6. The
/// face on the other side of the edge ab runs it backward, and contributes a term in -b there. So b
/// may be replaced by (a + b) / 2 in both faces without changing their sum:
///
///     d(dV/db) = d x ((a + b) / 2 - c) / 6
///
/// In this form the block at (b, a) is the negative of the one at (a, b), and the blocks at (a, a)
/// cancel in the sum over the faces around a.
static void assemble_triangle(const real4 x[3], real factor, const int* block_at, Block* value) {
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        const Block along = crossed(factor / 12, (x[a] - x[c]) + (x[b] - x[c]));
        add_pair(value, block_at, b, a, &along);
    }
}

/// A quad of a closed skin: the mean of its two triangulations. Along an edge, as above, with
/// (a + b - c - d) / 12; across the diagonal, dV/dc changes by d x (b - d) / 12 when a moves by d.
static void assemble_quad(const real4 x[4], real factor, const int* block_at, Block* value) {
    const real4 ac = x[0] - x[2], bd = x[1] - x[3];
    const Block along = crossed(factor / 12, ac + bd), aside = crossed(factor / 12, bd - ac);
    const Block by_b = crossed(factor / 12, bd), by_a = crossed(factor / 12, ac);
    add_pair(value, block_at, 1, 0, &along); // a + b - c - d
    add_pair(value, block_at, 2, 3, &along);
    add_pair(value, block_at, 2, 1, &aside); // b + c - d - a
    add_pair(value, block_at, 3, 0, &aside);
    add_pair(value, block_at, 2, 0, &by_b);
    add_pair(value, block_at, 1, 3, &by_a);
}

/// A triangle of an open skin: (b - a) x (c - a) / 6 at each corner, which changes by
/// d x (b - c) / 6 when a moves by d.
static void assemble_open_triangle(const real4 x[3], real factor, const int* block_at,
                                   Block* value) {
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        const Block block = crossed(factor / 6, x[b] - x[c]);
        add_block(&value[block_at[4 * a + a]], &block);
        add_block(&value[block_at[4 * b + a]], &block);
        add_block(&value[block_at[4 * c + a]], &block);
    }
}

/// A quad of an open skin: a quarter of its area vector (c - a) x (d - b) / 2 at each corner.
static void assemble_open_quad(const real4 x[4], real factor, const int* block_at, Block* value) {
    for (int a = 0; a < 4; a++) {
        const Block block = crossed(factor / 8, x[(a + 1) % 4] - x[(a + 3) % 4]);
        for (int k = 0; k < 4; k++)
            add_block(&value[block_at[4 * k + a]], &block);
    }
}

/// -p d2V/dx2, face by face; for `area` inflation at the frozen pressure, as its energy. It is
/// indefinite, so a projected tangent leaves it out.
static void assemble(const Body* body, double factor, bool project, const int* block_at,
                     BlockMatrix* matrix) {
    if (project)
        return;
    const Mesh* mesh = body->mesh;
    Block* value = matrix->value;
    const real p = (real)(-factor * body->inflation.pressure);
    for (int f = 0; f < mesh->face_count; f++, block_at += 16) {
        const int* face = mesh->face[f];
        real4 x[4];
        for (int k = 0; k < face_corners(face); k++)
            x[k] = body->x[face[k]];
        const bool triangle = face[3] == NONE;
        if (mesh->closed)
            (triangle ? assemble_triangle : assemble_quad)(x, p, block_at, value);
        else
            (triangle ? assemble_open_triangle : assemble_open_quad)(x, p, block_at, value);
    }
}

/// The share of the thin-shell paper's eq. 16, whose 1/27 should be 1/9. [1]
static const double paper_share = 1.0 / 3;

/// -dp/dV dV/dx (dV/dx . d), dense but of rank one: two sums.
static void product(const Body* body, double factor, const real4* d, real4* out) {
    const Inflation* inflation = &body->inflation;
    if (inflation->law != INFLATE_GAS)
        return;
    const double along = vectors()->dot(inflation->gradient, d, body->count);
    const real push = (real)(-factor * inflation->slope * along);
    vectors()->add(out, push, inflation->gradient, body->count);
}

static void update_tangent(Body* body, bool project) {
    (void)project;
    Inflation* inflation = &body->inflation;
    const SweepSums sums = sweep(body, of_sweep(body));
    inflation->pressure = pressure_of(inflation, sums.area, sums.volume);
    inflation->slope = inflation->law == INFLATE_GAS ? gas_slope(inflation, sums.volume) : 0;
    if (inflation->paper_tangent)
        inflation->slope *= paper_share;
}

const Force force_inflation = {
    .name = "inflation",
    .about = "pressure p dV/dx, laws area, pressure and gas",
    .present = present,
    .sweep = of_sweep,
    .uniform = uniform,
    .energy = energy,
    .bound = bound,
    .stencils = stencils,
    .assemble = assemble,
    .product = product,
    .update_tangent = update_tangent,
};
