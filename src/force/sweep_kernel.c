/// Compiled for each kind of machine: base/cpu.h. Equations: sweep.h, uniform.h, springs.c.
#include "force/kernel.h"
#include "force/sweep.h"

#define ALWAYS inline __attribute__((always_inline))

/// Pull of eight springs along d [N]. A spring of no length pulls nowhere, for d is zero; the least
/// number keeps its ratio finite.
static ALWAYS Lanes3 pull_of(SpringLaw law, Lanes3 d, const real* stiffness, const real* rest) {
    const lanes r = lanes_load(rest) / lanes_sqrt(lanes3_dot(d, d) + REAL_LEAST);
    lanes share = 1 - r;
    if (law == LAW_RUBBER) {
        const lanes r3 = r * r * r;
        share = lanes_select(r < 1, (1 - r3 * r3) * ((real)1 / 6), share);
    }
    if (law == LAW_TENSION)
        share = lanes_select(r < 1, share, (lanes){0});
    return lanes3_times(lanes_load(stiffness) * share, d);
}

/// Which of eight places are the same: of b and c, faces that are triangles.
static ALWAYS lane_mask same_place(const uint32_t* b, const uint32_t* c) {
    typedef uint32_t places __attribute__((vector_size(LANES * sizeof(uint32_t))));
    places one, other;
    __builtin_memcpy(&one, b, sizeof one);
    __builtin_memcpy(&other, c, sizeof other);
    return __builtin_convertvector(one == other, lane_mask);
}

static const lanes none = {0};
enum { SWEEP_OPEN = 32 }; ///< the skin has a rim
enum { FACES = 8 };       ///< of a ring, looked at together: most rings have fewer

/// Eight particles that follow each other.
static ALWAYS Lanes3 row_from(const Slices* s, size_t i) {
    return (Lanes3){lanes_load(&s->line[0][i]), lanes_load(&s->line[1][i]),
                    lanes_load(&s->line[2][i])};
}

/// The neighbours in a slot.
static ALWAYS Lanes3 neighbours(const Slices* s, int slot, const real4* x) {
    return s->row[slot] ? row_from(s, s->place[slot][0] / sizeof(real4))
                        : lanes3_gather(x, s->place[slot]);
}

/// Neighbours of eight particles at a, from a slot on: where they are as seen from a, into `at` if
/// it is not NULL. Returns f and the springs' pull to them.
static ALWAYS Lanes3 look_around(const Slices* s, int slot, int count, const real4* restrict x,
                                 Lanes3 a, unsigned wanted, SpringLaw law, Lanes3 f, Lanes3* at) {
    for (int k = 0; k < count; k++) {
        const Lanes3 d = lanes3_minus(neighbours(s, slot + k, x), a);
        if (at)
            at[k] = d;
        if (wanted & SWEEP_SPRINGS)
            f = lanes3_plus(f, pull_of(law, d, s->stiffness[slot + k], s->rest[slot + k]));
    }
    return f;
}

/// Twice the area vector of the triangle between c, the b before and the b after.
static ALWAYS Lanes3 two_areas(const Lanes3* b) {
    return lanes3_cross(b[1], lanes3_minus(b[2], b[0]));
}

/// What faces add to 12 dV/da [m^2]. at: b0 c0 b1 c1 ... and the b that closes the last one
static ALWAYS Lanes3 gradient_of(const Slices* s, int slot, int faces, const Lanes3* at,
                                 unsigned wanted, Lanes3 sum) {
    for (int k = 0; k < 2 * faces; k += 2) {
        const Lanes3* b = &at[k];
        if (wanted & SWEEP_OPEN) {
            const lane_mask triangle = same_place(s->place[slot + k], s->place[slot + k + 1]);
            const lanes share = lanes_select(triangle, 2 + none, (real)1.5 + none);
            sum = lanes3_plus(sum, lanes3_times(share, two_areas(b)));
        } else {
            const Lanes3 across = lanes3_minus(b[2], b[0]);
            sum = lanes3_plus(sum, lanes3_cross(lanes3_plus(b[0], b[1]), across));
        }
    }
    return sum;
}

/// Twice the area of the faces that are counted [m^2].
static ALWAYS lanes area_of(const Slices* s, int counted, int faces, const Lanes3* at, lanes sum) {
    for (int k = 0; k < faces; k++) {
        const Lanes3 area = two_areas(&at[2 * k]);
        sum += lanes_load(s->counted[counted + k]) * lanes_sqrt(lanes3_dot(area, area));
    }
    return sum;
}

