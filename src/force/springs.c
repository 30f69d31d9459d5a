/// Structural, shear and flexion springs. With d the vector between a spring's ends, |d| its length
/// and r = rest / |d|, the pull along d per length is
///
///     hooke    k (1 - r)              E = k (|d| - rest)^2 / 2
///     rubber   k (1 - r^6) / 6        E = k/6 (|d|^2 / 2 + rest^2 r^4 / 4 - 3 rest^2 / 4)
///     tension  hooke, 0 for r > 1     E of hooke, 0 for r > 1
///
/// rubber is the equibiaxial neo-Hookean law of a membrane, slope k at rest; in compression, where
/// its tangent would grow without bound, it is Hooke's, so that the stability bound holds. tension
/// is a foil's: under compression it has no force, as if it wrinkled more finely than the mesh. The
/// forces on the two ends are exactly opposite, so momentum changes by the rounding of sums only.
#include "force/force.h"
#include "force/sweep.h"

static bool present(const Body* body) {
    return body->springs.count > 0;
}

/// rest / length; a spring of no length pulls nowhere, for d is zero.
static inline real ratio(real rest, real now) {
    return now > 0 ? rest / now : 0;
}

static unsigned of_sweep(const Body* body) {
    (void)body;
    return SWEEP_SPRINGS;
}

static double energy(const Body* body) {
    const Springs* springs = &body->springs;
    double sum = 0;
    for (int s = 0; s < springs->count; s++) {
        const int* end = springs->end[s];
        const double k = (double)springs->active[s], rest = (double)springs->rest[s];
        const double now = dlength(to_double4(body->x[end[1]]) - to_double4(body->x[end[0]]));
        if (springs->law == LAW_TENSION && now <= rest)
            continue;
        if (springs->law != LAW_RUBBER || now <= rest) {
            sum += 0.5 * k * (now - rest) * (now - rest);
        } else {
            const double r2 = rest * rest / (now * now);
            sum += k / 6 * (now * now / 2 + rest * rest * (r2 * r2 / 4 - 0.75));
        }
    }
    return sum;
}

static double bound(const Body* body) {
    return body->springs.bound;
}

/// Tangent of a spring: stiffness along its direction and across it.
typedef struct Resistance {
    real along, across; ///< [N/m]
} Resistance;

static Resistance resistance_of(SpringLaw law, real stiffness, real r) {
    if (law == LAW_TENSION && r >= 1)
        return (Resistance){0};
    if (law != LAW_RUBBER || r >= 1)
        return (Resistance){stiffness, stiffness * (1 - r)};
    const real r3 = r * r * r, r6 = r3 * r3;
    return (Resistance){stiffness * (1 + 5 * r6) / 6, stiffness * (1 - r6) / 6};
}

static Stencils stencils(const Body* body) {
    return (Stencils){body->springs.count, 2, (const int*)body->springs.end};
}

static void assemble(const Body* body, double factor, bool project, const int* block_at,
                     BlockMatrix* matrix) {
    const Springs* springs = &body->springs;
    Block* restrict value = matrix->value;
    for (int s = 0; s < springs->count; s++) {
        const int* end = springs->end[s];
        const real4 span = body->x[end[1]] - body->x[end[0]];
        const real now = length(span);
        if (!(now > 0))
            continue;
        Resistance k =
            resistance_of(springs->law, springs->active[s], ratio(springs->rest[s], now));
        if (project) // a compressed spring has negative stiffness across
            k.across = real_max(k.across, 0);
        const real4 n = span / now;
        for (int c = 0; c < 3; c++) {
            real4 column = ((real)factor * (k.along - k.across) * n[c]) * n;
            column[c] += (real)factor * k.across;
            value[block_at[4 * s]].column[c] += column;
            value[block_at[4 * s + 1]].column[c] -= column;
            value[block_at[4 * s + 2]].column[c] -= column;
            value[block_at[4 * s + 3]].column[c] += column;
        }
    }
}

const Force force_springs = {
    .name = "springs",
    .about = "structural, shear and flexion springs, laws hooke and rubber",
    .present = present,
    .sweep = of_sweep,
    .energy = energy,
    .bound = bound,
    .stencils = stencils,
    .assemble = assemble,
    .elastic = true,
};
