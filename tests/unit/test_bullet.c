/// Balls, floor and walls meet as they should, in a Bullet that remembers nothing.
#include "bodies.h"
#include "contact/bullet.h"

enum { MOST = 40 };
static const double gravity = 9.81;
static const double frames[] = {1.0 / 60, 1.0 / 240, 1e-3};

static Sphere ball_at(double x, double y, double z, double radius, double mass) {
    return (Sphere){.x = {(real)x, (real)y, (real)z, 0},
                    .radius = (real)radius,
                    .mass = (real)mass,
                    .restitution = 1};
}

static Bullet* floor_only(void) {
    Bullet* bullet = bullet_open();
    bullet_add_plane(bullet, (double[]){7, 0, 7}, (double[]){0, 2, 0});
    return bullet;
}

/// One step as a world makes it: gravity, Bullet, places.
static void step_balls(Bullet* bullet, Sphere* sphere, int count, double h) {
    for (int i = 0; i < count; i++)
        sphere[i].v[1] -= (real)(gravity * h);
    bullet_solve(bullet, sphere, count, h);
    for (int i = 0; i < count; i++)
        sphere[i].x += (real)h * sphere[i].v;
}

static double4 momentum(const Sphere* s) {
    return (double)s->mass * to_double4(s->v);
}

/// About the origin, with the spin's.
static double4 angular_momentum(const Sphere* s) {
    return dcross(to_double4(s->x), momentum(s)) + (double)sphere_inertia(s) * to_double4(s->spin);
}

static double kinetic(const Sphere* s) {
    const double4 v = to_double4(s->v), w = to_double4(s->spin);
    return ((double)s->mass * ddot(v, v) + (double)sphere_inertia(s) * ddot(w, w)) / 2;
}

/// Touching or a step's path apart, slow or fast enough to pass through in one step.
static void elastic_head_on_hit_swaps_velocities(void** state) {
    (void)state;
    const double speed[] = {1, 10, 200}, radius[] = {0.02, 0.5};
    Bullet* bullet = bullet_open();
    for (int k = 0; k < 3 * 3 * 2 * 2; k++) {
        const double v = speed[k % 3], h = frames[k / 3 % 3], r = radius[k / 9 % 2];
        const double gap = k / 18 ? 0.9 * v * h : 0;
        Sphere s[2] = {ball_at(0, 0, 0, r, 2), ball_at(2 * r + gap, 0, 0, r, 2)};
        s[0].v[0] = (real)v;
        bullet_solve(bullet, s, 2, h);
        assert_near(s[0].v[0], 0, 1e-6 * v);
        assert_near(s[1].v[0], v, 1e-6 * v);
    }
    bullet_close(bullet);
}

static void paths_that_do_not_cross_are_no_hit(void** state) {
    (void)state;
    Bullet* bullet = bullet_open();
    Sphere s[2] = {ball_at(0, 0, 0, 0.1, 1), ball_at(2, 0.21, 0, 0.1, 1)};
    s[0].v[0] = 200;
    bullet_solve(bullet, s, 2, 1.0 / 60);
    assert_true(s[0].v[0] == 200 && s[1].v[0] == 0);

    // nor is one that comes after the step
    s[1].x[1] = 0;
    bullet_solve(bullet, s, 2, 1.7 / 200);
    assert_true(s[0].v[0] == 200 && s[1].v[0] == 0);
    bullet_close(bullet);
}

static double random_in(Random* random, double low, double high) {
    return low + (high - low) * random_next(random);
}

/// Two spinning balls of up to 1000 times each other's mass that touch somewhere.
static void touching_pair(Sphere s[2], Random* random) {
    double4 n = {0};
    for (int i = 0; i < 2; i++) {
        s[i] = ball_at(3, 2, 1, random_in(random, 0.02, 1), pow(1000, random_next(random)));
        s[i].friction = (real)0.5;
        for (int k = 0; k < 3; k++) {
            n[k] = random_in(random, -1, 1);
            s[i].v[k] = (real)random_in(random, -5, 5);
            s[i].spin[k] = (real)random_in(random, -20, 20);
        }
    }
    s[1].x += to_real4((double)(s[0].radius + s[1].radius) * n / dlength(n));
}