/// What is summed up around eight particles.
typedef struct Around {
    Lanes3 f;        ///< [N]
    Lanes3 gradient; ///< 12 times [m^2]
    lanes area;      ///< twice that of the faces that are counted there [m^2]
} Around;

/// The faces around eight particles at a, and the springs to their corners. Returns the next slot.
static ALWAYS int go_round(const Slices* s, int slice, const real4* x, Lanes3 a, unsigned wanted,
                           SpringLaw law, Around* around) {
    const int faces = s->faces[slice], from = s->from[slice];
    const int counted = s->counted_from[slice], count = s->counted_from[slice + 1] - counted;
    Lanes3 at[2 * FACES + 1], first;
    for (int k = 0; k < faces; k += FACES) {
        const int slot = from + 2 * k, together = faces - k < FACES ? faces - k : FACES;
        around->f = look_around(s, slot, 2 * together, x, a, wanted, law, around->f, at);
        if (!(wanted & SWEEP_GRADIENT))
            continue;
        if (k == 0)
            first = at[0];
        at[2 * together] = k + together < faces
                               ? lanes3_minus(lanes3_gather(x, s->place[slot + 2 * together]), a)
                               : first;
        around->gradient = gradient_of(s, slot, together, at, wanted, around->gradient);
        if (wanted & SWEEP_AREA)
            around->area = area_of(s, counted + k, count - k < together ? count - k : together, at,
                                   around->area);
    }
    return from + 2 * faces;
}

/// Sums of eight lanes in double; lanes a and a + 4 together.
static ALWAYS double4 to_sums(lanes a) {
    return to_double4(lanes_low(a)) + to_double4(lanes_high(a));
}

/// In the order of the lanes, so that every machine rounds alike.
static ALWAYS double sum_of(double4 a) {
    return a[0] + a[1] + a[2] + a[3];
}

static ALWAYS SweepSums sweep_slices(const Slices* s, int from, int to, const real4* restrict x,
                                     unsigned wanted, bool clear, SpringLaw law, real4* restrict f,
                                     real4* restrict gradient) {
    double4 area = {0}, volume = {0};
    const Lanes3 origin = {x[0][0] + none, x[0][1] + none, x[0][2] + none};
    for (int slice = from; slice < to; slice++) {
        const int i = slice * LANES;
        const Lanes3 a = row_from(s, (size_t)i);
        Around around = {.area = {0}};
        if (wanted & SWEEP_SPRINGS && !clear)
            around.f = lanes3_load(&f[i]);
        const int beside = go_round(s, slice, x, a, wanted, law, &around);
        if (wanted & SWEEP_SPRINGS) {
            const int left = s->from[slice + 1] - beside;
            around.f = look_around(s, beside, left, x, a, wanted, law, around.f, NULL);
            lanes3_store(&f[i], around.f);
        }
        if (wanted & SWEEP_GRADIENT) {
            const Lanes3 g = lanes3_times((real)1 / 12 + (lanes){0}, around.gradient);
            lanes3_store(&gradient[i], g);
            area += to_sums(around.area);
            if (wanted & SWEEP_VOLUME)
                volume += to_sums(lanes3_dot(lanes3_minus(a, origin), g));
        }
    }
    return (SweepSums){sum_of(area) / 2, sum_of(volume) / 3};
}

