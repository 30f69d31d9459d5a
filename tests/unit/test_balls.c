/// Balls, floor and walls collide, without a skin.
#include "bodies.h"
#include "contact/contacts.h"

enum { MOST = 40 };
static const double gravity = 9.81;
static const double frames[] = {1.0 / 60, 1.0 / 240, 1e-3};

static Sphere ball_at(double x, double y, double z, double radius, double mass) {
    return (Sphere){.x = {(real)x, (real)y, (real)z, 0},
                    .radius = (real)radius,
                    .mass = (real)mass,
                    .restitution = 1};
}

static const Plane floor_plane = {.point = {7, 0, 7, 0}, .normal = {0, 1, 0, 0}};

static void open_with(Contacts* contacts, double g, const Plane* plane, int planes,
                      const Sphere* sphere, int count) {
    contacts_open(contacts, CONTACT_IMPULSE, g, plane, planes, (SkinContacts){0}, NULL, NULL, 0);
    for (int i = 0; i < count; i++)
        contacts_add(contacts, &sphere[i]);
}

/// A step of a world, in as many drifts as contacts allow.
static void step_balls(Contacts* contacts, double h) {
    while (h > 0) {
        const double safe = contacts_safe_step(contacts, h);
        const double drift = contacts_velocities(contacts, safe);
        contacts_drift(contacts, drift);
        h -= drift;
    }
}

/// Solve the velocities of two balls, without gravity and planes.
static void solve_pair(Sphere s[2], double h) {
    Contacts contacts;
    open_with(&contacts, 0, NULL, 0, s, 2);
    contacts_velocities(&contacts, h);
    memcpy(s, contacts.sphere, 2 * sizeof *s);
    contacts_close(&contacts);
}

static double4 momentum(const Sphere* s) {
    return (double)s->mass * to_double4(s->v);
}

/// Angular momentum about the origin, spin included.
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
    for (int k = 0; k < 3 * 3 * 2 * 2; k++) {
        const double v = speed[k % 3], h = frames[k / 3 % 3], r = radius[k / 9 % 2];
        const double gap = k / 18 ? 0.9 * v * h : 0;
        Sphere s[2] = {ball_at(0, 0, 0, r, 2), ball_at(2 * r + gap, 0, 0, r, 2)};
        s[0].v[0] = (real)v;
        solve_pair(s, h);
        assert_near(s[0].v[0], 0, 1e-6 * v);
        assert_near(s[1].v[0], v, 1e-6 * v);
    }
}

static void paths_that_do_not_cross_are_no_hit(void** state) {
    (void)state;
    Sphere s[2] = {ball_at(0, 0, 0, 0.1, 1), ball_at(2, 0.21, 0, 0.1, 1)};
    s[0].v[0] = 200;
    solve_pair(s, 1.0 / 60);
    assert_true(s[0].v[0] == 200 && s[1].v[0] == 0);

    // nor is a hit after the end of the step
    s[1].x[1] = 0;
    solve_pair(s, 1.7 / 200);
    assert_true(s[0].v[0] == 200 && s[1].v[0] == 0);
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

/// Momenta are kept to rounding, about ten roundings a solve.
static void hit_with_friction_keeps_momenta_and_gains_no_energy(void** state) {
    (void)state;
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
        solve_pair(s, 0.002);
        const double4 dp = momentum(&s[0]) + momentum(&s[1]) - p;
        const double4 dl = angular_momentum(&s[0]) + angular_momentum(&s[1]) - l;
        assert_near(dlength(dp), 0, 10 * (double)REAL_EPSILON * p_size);
        assert_near(dlength(dl), 0, 10 * (double)REAL_EPSILON * l_size);
        assert_less(kinetic(&s[0]) + kinetic(&s[1]), energy * (1 + 10 * (double)REAL_EPSILON));
    }
}

static void equal_balls_bounce_by_their_own_restitution(void** state) {
    (void)state;
    Sphere s[2] = {ball_at(0, 0, 0, 0.5, 1), ball_at(1, 0, 0, 0.5, 1)};
    s[0].restitution = s[1].restitution = (real)0.6;
    s[0].v[0] = 5;
    solve_pair(s, 0.002);
    assert_near(s[1].v[0] - s[0].v[0], 3, 1e-5);
}

