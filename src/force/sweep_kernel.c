/// Compiled for each kind of machine: base/cpu.h. Equations: sweep.h, uniform.h, springs.c.
#include "force/kernel.h"
#include "base/lanes.h"
#include "force/sweep.h"

#define ALWAYS inline __attribute__((always_inline))

/// Pull of springs along d [N]. A spring of no length pulls nowhere, for d is zero; the smallest
/// positive number keeps its ratio finite.
static ALWAYS Lanes3 pull_of(SpringLaw law, Lanes3 d, const real* stiffness, const real* rest) {
    const lanes r = lanes_load(rest) / lanes_sqrt(lanes3_dot(d, d) + REAL_MIN_POSITIVE);
    lanes share = 1 - r;
    if (law == LAW_RUBBER) {
        const lanes r3 = r * r * r;
        share = lanes_select(r < 1, (1 - r3 * r3) * ((real)1 / 6), share);
    }
    if (law == LAW_TENSION)
        share = lanes_select(r < 1, share, (lanes){0});
    return lanes3_times(lanes_load(stiffness) * share, d);
}

/// Where two slots hold the same particle: b and c of a face that is a triangle.
static ALWAYS lane_mask same_offset(const uint32_t* b, const uint32_t* c) {
    typedef uint32_t offsets __attribute__((vector_size(WIDE * sizeof(uint32_t))));
    offsets one, other;
    __builtin_memcpy(&one, b, sizeof one);
    __builtin_memcpy(&other, c, sizeof other);
    return __builtin_convertvector(one == other, lane_mask);
}

static const lanes none = {0};
enum { SWEEP_OPEN = 32 }; ///< the skin has a rim
enum { FACES = 8 };       ///< faces of a ring that are handled together: most rings have fewer

/// WIDE particles of a slice, from a lane on.
typedef struct Part {
    const Slices* s;
    int slice, lane;
    const real4* x;
    Lanes3 a; ///< positions [m]
} Part;

/// Positions of WIDE consecutive particles.
static ALWAYS Lanes3 positions_from(const Slices* s, size_t i) {
    return (Lanes3){lanes_load(&s->coordinate[0][i]), lanes_load(&s->coordinate[1][i]),
                    lanes_load(&s->coordinate[2][i])};
}

/// Vectors from the particles to their neighbors in a slot.
static ALWAYS Lanes3 neighbors(const Part* p, int slot) {
    const uint32_t* offset = &p->s->offset[slot][p->lane];
    const Lanes3 there = p->s->contiguous[slot] ? positions_from(p->s, offset[0] / sizeof(real4))
                                                : lanes3_gather(p->x, offset);
    return lanes3_minus(there, p->a);
}

/// Visit `count` slots: returns f plus the forces of their springs, and stores the vectors to the
/// neighbors in `at` if it is not NULL.
static ALWAYS Lanes3 visit_slots(const Part* p, int slot, int count, unsigned flags, SpringLaw law,
                                 Lanes3 f, Lanes3* at) {
    for (int k = slot; k < slot + count; k++) {
        const Lanes3 d = neighbors(p, k);
        if (at)
            at[k - slot] = d;
        if (flags & SWEEP_SPRINGS)
            f = lanes3_plus(f,
                            pull_of(law, d, &p->s->stiffness[k][p->lane], &p->s->rest[k][p->lane]));
    }
    return f;
}

/// Twice the area vector of the triangle between c, the b before and the b after.
static ALWAYS Lanes3 two_areas(const Lanes3* b) {
    return lanes3_cross(b[1], lanes3_minus(b[2], b[0]));
}

/// Add the faces' contributions to 12 dV/da [m^2]. at: b0 c0 b1 c1 ... and the b that closes the
/// last one
static ALWAYS Lanes3 gradient_of(const Part* p, int slot, int faces, const Lanes3* at,
                                 unsigned flags, Lanes3 sum) {
    for (int k = 0; k < 2 * faces; k += 2) {
        const Lanes3* b = &at[k];
        if (flags & SWEEP_OPEN) {
            const lane_mask triangle =
                same_offset(&p->s->offset[slot + k][p->lane], &p->s->offset[slot + k + 1][p->lane]);
            const lanes share = lanes_select(triangle, 2 + none, (real)1.5 + none);
            sum = lanes3_plus(sum, lanes3_times(share, two_areas(b)));
        } else {
            const Lanes3 across = lanes3_minus(b[2], b[0]);
            sum = lanes3_plus(sum, lanes3_cross(lanes3_plus(b[0], b[1]), across));
        }
    }
    return sum;
}