/// To rounding, which Bullet makes about ten times on the way.
static void hit_with_friction_keeps_momenta_and_gains_no_energy(void** state) {
    (void)state;
    Bullet* bullet = bullet_open();
    Random random = {12};
    for (int round = 0; round < 300; round++) {
        Sphere s[2];
        touching_pair(s, &random);
        const double4 p = momentum(&s[0]) + momentum(&s[1]);
        const double4 l = angular_momentum(&s[0]) + angular_momentum(&s[1]);
        const double energy = kinetic(&s[0]) + kinetic(&s[1]);
        double p_size = 0, l_size = 0;
        for (int i = 0; i < 2; i++) {
            p_size += dlength(momentum(&s[i]));
            l_size += dlength(momentum(&s[i])) * dlength(to_double4(s[i].x)) +
                      (double)sphere_inertia(&s[i]) * dlength(to_double4(s[i].spin));
        }
        bullet_solve(bullet, s, 2, 0.002);
        const double4 dp = momentum(&s[0]) + momentum(&s[1]) - p;
        const double4 dl = angular_momentum(&s[0]) + angular_momentum(&s[1]) - l;
        assert_near(dlength(dp), 0, 10 * (double)REAL_EPSILON * p_size);
        assert_near(dlength(dl), 0, 10 * (double)REAL_EPSILON * l_size);
        assert_less(kinetic(&s[0]) + kinetic(&s[1]), energy * (1 + 10 * (double)REAL_EPSILON));
    }
    bullet_close(bullet);
}

static void equal_balls_bounce_by_their_own_restitution(void** state) {
    (void)state;
    Bullet* bullet = bullet_open();
    Sphere s[2] = {ball_at(0, 0, 0, 0.5, 1), ball_at(1, 0, 0, 0.5, 1)};
    s[0].restitution = s[1].restitution = (real)0.6;
    s[0].v[0] = 5;
    bullet_solve(bullet, s, 2, 0.002);
    assert_near(s[1].v[0] - s[0].v[0], 3, 1e-5);
    bullet_close(bullet);
}

static void no_ball_is_fast_enough_to_leave_its_side(void** state) {
    (void)state;
    const double radius[] = {0.02, 0.5}, speed[] = {1, 20, 500};
    for (int k = 0; k < 3 * 3 * 2; k++) {
        const double h = frames[k % 3], v = speed[k / 3 % 3], r = radius[k / 9];
        Bullet* bullet = floor_only();
        bullet_add_plane(bullet, (double[]){2, 0, 0}, (double[]){-1, 0, 0});
        Sphere s = ball_at(0, 1.5, 0, r, 1);
        s.restitution = (real)0.5;
        s.v = (real4){(real)v, (real)-v, 0, 0};
        for (int n = 0; n < 300; n++) {
            step_balls(bullet, &s, 1, h);
            assert_less(r * (1 - 1e-5), s.x[1]);
            // one part in 10^7 of a coordinate of 2
            assert_less(s.x[0], 2 - r + 1e-6);
        }
        bullet_close(bullet);
    }
}

/// A tiny, a usual and a large ball come to rest, and then their gap is rounding.
static void ball_comes_to_rest_on_the_floor(void** state) {
    (void)state;
    const double radius[] = {0.02, 0.5, 5};
    for (int k = 0; k < 3 * 3; k++) {
        const double h = frames[k % 3], r = radius[k / 3];
        Bullet* bullet = floor_only();
        Sphere s = ball_at(0, 1.5 * r, 0, r, 1);
        s.restitution = s.friction = (real)0.5;
        for (int n = 0; n < 5 / h; n++)
            step_balls(bullet, &s, 1, h);
        assert_near(s.x[1], r, 1e-6 * r);
        assert_near(s.v[1], 0, 1e-6);
        assert_true(s.x[0] == 0 && s.x[2] == 0);
        bullet_close(bullet);
    }
}

/// Coulomb's friction turns sliding into rolling at 5/7 of the speed, whatever its coefficient: the
/// angular momentum m v r about the floor becomes (m r^2 + 2/5 m r^2) spin.
static void sliding_ball_ends_rolling(void** state) {
    (void)state;
    Bullet* bullet = floor_only();
    Sphere s = ball_at(0, 0.5, 0, 0.5, 3);
    s.restitution = 0;
    s.friction = (real)0.3;
    s.v[0] = 7;
    for (int n = 0; n < 1000; n++)
        step_balls(bullet, &s, 1, 0.002);
    // the floor of the real's rounding over the 340 steps of sliding
    assert_near(s.v[0], 5, TOLERANCE(1e-4, 1e-9));
    assert_near(s.spin[2], -10, TOLERANCE(2e-4, 1e-9));
    bullet_close(bullet);
}