static void no_ball_is_fast_enough_to_leave_its_side(void** state) {
    (void)state;
    const double radius[] = {0.02, 0.5}, speed[] = {1, 20, 500};
    const Plane plane[] = {floor_plane, {.point = {2, 0, 0, 0}, .normal = {-1, 0, 0, 0}}};
    for (int k = 0; k < 3 * 3 * 2; k++) {
        const double h = frames[k % 3], v = speed[k / 3 % 3], r = radius[k / 9];
        Sphere s = ball_at(0, 1.5, 0, r, 1);
        s.restitution = (real)0.5;
        s.v = (real4){(real)v, (real)-v, 0, 0};
        Contacts contacts;
        open_with(&contacts, gravity, plane, 2, &s, 1);
        for (int n = 0; n < 300; n++) {
            step_balls(&contacts, h);
            assert_less(r * (1 - 1e-5), contacts.sphere[0].x[1]);
            // one part in 10^7 of a coordinate of 2
            assert_less(contacts.sphere[0].x[0], 2 - r + 1e-6);
        }
        contacts_close(&contacts);
    }
}

/// A ball on the floor, after some seconds in steps of h.
static Sphere rolled(Sphere s, double h, double seconds) {
    Contacts contacts;
    open_with(&contacts, gravity, &floor_plane, 1, &s, 1);
    for (int n = 0; n < seconds / h; n++)
        step_balls(&contacts, h);
    s = contacts.sphere[0];
    contacts_close(&contacts);
    return s;
}

/// A tiny, a usual and a large ball come to rest, and then their gap is rounding.
static void ball_comes_to_rest_on_the_floor(void** state) {
    (void)state;
    const double radius[] = {0.02, 0.5, 5};
    for (int k = 0; k < 3 * 3; k++) {
        const double r = radius[k / 3];
        Sphere s = ball_at(0, 1.5 * r, 0, r, 1);
        s.restitution = s.friction = (real)0.5;
        s = rolled(s, frames[k % 3], 5);
        assert_near(s.x[1], r, 1e-6 * r);
        assert_near(s.v[1], 0, 1e-6);
        assert_true(s.x[0] == 0 && s.x[2] == 0);
    }
}

/// Coulomb's friction turns sliding into rolling at 5/7 of the speed, whatever its coefficient: the
/// angular momentum m v r about the floor becomes (m r^2 + 2/5 m r^2) spin.
static void sliding_ball_ends_rolling(void** state) {
    (void)state;
    Sphere s = ball_at(0, 0.5, 0, 0.5, 3);
    s.restitution = 0;
    s.friction = (real)0.3;
    s.v[0] = 7;
    s = rolled(s, 0.002, 2);
    // accumulated rounding of 340 sliding steps
    assert_near(s.v[0], 5, TOLERANCE(1e-4, 1e-9));
    assert_near(s.spin[2], -10, TOLERANCE(2e-4, 1e-9));
}

static void overlapping_ball_comes_out_gently(void** state) {
    (void)state;
    Sphere s = ball_at(0, -0.3, 0, 0.5, 1);
    s.restitution = 0;
    Contacts contacts;
    open_with(&contacts, gravity, &floor_plane, 1, &s, 1);
    double highest = 0;
    for (int n = 0; n < 2000; n++) {
        step_balls(&contacts, 0.002);
        highest = fmax(highest, (double)contacts.sphere[0].x[1]);
    }
    assert_near(contacts.sphere[0].x[1], 0.5, 1e-5);
    assert_less(highest, 0.6);
    contacts_close(&contacts);
}