/// Add twice the area of the counted faces [m^2].
static ALWAYS lanes area_of(const Part* p, int counted, int faces, const Lanes3* at, lanes sum) {
    for (int k = 0; k < faces; k++) {
        const Lanes3 area = two_areas(&at[2 * k]);
        sum +=
            lanes_load(&p->s->counted[counted + k][p->lane]) * lanes_sqrt(lanes3_dot(area, area));
    }
    return sum;
}

/// Sums around each particle.
typedef struct Around {
    Lanes3 f;        ///< [N]
    Lanes3 gradient; ///< 12 times [m^2]
    lanes area;      ///< twice that of the faces that are counted there [m^2]
} Around;

/// Visit the faces around particles, and the springs to their corners. Returns the next slot.
static ALWAYS int visit_ring(const Part* p, unsigned flags, SpringLaw law, Around* around) {
    const Slices* s = p->s;
    const int faces = s->faces[p->slice], from = s->from[p->slice];
    const int counted = s->counted_from[p->slice];
    const int count = s->counted_from[p->slice + 1] - counted;
    Lanes3 at[2 * FACES + 1], first;
    for (int k = 0; k < faces; k += FACES) {
        const int slot = from + 2 * k, together = faces - k < FACES ? faces - k : FACES;
        around->f = visit_slots(p, slot, 2 * together, flags, law, around->f, at);
        if (!(flags & SWEEP_GRADIENT))
            continue;
        if (k == 0)
            first = at[0];
        at[2 * together] = k + together < faces ? neighbors(p, slot + 2 * together) : first;
        around->gradient = gradient_of(p, slot, together, at, flags, around->gradient);
        if (flags & SWEEP_AREA)
            around->area = area_of(p, counted + k, count - k < together ? count - k : together, at,
                                   around->area);
    }
    return from + 2 * faces;
}

/// Sum in the order of the lanes, so that every machine rounds alike.
static ALWAYS double sum_of(double4 a) {
    return a[0] + a[1] + a[2] + a[3];
}

static ALWAYS SweepSums sweep_slices(const Slices* s, int from, int to, const real4* restrict x,
                                     unsigned flags, bool clear, SpringLaw law, real4* restrict f,
                                     real4* restrict gradient) {
    double4 area = {0}, volume = {0};
    const Lanes3 origin = {x[0][0] + none, x[0][1] + none, x[0][2] + none};
    for (int i = from * LANES; i < to * LANES; i += WIDE) {
        const Part part = {s, i / LANES, lane_of(i), x, positions_from(s, (size_t)i)};
        Around around = {.area = {0}};
        if (flags & SWEEP_SPRINGS && !clear)
            around.f = lanes3_load(&f[i]);
        const int beside = visit_ring(&part, flags, law, &around);
        if (flags & SWEEP_SPRINGS) {
            const int remaining = s->from[part.slice + 1] - beside;
            around.f = visit_slots(&part, beside, remaining, flags, law, around.f, NULL);
            lanes3_store(&f[i], around.f);
        }
        if (flags & SWEEP_GRADIENT) {
            const Lanes3 g = lanes3_times((real)1 / 12 + none, around.gradient);
            lanes3_store(&gradient[i], g);
            lanes_sum(&area, around.area);
            if (flags & SWEEP_VOLUME)
                lanes_sum(&volume, lanes3_dot(lanes3_minus(part.a, origin), g));
        }
    }
    return (SweepSums){sum_of(area) / 2, sum_of(volume) / 3};
}

#define SWEEP(name, flags, law)                                                                    \
    static SweepSums name(const Slices* s, int from, int to, const real4* x, bool clear, real4* f, \
                          real4* gradient) {                                                       \
        return sweep_slices(s, from, to, x, flags, clear, law, f, gradient);                       \
    }