static void overlapping_ball_comes_out_gently(void** state) {
    (void)state;
    Bullet* bullet = floor_only();
    Sphere s = ball_at(0, -0.3, 0, 0.5, 1);
    s.restitution = 0;
    double highest = 0;
    for (int n = 0; n < 2000; n++) {
        step_balls(bullet, &s, 1, 0.002);
        highest = fmax(highest, (double)s.x[1]);
    }
    assert_near(s.x[1], 0.5, 1e-5);
    assert_less(highest, 0.6);
    bullet_close(bullet);
}

static void heavy_ball_rests_on_a_light_one(void** state) {
    (void)state;
    Bullet* bullet = floor_only();
    Sphere s[2] = {ball_at(0, 0.5, 0, 0.5, 1), ball_at(0, 1.5, 0, 0.5, 1000)};
    s[0].restitution = s[1].restitution = 0;
    for (int n = 0; n < 2000; n++)
        step_balls(bullet, s, 2, 0.002);
    assert_near(s[0].x[1], 0.5, 1e-3);
    // fifty rounds of impulses at 1000 : 1 leave an overlap of a few per cent
    assert_near(s[1].x[1], 1.5, 0.1);
    bullet_close(bullet);
}

/// A heap of balls that hit each other and the floor.
static void heap_of(Sphere* sphere, int count, Random* random) {
    for (int i = 0; i < count; i++) {
        sphere[i] = ball_at(i % 4, 0.4 + i / 16, i / 4 % 4, random_in(random, 0.3, 0.6),
                            pow(100, random_next(random)));
        sphere[i].restitution = sphere[i].friction = (real)0.5;
        for (int k = 0; k < 3; k++)
            sphere[i].v[k] = (real)random_in(random, -9, 9);
    }
}

static void assert_same_bits(const Sphere* a, const Sphere* b, int count) {
    for (int i = 0; i < count; i++) {
        assert_memory_equal(&a[i].v, &b[i].v, sizeof(a->v));
        assert_memory_equal(&a[i].spin, &b[i].spin, sizeof(a->spin));
    }
}

static void same_balls_give_the_same_bits_after_any_history(void** state) {
    (void)state;
    Bullet *fresh, *used = floor_only();
    Sphere a[MOST], b[MOST];
    for (int round = 0; round < 20; round++) {
        // history: more and fewer balls, elsewhere, for a while
        Random random = {(uint64_t)round};
        const int before = 1 + (int)(random_next(&random) * MOST);
        heap_of(a, before, &random);
        for (int n = 0; n < 5; n++)
            step_balls(used, a, before, 0.01);

        const int count = 1 + (int)(random_next(&random) * MOST);
        heap_of(a, count, &random);
        memcpy(b, a, sizeof(a));
        fresh = floor_only();
        for (int n = 0; n < 5; n++) {
            step_balls(fresh, a, count, 0.01);
            step_balls(used, b, count, 0.01);
            assert_same_bits(a, b, count);
        }
        bullet_close(fresh);
    }
    bullet_close(used);
}

static void count_may_change_between_steps(void** state) {
    (void)state;
    Bullet* bullet = floor_only();
    Sphere s[MOST];
    bullet_solve(bullet, s, 0, 0.002);
    for (int count = 1; count <= MOST; count++) {
        for (int i = 0; i < count; i++)
            s[i] = ball_at(3 * i, 0.5, 0, 0.5, 1);
        s[count - 1].v[1] = -2;
        bullet_solve(bullet, s, count, 0.002);
        assert_near(s[count - 1].v[1], 2, 1e-6);
    }
    bullet_solve(bullet, s, 0, 0.002);
    bullet_solve(bullet, s, 2, 0.002);
    bullet_close(bullet);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(elastic_head_on_hit_swaps_velocities),
        cmocka_unit_test(paths_that_do_not_cross_are_no_hit),
        cmocka_unit_test(hit_with_friction_keeps_momenta_and_gains_no_energy),
        cmocka_unit_test(equal_balls_bounce_by_their_own_restitution),
        cmocka_unit_test(no_ball_is_fast_enough_to_leave_its_side),
        cmocka_unit_test(ball_comes_to_rest_on_the_floor),
        cmocka_unit_test(sliding_ball_ends_rolling),
        cmocka_unit_test(overlapping_ball_comes_out_gently),
        cmocka_unit_test(heavy_ball_rests_on_a_light_one),
        cmocka_unit_test(same_balls_give_the_same_bits_after_any_history),
        cmocka_unit_test(count_may_change_between_steps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