static void heavy_ball_rests_on_a_light_one(void** state) {
    (void)state;
    Sphere s[2] = {ball_at(0, 0.5, 0, 0.5, 1), ball_at(0, 1.5, 0, 0.5, 1000)};
    s[0].restitution = s[1].restitution = 0;
    Contacts contacts;
    open_with(&contacts, gravity, &floor_plane, 1, s, 2);
    for (int n = 0; n < 2000; n++)
        step_balls(&contacts, 0.002);
    assert_near(contacts.sphere[0].x[1], 0.5, 1e-3);
    // fifty rounds of impulses at 1000 : 1 leave an overlap of a few per cent
    assert_near(contacts.sphere[1].x[1], 1.5, 0.1);
    contacts_close(&contacts);
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
    Contacts fresh, used;
    open_with(&used, gravity, &floor_plane, 1, NULL, 0);
    Sphere heap[MOST];
    for (int round = 0; round < 20; round++) {
        // steps with more, fewer and other balls, so that the world has a history
        Random random = {(uint64_t)round};
        for (int k = 0; k < 2; k++) {
            const int count = 1 + (int)(random_next(&random) * MOST);
            heap_of(heap, count, &random);
            contacts_clear(&used);
            for (int i = 0; i < count; i++)
                contacts_add(&used, &heap[i]);
            if (k == 1)
                open_with(&fresh, gravity, &floor_plane, 1, heap, count);
            for (int n = 0; n < 5; n++)
                step_balls(&used, 0.01);
        }
        for (int n = 0; n < 5; n++)
            step_balls(&fresh, 0.01);
        assert_int_equal(fresh.sphere_count, used.sphere_count);
        assert_same_bits(fresh.sphere, used.sphere, used.sphere_count);
        contacts_close(&fresh);
    }
    contacts_close(&used);
}

static void each_new_ball_is_seen(void** state) {
    (void)state;
    Contacts contacts;
    open_with(&contacts, 0, &floor_plane, 1, NULL, 0);
    for (int count = 1; count <= MOST; count++) {
        Sphere s = ball_at(3 * count, 0.5, 0, 0.5, 1);
        s.v[1] = -2;
        contacts_add(&contacts, &s);
        contacts_velocities(&contacts, 0.002);
        assert_near(contacts.sphere[count - 1].v[1], 2, 1e-6);
    }
    contacts_clear(&contacts);
    assert_near(contacts_velocities(&contacts, 0.002), 0.002, 0);
    contacts_close(&contacts);
}

/// Bullet's tree finds all pairs that touch on their paths, and some more.
static void no_pair_of_balls_is_missed(void** state) {
    (void)state;
    Random random = {21};
    BulletBalls* balls = bullet_balls_open();
    Sphere s[MOST];
    for (int round = 0; round < 200; round++) {
        const int count = (int)(random_next(&random) * (MOST + 1));
        heap_of(s, count, &random);
        const double h = pow(10, -3 + 2 * random_next(&random)), margin = random_next(&random) / 10;
        const int(*pair)[2];
        const int found = bullet_balls_near(balls, s, count, h, margin, &pair);
        int next = 0;
        for (int i = 0; i < count; i++)
            for (int k = i + 1; k < count; k++) {
                double nearest = INFINITY;
                for (int n = 0; n <= 20; n++) // samples of the path
                    nearest = fmin(nearest,
                                   dlength(to_double4(s[i].x) - to_double4(s[k].x) +
                                           h * n / 20 * (to_double4(s[i].v) - to_double4(s[k].v))));
                if (next < found && pair[next][0] == i && pair[next][1] == k)
                    next++;
                else
                    assert_less((double)(s[i].radius + s[k].radius) + margin, nearest);
            }
        assert_int_equal(next, found);
    }
    bullet_balls_close(balls);
}

/// Two balls roll to rest far apart from a third that is shot at the floor: they come to rest as
/// they would alone, to the last bit.
static void contacts_elsewhere_change_nothing(void** state) {
    (void)state;
    Sphere s[3] = {ball_at(0, 0.5, 0, 0.5, 1), ball_at(1, 0.5, 0, 0.5, 30),
                   ball_at(900, 5, 0, 0.5, 1)};
    s[0].friction = s[1].friction = (real)0.4;
    s[0].v[0] = 3;
    s[2].v[1] = -20;
    Contacts alone, beside;
    open_with(&alone, gravity, &floor_plane, 1, s, 2);
    open_with(&beside, gravity, &floor_plane, 1, s, 3);
    for (int n = 0; n < 500; n++) {
        contacts_velocities(&alone, 1e-3);
        contacts_drift(&alone, 1e-3);
        contacts_velocities(&beside, 1e-3);
        contacts_drift(&beside, 1e-3);
    }
    assert_same_bits(alone.sphere, beside.sphere, 2);
    assert_less(0, beside.sphere[2].v[1] + (real)gravity); // after a bounce
    contacts_close(&alone);
    contacts_close(&beside);
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
        cmocka_unit_test(each_new_ball_is_seen),
        cmocka_unit_test(no_pair_of_balls_is_missed),
        cmocka_unit_test(contacts_elsewhere_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
