/// Compiled for each kind of machine: base/cpu.h.
#include "base/lanes.h"
#include "constraint/volume_constraint.h"

#define EACH static inline __attribute__((always_inline))

EACH lanes_double to_lanes_double(lanes a) {
    return __builtin_convertvector(a, lanes_double);
}

EACH lanes to_lanes(lanes_double a) {
    return __builtin_convertvector(a, lanes);
}

EACH lanes_double load_double(const double* a) {
    lanes_double v;
    __builtin_memcpy(&v, a, sizeof v);
    return v;
}

/// Sum in the order of the lanes, so that every machine rounds alike.
EACH double sum_of(const lanes_double a[LANES / WIDE]) {
    double sum = 0;
    for (int k = 0; k < LANES; k++)
        sum += a[k / WIDE][k % WIDE];
    return sum;
}

/// Elements side by side: their corners, edges and normals. Displacements of a pass may be far
/// below the last bit of a position.
typedef struct Elements {
    const uint32_t* corner[3];
    Lanes3 ab, ac, normal;
    lanes twice;  ///< twice the areas
    lanes weight; ///< of the virtual vertices: half of the elements' rubber
} Elements;

EACH Lanes3 edges(const VolumeConstraint* preserve, const real4* x, const uint32_t* from,
                  const uint32_t* to) {
    return lanes3_plus(
        lanes3_minus(lanes3_gather(x, to), lanes3_gather(x, from)),
        lanes3_minus(lanes3_gather(preserve->moved, to), lanes3_gather(preserve->moved, from)));
}

EACH Elements elements_of(const Membrane* membrane, const VolumeConstraint* preserve,
                          const real4* x, int n) {
    Elements e;
    for (int k = 0; k < 3; k++)
        e.corner[k] = &membrane->lane_corner[n / LANES][k][lane_of(n)];
    e.ab = edges(preserve, x, e.corner[0], e.corner[1]);
    e.ac = edges(preserve, x, e.corner[0], e.corner[2]);
    e.normal = lanes3_cross(e.ab, e.ac);
    e.twice = lanes_sqrt(lanes3_dot(e.normal, e.normal));
    const lanes rubber = lanes_load(&membrane->lane_rest[n / LANES][3][lane_of(n)]);
    e.weight = lanes_select(rubber > 0, 2 / ((real)membrane->rubber.density * rubber), (lanes){0});
    return e;
}

/// One element after the other, so that the sums have one order.
EACH void scatter(real4* to, const uint32_t* const corner[3], Lanes3 a, Lanes3 b, Lanes3 c) {
    real4 at[3][WIDE];
    lanes3_store(at[0], a);
    lanes3_store(at[1], b);
    lanes3_store(at[2], c);
    for (int k = 0; k < WIDE; k++)
        for (int i = 0; i < 3; i++)
            *(real4*)((char*)to + corner[i][k]) += at[i][k];
}

static double volume(const Membrane* membrane, const VolumeConstraint* preserve, const real4* x,
                     double* sum) {
    lanes_double all[LANES / WIDE] = {{0}}, weighed[LANES / WIDE] = {{0}};
    for (int n = 0; n < membrane->eights * LANES; n += WIDE) {
        const Elements e = elements_of(membrane, preserve, x, n);
        const lanes_double half = load_double(&preserve->share[n]) / 2;
        const lanes_double thickness = load_double(&preserve->thickness[n]);
        const int part = lane_of(n) / WIDE;
        all[part] += half * thickness * to_lanes_double(e.twice);

        const lanes by_top = to_lanes(half) * e.twice;
        weighed[part] += to_lanes_double(e.weight * by_top * by_top);
        const Lanes3 up = lanes3_times(to_lanes(half) * to_lanes(thickness) / e.twice, e.normal);
        const Lanes3 by_b = lanes3_cross(e.ac, up), by_c = lanes3_cross(up, e.ab);
        const Lanes3 middle = lanes3_times(to_lanes(half) / 3, e.normal); // c moves under x4
        const Lanes3 none = {{0}, {0}, {0}};
        scatter(preserve->gradient, e.corner,
                lanes3_minus(none, lanes3_plus(lanes3_plus(by_b, by_c), middle)),
                lanes3_minus(by_b, middle), lanes3_minus(by_c, middle));
    }
    *sum += sum_of(weighed);
    return sum_of(all);
}

static void rise(const Membrane* membrane, VolumeConstraint* preserve, const real4* x,
                 real lambda) {
    for (int n = 0; n < membrane->eights * LANES; n += WIDE) {
        const Elements e = elements_of(membrane, preserve, x, n);
        const Lanes3 da = lanes3_gather(preserve->gradient, e.corner[0]);
        const Lanes3 db = lanes3_minus(lanes3_gather(preserve->gradient, e.corner[1]), da);
        const Lanes3 dc = lanes3_minus(lanes3_gather(preserve->gradient, e.corner[2]), da);
        const Lanes3 turn =
            lanes3_plus(lanes3_cross(e.ab, dc), lanes3_cross(db, lanes3_plus(e.ac, dc)));
        const Lanes3 after = lanes3_plus(e.normal, turn), across = lanes3_cross(e.normal, turn);
        const lanes square = lanes3_dot(after, after);
        const lanes sine = lanes3_dot(across, across) / (e.twice * e.twice * square); // squared
        const lanes top = lambda * e.weight * to_lanes(load_double(&preserve->share[n]) / 2);
        const lanes up = lanes3_dot(lanes3_plus(e.ab, e.ac), turn) / 3 - lanes3_dot(da, after) +
                         top * lanes3_dot(e.normal, after);
        double* thickness = &preserve->thickness[n];
        lanes_double h = load_double(thickness);
        h += to_lanes_double(up / lanes_sqrt(square)) -
             h * to_lanes_double(sine / (1 + lanes_sqrt(1 - sine)));
        __builtin_memcpy(thickness, &h, sizeof h);
    }
}

#ifdef KERNEL_V3
const PreserveKernels volume_constraint_kernels_v3 = {volume, rise};
#else
const PreserveKernels volume_constraint_kernels_baseline = {volume, rise};
#endif
