/// The fused pass over slices: the contents of the slots, and its sums compared with plain loops.
#include "base/cpu.h"
#include "bodies.h"
#include "body/extent.h"
#include "force/force.h"
#include "force/kernel.h"
#include "force/sweep.h"
#include "mesh/measure.h"

/// Skins of quads, of triangles, of both, with few and many faces around a particle, with a rim.
static const char* const skins[] = {"cube",        "cube-sphere:5", "torus:12x8",     "pillow:6",
                                    "icosphere:2", "discs:7x9",     "cube-sphere:12", "torus:3x3",
                                    "grid:5x4",    "disc:4x9",      "grid:1x1"};
enum { SKINS = sizeof skins / sizeof *skins };

static void springs_on(const char* name, Mesh* mesh, Body* body, SpringLaw law) {
    mesh_of(name, mesh);
    body_of(mesh, body);
    body_add_springs(body, paper_springs, law);
    shake(body, 0.05);
}

/// Each spring is in two slots, one for each end; all other slots have stiffness 0.
static void each_spring_is_in_two_slots(void** state) {
    (void)state;
    for (int n = 0; n < SKINS; n++) {
        Mesh mesh;
        Body body;
        springs_on(skins[n], &mesh, &body, LAW_HOOKE);
        const Slices* slices = &body.slices;
        int pulling = 0;
        for (int k = 0; k < slices->from[slices->count] * LANES; k++)
            pulling += slices->stiffness[k / LANES][k % LANES] > 0;
        assert_int_equal(pulling, 2 * body.springs.count);
        for (int s = 0; s < body.springs.count; s++)
            for (int end = 0; end < 2; end++) {
                const int at = slices->spring[s][end], slot = at / LANES, lane = at % LANES;
                int slice = 0;
                while (slices->from[slice + 1] <= slot)
                    slice++;
                assert_int_equal(slice * LANES + lane, body.springs.end[s][end]);
                assert_int_equal(slices->offset[slot][lane],
                                 (size_t)body.springs.end[s][1 - end] * sizeof(real4));
                assert_true(slices->stiffness[slot][lane] == body.springs.stiffness[s]);
                assert_true(slices->rest[slot][lane] == body.springs.rest[s]);
            }
        body_free(&body);
        mesh_free(&mesh);
    }
}

/// Spring by spring, in double.
static void plain_forces(const Body* body, double4* f) {
    const Springs* springs = &body->springs;
    for (int s = 0; s < springs->count; s++) {
        const int* end = springs->end[s];
        const double4 d = to_double4(body->x[end[1]]) - to_double4(body->x[end[0]]);
        const double r = (double)springs->rest[s] / dlength(d);
        const double law = springs->law == LAW_RUBBER && r < 1 ? (1 - pow(r, 6)) / 6 : 1 - r;
        const double4 pull = (double)springs->active[s] * law * d;
        f[end[0]] += pull;
        f[end[1]] -= pull;
    }
}

static void pulls_are_those_of_the_springs(void** state) {
    (void)state;
    for (int n = 0; n < 2 * SKINS; n++) {
        Mesh mesh;
        Body body;
        springs_on(skins[n / 2], &mesh, &body, n % 2 ? LAW_RUBBER : LAW_HOOKE);
        for (int s = 0; s < body.springs.count; s += 5) // as set by Tarantino's correction
            body_set_stiffness(&body, s, 0);
        double4* want = new_array(double4, body.count);
        plain_forces(&body, want);
        force_add(&force_springs, &body);
        double most = 0;
        for (int i = 0; i < body.count; i++)
            most = fmax(most, dlength(want[i]));
        for (int i = 0; i < body.count; i++)
            assert_near(dlength(to_double4(body.f[i]) - want[i]), 0, 100 * REAL_EPSILON * most);
        free(want);
        body_free(&body);
        mesh_free(&mesh);
    }
}

/// Gradient, area and volume of the rings, and of the fans on a rim, are those of the faces.
static void rings_measure_what_faces_do(void** state) {
    (void)state;
    for (int n = 0; n < SKINS; n++) {
        Mesh mesh;
        Body body;
        springs_on(skins[n], &mesh, &body, LAW_HOOKE);
        body_inflate(&body, &(Inflation){.law = INFLATE_AREA, .amount = 1});
        real4* want = new_array(real4, body.count);
        const double area = measure_volume_gradient(&mesh, body.x, want);
        double most = 0;
        for (int i = 0; i < body.count; i++)
            most = fmax(most, (double)length(want[i]));

        assert_close(sweep(&body, SWEEP_GRADIENT | SWEEP_AREA).area, area, 10 * REAL_EPSILON);
        for (int i = 0; i < body.count; i++)
            assert_near((double)length(body.inflation.gradient[i] - want[i]), 0,
                        20 * REAL_EPSILON * most);
        const SweepBounds bounds = sweep_bounds(&body);
        double volume2 = 0;
        for (int i = 0; i < body.count; i++)
            volume2 += (double)(body.inverse_mass[i] * dot(want[i], want[i]));
        assert_close(bounds.sums.area, area, 10 * REAL_EPSILON);
        assert_close(bounds.volume2, volume2, 20 * REAL_EPSILON);
        if (mesh.closed) {
            const double volume = measure_volume(&mesh, body.x);
            assert_close(sweep(&body, SWEEP_GRADIENT | SWEEP_VOLUME).volume, volume,
                         100 * REAL_EPSILON);
            assert_close(bounds.sums.volume, volume, 100 * REAL_EPSILON);
        }
        free(want);
        body_free(&body);
        mesh_free(&mesh);
    }
}