#define SWEEP(name, wanted, law)                                                                   \
    static SweepSums name(const Slices* s, int from, int to, const real4* x, bool clear, real4* f, \
                          real4* gradient) {                                                       \
        return sweep_slices(s, from, to, x, wanted, clear, law, f, gradient);                      \
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

static SweepSums sweep_wanted(const Slices* s, int from, int to, const real4* x, unsigned wanted,
                              SpringLaw law, real4* f, real4* gradient) {
    static SweepSums (*const table[][5])(const Slices*, int, int, const real4*, bool, real4*,
                                         real4*) = {
        [LAW_HOOKE] = {hooke, hooke_gradient, hooke_area, hooke_volume, hooke_open},
        [LAW_RUBBER] = {rubber, rubber_gradient, rubber_area, rubber_volume, rubber_open},
        [LAW_TENSION] = {tension, tension_gradient, tension_area, tension_volume, tension_open},
        [SPRING_LAWS] = {NULL, alone_gradient, alone_area, alone_volume, alone_open},
    };
    const int row = wanted & SWEEP_SPRINGS ? (int)law : SPRING_LAWS;
    const int column = !(wanted & SWEEP_GRADIENT) ? 0
                       : s->open                  ? 4
                       : wanted & SWEEP_AREA      ? 2
                       : wanted & SWEEP_VOLUME    ? 3
                                                  : 1;
    return table[row][column](s, from, to, x, wanted & SWEEP_CLEAR, f, gradient);
}

static void split(const real4* restrict x, int from, int to, real* const line[3]) {
    for (int i = from; i < to; i += LANES) {
        const Lanes3 a = lanes3_load(&x[i]);
        lanes_store(&line[0][i], a.x);
        lanes_store(&line[1][i], a.y);
        lanes_store(&line[2][i], a.z);
    }
}

static ALWAYS lanes length_of(Lanes3 a) {
    return lanes_sqrt(lanes3_dot(a, a));
}

/// A quad's row sum is (2 (ac + bd) + ab + ad + bd) / 12, a triangle's (ab + ad + bd) / 6, and its
/// |dA/da| is bd / 2.
static SweepSteep steep(const Slices* s, int from, int to, const real4* restrict x,
                        const real4* restrict gradient, const real* restrict inverse_mass) {
    lanes second = none;
    double4 area2 = {0}, volume2 = {0};
    for (int slice = from; slice < to; slice++) {
        const int i = slice * LANES;
        const Lanes3 a = lanes3_load(&x[i]), g = lanes3_load(&gradient[i]);
        const lanes w = lanes_load(&inverse_mass[i]);
        uint32_t own[LANES];
        for (int k = 0; k < LANES; k++)
            own[k] = (uint32_t)((size_t)(i + k) * sizeof(real4));
        lanes rows = none, area = none;
        int slot = s->from[slice];
        const Lanes3 first = lanes3_minus(lanes3_gather(x, s->place[slot]), a);
        Lanes3 b = first;
        lanes ab = length_of(b);
        for (int k = s->faces[slice]; k > 0; k--, slot += 2) {
            const Lanes3 c = lanes3_minus(lanes3_gather(x, s->place[slot + 1]), a);
            const Lanes3 d = k > 1 ? lanes3_minus(lanes3_gather(x, s->place[slot + 2]), a) : first;
            const lanes ac = length_of(c), ad = length_of(d), bd = length_of(lanes3_minus(d, b));
            const lane_mask triangle = same_place(s->place[slot], s->place[slot + 1]);
            const lane_mask is = ~same_place(own, s->place[slot + 1]);
            const lanes three = ab + ad + bd;
            const lanes row = lanes_select(triangle, 2 * three, 2 * (ac + bd) + three);
            rows += lanes_select(is, row, none);
            area += lanes_select(is, bd, none);
            b = d;
            ab = ad;
        }
        second = lanes_higher(second, rows * w);
        area2 += to_sums(area * area * w);
        volume2 += to_sums(lanes3_dot(g, g) * w);
    }
    SweepSteep sum = {0, sum_of(area2) / 4, sum_of(volume2)};
    for (int k = 0; k < LANES; k++)
        sum.second = fmax(sum.second, (double)second[k] / 12);
    return sum;
}

/// Two particles side by side.
static ALWAYS lanes both(const real* a) {
    const real4 low = {a[0], a[0], a[0], a[0]}, high = {a[1], a[1], a[1], a[1]};
    return lanes_join(low, high);
}

static ALWAYS void add_uniform(const Uniform* uniform, int from, int to,
                               const real4* restrict gradient, const real* restrict mass,
                               const real* restrict inverse_mass, real h, real4* restrict v,
                               real4* restrict f) {
    const lanes a = lanes_join(uniform->acceleration, uniform->acceleration);
    const real p = (real)uniform->pressure;
    const real drag = (real)uniform->drag, rate = (real)uniform->rate;
    for (int i = from; i < to; i += 2) {
        real *const vi = (real*)&v[i], *const fi = (real*)&f[i];
        const lanes m = both(&mass[i]), now = lanes_load(vi);
        lanes sum = lanes_load(fi) + m * a - (drag + rate * m) * now;
        if (gradient)
            sum += p * lanes_load((const real*)&gradient[i]);
        lanes_store(fi, sum);
        if (h > 0)
            lanes_store(vi, now + (h * both(&inverse_mass[i])) * sum);
    }
}

static void add_uniform_wanted(const Uniform* uniform, int from, int to, const real4* gradient,
                               const real* mass, const real* inverse_mass, real h, real4* v,
                               real4* f) {
    if (!gradient)
        add_uniform(uniform, from, to, NULL, mass, inverse_mass, h, v, f);
    else
        add_uniform(uniform, from, to, gradient, mass, inverse_mass, h, v, f);
}

#ifdef KERNEL_V3
const Kernels kernels_v3 = {split, sweep_wanted, steep, add_uniform_wanted};
#else
const Kernels kernels_baseline = {split, sweep_wanted, steep, add_uniform_wanted};
#endif