#define SWEEPS_OF(law_name, springs, law)                                                          \
    SWEEP(law_name##_gradient, springs | SWEEP_GRADIENT, law)                                      \
    SWEEP(law_name##_area, springs | SWEEP_GRADIENT | SWEEP_AREA, law)                             \
    SWEEP(law_name##_volume, springs | SWEEP_GRADIENT | SWEEP_VOLUME, law)                         \
    SWEEP(law_name##_open, springs | SWEEP_GRADIENT | SWEEP_AREA | SWEEP_OPEN, law)
SWEEP(hooke, SWEEP_SPRINGS, LAW_HOOKE)
SWEEP(rubber, SWEEP_SPRINGS, LAW_RUBBER)
SWEEP(tension, SWEEP_SPRINGS, LAW_TENSION)
SWEEPS_OF(hooke, SWEEP_SPRINGS, LAW_HOOKE)
SWEEPS_OF(rubber, SWEEP_SPRINGS, LAW_RUBBER)
SWEEPS_OF(tension, SWEEP_SPRINGS, LAW_TENSION)
SWEEPS_OF(alone, 0, LAW_HOOKE)

static SweepSums sweep_selected(const Slices* s, int from, int to, const real4* x, unsigned flags,
                                SpringLaw law, real4* f, real4* gradient) {
    static SweepSums (*const table[][5])(const Slices*, int, int, const real4*, bool, real4*,
                                         real4*) = {
        [LAW_HOOKE] = {hooke, hooke_gradient, hooke_area, hooke_volume, hooke_open},
        [LAW_RUBBER] = {rubber, rubber_gradient, rubber_area, rubber_volume, rubber_open},
        [LAW_TENSION] = {tension, tension_gradient, tension_area, tension_volume, tension_open},
        [SPRING_LAWS] = {NULL, alone_gradient, alone_area, alone_volume, alone_open},
    };
    const int row = flags & SWEEP_SPRINGS ? (int)law : SPRING_LAWS;
    const int column = !(flags & SWEEP_GRADIENT) ? 0
                       : s->open                 ? 4
                       : flags & SWEEP_AREA      ? 2
                       : flags & SWEEP_VOLUME    ? 3
                                                 : 1;
    return table[row][column](s, from, to, x, flags & SWEEP_CLEAR, f, gradient);
}

static void split(const real4* restrict x, int from, int to, real* const coordinate[3]) {
    for (int i = from; i < to; i += WIDE) {
        const Lanes3 a = lanes3_load(&x[i]);
        lanes_store(&coordinate[0][i], a.x);
        lanes_store(&coordinate[1][i], a.y);
        lanes_store(&coordinate[2][i], a.z);
    }
}

static ALWAYS lanes length_of(Lanes3 a) {
    return lanes_sqrt(lanes3_dot(a, a));
}

/// A quad's row sum is (2 (ac + bd) + ab + ad + bd) / 12, a triangle's (ab + ad + bd) / 6, and its
/// |dA/da| is bd / 2.
static SweepBounds bounds(const Slices* s, int from, int to, const real4* restrict x,
                          const real* restrict inverse_mass) {
    lanes second = none;
    double4 area2 = {0}, volume2 = {0}, areas = {0}, volume = {0};
    const Lanes3 origin = {x[0][0] + none, x[0][1] + none, x[0][2] + none};
    for (int i = from * LANES; i < to * LANES; i += WIDE) {
        const int slice = i / LANES, lane = lane_of(i);
        const Lanes3 a = lanes3_load(&x[i]);
        const lanes w = lanes_load(&inverse_mass[i]);
        Lanes3 g = {{0}, {0}, {0}};
        lanes corners = none;
        uint32_t own[WIDE];
        for (int k = 0; k < WIDE; k++)
            own[k] = (uint32_t)((size_t)(i + k) * sizeof(real4));
        lanes rows = none, area = none;
        const uint32_t(*offset)[LANES] = (const uint32_t(*)[LANES]) & s->offset[s->from[slice]];
        const Lanes3 first = lanes3_minus(lanes3_gather(x, &offset[0][lane]), a);
        Lanes3 b = first;
        lanes ab = length_of(b);
        for (int k = s->faces[slice]; k > 0; k--, offset += 2) {
            const Lanes3 c = lanes3_minus(lanes3_gather(x, &offset[1][lane]), a);
            const Lanes3 d = k > 1 ? lanes3_minus(lanes3_gather(x, &offset[2][lane]), a) : first;
            const Lanes3 across = lanes3_minus(d, b), twice = lanes3_cross(c, across);
            const lanes ac = length_of(c), ad = length_of(d), bd = length_of(across);
            const lane_mask triangle = same_offset(&offset[0][lane], &offset[1][lane]);
            const lane_mask is = ~same_offset(own, &offset[1][lane]);
            const lanes three = ab + ad + bd;
            const lanes row = lanes_select(triangle, 2 * three, 2 * (ac + bd) + three);
            rows += lanes_select(is, row, none);
            area += lanes_select(is, bd, none);
            const lanes share = lanes_select(triangle, (real)4 / 3 + none, 1 + none);
            corners += share * length_of(twice);
            g = lanes3_plus(g, s->open ? lanes3_times((real)1.5 * share, twice)
                                       : lanes3_cross(lanes3_plus(b, c), across));
            b = d;
            ab = ad;
        }
        second = lanes_max(second, rows * w);
        lanes_sum(&area2, area * area * w);
        lanes_sum(&volume2, lanes3_dot(g, g) * w);
        lanes_sum(&areas, corners);
        lanes_sum(&volume, lanes3_dot(lanes3_minus(a, origin), g));
    }
    SweepBounds sum = {.area2 = sum_of(area2) / 4,
                       .volume2 = sum_of(volume2) / 144,
                       .sums = {sum_of(areas) / 8, sum_of(volume) / 36}};
    for (int k = 0; k < WIDE; k++)
        sum.second = fmax(sum.second, (double)second[k] / 12);
    return sum;
}

/// mass: NULL where nothing is proportional to it.
static ALWAYS void add_uniform(const Uniform* uniform, int from, int to,
                               const real4* restrict gradient, const real* restrict mass,
                               const real* restrict inverse_mass, real h, real4* restrict v,
                               real4* restrict f) {
    const lanes a = lanes_repeat(uniform->acceleration);
    const real p = (real)uniform->pressure;
    const real drag = (real)uniform->drag, rate = (real)uniform->rate;
    for (int i = from; i < to; i += VECTORS) {
        real *const vi = (real*)&v[i], *const fi = (real*)&f[i];
        const lanes now = lanes_load(vi);
        lanes sum = lanes_load(fi);
        if (mass) {
            const lanes m = lanes_each(&mass[i]);
            sum = sum + m * a - (drag + rate * m) * now;
        } else {
            sum -= drag * now;
        }
        if (gradient)
            sum += p * lanes_load((const real*)&gradient[i]);
        lanes_store(fi, sum);
        if (h > 0)
            lanes_store(vi, now + (h * lanes_each(&inverse_mass[i])) * sum);
    }
}

static void add_uniform_selected(const Uniform* uniform, int from, int to, const real4* gradient,
                                 const real* mass, const real* inverse_mass, real h, real4* v,
                                 real4* f) {
    const real4 a = uniform->acceleration;
    const bool by_mass = uniform->rate != 0 || a[0] != 0 || a[1] != 0 || a[2] != 0;
    if (by_mass && gradient)
        add_uniform(uniform, from, to, gradient, mass, inverse_mass, h, v, f);
    else if (by_mass)
        add_uniform(uniform, from, to, NULL, mass, inverse_mass, h, v, f);
    else if (gradient)
        add_uniform(uniform, from, to, gradient, NULL, inverse_mass, h, v, f);
    else
        add_uniform(uniform, from, to, NULL, NULL, inverse_mass, h, v, f);
}

#ifdef KERNEL_V3
const Kernels kernels_v3 = {split, sweep_selected, bounds, add_uniform_selected};
#else
const Kernels kernels_baseline = {split, sweep_selected, bounds, add_uniform_selected};
#endif