/// Results of one compilation of the kernels for a body: forces, velocities, sums.
static SweepSums one_step(const Kernels* with, Body* body, unsigned flags) {
    const Uniform uniform = {
        .acceleration = {0, (real)-9.8, 0, 0}, .pressure = 3, .drag = 0.02, .rate = 0.7};
    memset(body->f, 0, (size_t)body->count * sizeof *body->f);
    with->split(body->x, 0, body->slices.count * LANES, body->slices.coordinate);
    const SweepSums sums = with->sweep(&body->slices, 0, body->slices.count, body->x, flags,
                                       body->springs.law, body->f, body->inflation.gradient);
    with->uniform(&uniform, 0, body->count,
                  flags & SWEEP_GRADIENT ? body->inflation.gradient : NULL, body->mass,
                  body->inverse_mass, (real)0.001, body->v, body->f);
    return sums;
}

static void all_compilations_give_the_same_bits(void** state) {
    (void)state;
#ifdef __x86_64__
    if (!cpu_is_v3())
        skip();
    const unsigned flags[] = {SWEEP_SPRINGS,
                              SWEEP_SPRINGS | SWEEP_GRADIENT,
                              SWEEP_SPRINGS | SWEEP_GRADIENT | SWEEP_AREA,
                              SWEEP_SPRINGS | SWEEP_GRADIENT | SWEEP_VOLUME,
                              SWEEP_GRADIENT | SWEEP_AREA,
                              SWEEP_GRADIENT | SWEEP_VOLUME};
    for (size_t n = 0; n < SKINS * sizeof flags / sizeof *flags; n++)
        for (int law = 0; law < SPRING_LAWS; law++) {
            const unsigned goal = flags[n / SKINS];
            Mesh mesh;
            Body one, other;
            springs_on(skins[n % SKINS], &mesh, &one, (SpringLaw)law);
            body_of(&mesh, &other);
            body_add_springs(&other, paper_springs, (SpringLaw)law);
            shake(&other, 0.05);
            body_inflate(&one, &(Inflation){.law = INFLATE_AREA});
            body_inflate(&other, &(Inflation){.law = INFLATE_AREA});
            const SweepSums a = one_step(&kernels_baseline, &one, goal);
            const SweepSums b = one_step(&kernels_v3, &other, goal);
            const SweepBounds c =
                kernels_baseline.bounds(&one.slices, 0, one.slices.count, one.x, one.inverse_mass);
            const SweepBounds d = kernels_v3.bounds(&other.slices, 0, other.slices.count, other.x,
                                                    other.inverse_mass);
            assert_memory_equal(&c, &d, sizeof c);
            const size_t bytes = (size_t)one.count * sizeof(real4);
            assert_memory_equal(&a, &b, sizeof a);
            assert_memory_equal(one.f, other.f, bytes);
            assert_memory_equal(one.v, other.v, bytes);
            assert_memory_equal(one.inflation.gradient, other.inflation.gradient, bytes);
            body_free(&one);
            body_free(&other);
            mesh_free(&mesh);
        }
#else
    skip();
#endif
}

/// The bounding box for any count; all of space if a position is NaN.
static void extents_hold_all_and_see_what_is_no_number(void** state) {
    (void)state;
    enum { MOST = 13 };
    Random random = {5};
    for (int count = 1; count <= MOST; count++) {
        real4* a = new_array(real4, count);
        Extent want = {{1, 1, 1, 0}, {-1, -1, -1, 0}};
        for (int i = 0; i < count; i++)
            for (int k = 0; k < 3; k++) {
                a[i][k] = (real)(2 * random_next(&random) - 1);
                want.low[k] = real_min(want.low[k], a[i][k]);
                want.high[k] = real_max(want.high[k], a[i][k]);
            }
        const Extent got = extent_of(a, count), plain = extent_baseline.extent(a, count);
        assert_memory_equal(&got, &want, sizeof want);
        assert_memory_equal(&plain, &want, sizeof want);
        real largest = 0;
        for (int k = 0; k < 3; k++)
            largest = real_max(largest, real_max(-want.low[k], want.high[k]));
        for (int n = 0; n < 2; n++) {
            const real most = n ? largest : largest * (1 - REAL_EPSILON);
            assert_true(all_within(a, count, most) == (n == 1));
            assert_true(extent_baseline.within(a, count, most) == (n == 1));
        }
        assert_true(extent_length(&got) <= sqrt(3));
        for (int i = 0; i < count; i++) {
            assert_true(extent_length(&got) >= (double)length(a[i]));
            const real4 kept = a[i];
            a[i][i % 3] = (real)NAN;
            const Extent odd = extent_of(a, count), odd_plain = extent_baseline.extent(a, count);
            assert_true(odd.low[i % 3] == -INFINITY && odd.high[i % 3] == INFINITY);
            assert_true(odd_plain.low[i % 3] == -INFINITY && odd_plain.high[i % 3] == INFINITY);
            assert_false(all_within(a, count, REAL_MAX));
            assert_false(extent_baseline.within(a, count, REAL_MAX));
            a[i] = kept;
        }
        free(a);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_spring_is_in_two_slots),
        cmocka_unit_test(pulls_are_those_of_the_springs),
        cmocka_unit_test(rings_measure_what_faces_do),
        cmocka_unit_test(extents_hold_all_and_see_what_is_no_number),
        cmocka_unit_test(all_compilations_give_the_same_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
