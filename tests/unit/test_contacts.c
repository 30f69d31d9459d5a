/// Balls and balloons in a world: momenta in a hit, and no pass-throughs.
#include "worlds.h"
#include "contact/pair.h"

#include "lab/bench/storm.h"
#include "lab/bench/throw.h"

static void open_throw(World* world, const Throw* t) {
    Fault fault = {0};
    if (!throw_open(t, world, &fault)) {
        fault_print(&fault, stderr);
        fail();
    }
}

typedef struct Totals {
    double4 linear, angular;
    double sum;
} Totals;

static Totals totals(const World* world) {
    Totals total = {{0}, {0}, 0};
    const Body* body = &world->balloon[0].body;
    for (int i = 0; i < body->count; i++) {
        const double m = (double)body->mass[i];
        const double4 x = to_double4(body->x[i]), v = to_double4(body->v[i]);
        total.linear += m * v;
        total.angular += m * dcross(x, v);
        total.sum += m * dlength(v);
    }
    const Sphere* s = &world->contacts.sphere[0];
    const double m = (double)s->mass;
    total.linear += m * to_double4(s->v);
    total.angular += m * dcross(to_double4(s->x), to_double4(s->v)) +
                     (double)sphere_inertia(s) * to_double4(s->spin);
    total.sum += m * dlength(to_double4(s->v));
    return total;
}

static void a_hit_keeps_momenta(void** state) {
    (void)state;
    const Throw t = {.speed = 10,
                     .radius = 0.2,
                     .rate = 500,
                     .aim = 2,
                     .side = 8,
                     .mass = 1,
                     .restitution = 0.5,
                     .friction = 0.5};
    World world;
    open_throw(&world, &t);
    const Totals before = totals(&world);
    run_for(&world, 0.5);
    const Totals after = totals(&world);
    // it has hit and spins
    assert_true(length(world.contacts.sphere[0].v) < 9);
    assert_true(length(world.contacts.sphere[0].spin) > (real)0.1);
    assert_near(dlength(after.linear - before.linear), 0, TOLERANCE(1e-5, 1e-12) * before.sum);
    assert_near(dlength(after.angular - before.angular), 0,
                TOLERANCE(1e-5, 1e-12) * 2 * before.sum);
    world_close(&world);
}

/// The count of pass-throughs after a time in which the ball could cross the whole balloon.
static void check_throw(const Throw* t) {
    World world;
    open_throw(&world, t);
    for (long n = throw_steps(t); n > 0; n--)
        world_step(&world);
    if (world.contacts.pass_throughs != 0 || !is_finite(&world) || world.blowup.halted)
        fail_msg("speed %g radius %g rate %g aim %d side %d mass %g: %ld through, %s", t->speed,
                 t->radius, t->rate, t->aim, t->side, t->mass, world.contacts.pass_throughs,
                 world.blowup.text);
    world_close(&world);
}

/// Slow, medium and fast throws of several sizes and masses, at both step rates.
static void nothing_passes_through(void** state) {
    (void)state;
    const double speeds[] = {1, 20, 200}, radii[] = {0.02, 0.2, 0.5}, masses[] = {0.1, 1, 1000};
    int aim = 0;
    for (int s = 0; s < 3; s++)
        for (int r = 0; r < 3; r++)
            for (int m = 0; m < 3; m++)
                for (int rate = 60; rate <= 240; rate += 180) {
                    aim = (aim + 1) % THROW_AIMS;
                    check_throw(&(Throw){.speed = speeds[s],
                                         .radius = radii[r],
                                         .rate = rate,
                                         .aim = aim,
                                         .side = 8,
                                         .mass = masses[m],
                                         .restitution = 0.5,
                                         .friction = 0.3});
                }
}

/// A ball bounces off a free balloon of rubber with gas, by explicit and by implicit methods; these
/// keep momentum to the tolerance of their solve.
static void rubber_bounces_a_ball_by_every_method_that_takes_it(void** state) {
    (void)state;
    static const char* const how[][2] = {{"method=euler", "step=2e-4"},
                                         {"method=newton", "step=2e-3"}};
    for (int k = 0; k < 2; k++) {
        World world;
        WORLD_OF(&world, "sphere-gas", how[k][0], how[k][1], "solver={tolerance: 1e-12}",
                 "balloons.0.damping.rate=0", "balloons.0.inflation={law: gas, amount: 1}",
                 "spheres=[{position: [0, 0.2, 0.03], velocity: [0, -2, 0], radius: 0.04, "
                 "mass: 0.02, restitution: 0.5, friction: 0.4}]");
        const Totals before = totals(&world);
        run_for(&world, 0.15);
        const Totals after = totals(&world);
        assert_less(0, (double)world.contacts.sphere[0].v[1]); // it has bounced
        assert_less(probe(&world, "balloon0.cy"), -0.01);
        assert_int_equal(world.contacts.pass_throughs, 0);
        assert_near(dlength(after.linear - before.linear), 0, TOLERANCE(1e-5, 1e-10) * before.sum);
        world_close(&world);
    }
}

/// A ball of 1 kg dropped from 15 cm on a rubber balloon of 74 g and 28 cm (E = 1 MPa, 0.3 mm:
/// springs of E h = 300 N/m) bounces off it, at steps that the guard splits for the stiffness.
static void a_kilogram_bounces_off_a_real_balloon(void** state) {
    (void)state;
    for (int rate = 60; rate <= 240; rate += 180) {
        World world;
        char step[64];
        snprintf(step, sizeof step, "step=%.17g", 1.0 / rate);
        WORLD_OF(&world, "cube-sphere:12", step, "units=si", "floor=-0.14", "balloons.0.size=0.28",
                 "balloons.0.skin.springs={structural: 100, shear: 150, flexion: 50, law: rubber}",
                 "balloons.0.mass.per_particle=8.545e-5", // 74 g over 866 particles
                 "balloons.0.inflation={law: gas, amount: 1.1}", "balloons.0.damping={rate: 2}",
                 "balloons.0.helium={base: 0}", "balloons.0.strings=[]",
                 "spheres=[{position: [0, 0.34, 0], radius: 0.05, mass: 1, restitution: 0.3, "
                 "friction: 0.4}]");
        double low = INFINITY;
        const long steps = lround(0.6 * rate);
        for (long n = 0; n < steps; n++) {
            world_step(&world);
            low = fmin(low, (double)world.contacts.sphere[0].x[1]);
        }
        // pressed in, then back above the balloon's top
        assert_less(low, 0.12);
        assert_less(0.15, (double)world.contacts.sphere[0].x[1]);
        assert_int_equal(world.contacts.pass_throughs, 0);
        assert_false(world.blowup.halted);
        world_close(&world);
    }
}

/// Random throws at a balloon on the floor that is inflated and deflated: the state stays finite,
/// the count stays 0, and the skin's winding number around every ball stays what it was at its
/// throw.
static void random_throws_end_finite_and_outside(void** state) {
    (void)state;
    Storm storm;
    Fault fault = {0};
    assert_true(storm_open(&storm, 1, &fault));
    for (long n = 1; n <= 20L * STORM_RATE; n++) {
        assert_true(storm_step(&storm, &fault));
        assert_false(storm.world.blowup.halted);
        assert_int_equal(storm.world.contacts.pass_throughs, 0);
        if (n % STORM_THROW == 0)
            assert_int_equal(storm_astray(&storm), 0);
    }
    assert_int_equal(storm.world.contacts.sphere_count, STORM_BALLS);
    assert_true(is_finite(&storm.world));
    storm_close(&storm);
}

/// A coarse skin is inflated between four balls that it cannot move. Their restitution does not
/// affect how it comes to rest, because a loaded contact does not bounce.
static void balls_pressed_on_a_skin_let_it_rest(void** state) {
    (void)state;
    double kinetic[2];
    for (int k = 0; k < 2; k++) {
        World world;
        WORLD_OF(&world, "cube-sphere:12", "step=0.001", "gravity=0", "balloons.0.strings=[]",
                 "balloons.0.helium={base: 0}", "balloons.0.damping={rate: 10}",
                 "balloons.0.inflation={law: area, amount: 6}");
        const double at[4][3] = {
            {0.8, 0.9, 0}, {-0.8, 0.3, 0.9}, {0, -0.3, -1.2}, {0.7, -0.8, 0.6}};
        for (int s = 0; s < 4; s++) {
            const double none[3] = {0};
            const Sphere sphere = sphere_of(at[s], none, 0.2, 900, 0.9 * k, 0.3);
            contacts_add(&world.contacts, &sphere);
        }
        run_for(&world, 1.5);
        for (int s = 0; s < 4; s++)
            assert_true(world.contacts.pair[s].touching);
        kinetic[k] = probe(&world, "balloon0.kinetic");
        world_close(&world);
    }
    // with wrong bounces it keeps 0.3 J; at rest it only creeps
    assert_less(kinetic[0], 1e-3);
    assert_less(kinetic[1], 2 * kinetic[0]);
}

/// A wall beside the floor: a ball bounces off it, a skin stops on it.
static void walls_stop_balls_and_skins(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "cube-sphere:6", "floor=-9", "balloons.0.strings=[]",
             "balloons.0.helium={base: 0}", "balloons.0.damping={coefficient: 0.002}",
             "balloons.0.inflation={law: area, amount: 2}",
             "walls=[{at: [0, -1.5, 0], normal: [3, 4, 0]}, {at: [5, 0, 0], normal: [-1, 0, 0]}]",
             "spheres=[{position: [3, 4, 0], velocity: [10, 0, 0], radius: 0.25, mass: 1, "
             "restitution: 0.5, friction: 0}]");
    run_for(&world, 0.4);
    assert_near((double)world.contacts.sphere[0].v[0], -5, TOLERANCE(1e-5, 1e-12));
    double nearest = INFINITY;
    for (int n = 0; n < 100; n++) {
        run_for(&world, 0.02);
        for (int i = 0; i < world.balloon[0].body.count; i++) {
            const real4 x = world.balloon[0].body.x[i];
            nearest = fmin(nearest, 0.6 * (double)x[0] + 0.8 * ((double)x[1] + 1.5));
        }
    }
    // it fell on the slope and slid down, and no particle is behind the wall
    assert_near(nearest, 0, TOLERANCE(1e-5, 1e-12));
    assert_less(0.1, probe(&world, "balloon0.cx"));
    world_close(&world);
}

/// A scene without balls costs no contacts: Bullet's tree does not exist.
static void a_scene_with_no_ball_pays_nothing(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "tether");
    run_for(&world, 0.2);
    assert_null(world.contacts.balls);
    assert_null(world.contacts.contact);
    world_close(&world);
}

/// A balloon dropped on the floor comes to rest and then neither rolls nor slides.
static void a_balloon_comes_to_rest_on_the_floor(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "cube-sphere:6", "floor=-1.2", "balloons.0.strings=[]",
             "balloons.0.helium={base: 0}", "balloons.0.damping={coefficient: 0.002}",
             "balloons.0.inflation={law: area, amount: 2}", "balloons.0.turn=20");
    run_for(&world, 10);
    const double x = probe(&world, "balloon0.cx"), z = probe(&world, "balloon0.cz");
    run_for(&world, 10);
    assert_near(probe(&world, "balloon0.cx"), x, 1e-3);
    assert_near(probe(&world, "balloon0.cz"), z, 1e-3);
    assert_less(probe(&world, "balloon0.kinetic"), 1e-5);
    // no particle is below the floor
    for (int i = 0; i < world.balloon[0].body.count; i++)
        assert_true(world.balloon[0].body.x[i][1] > (real)-1.2001);
    world_close(&world);
}

static void each_pair_is_a_row_of_its_own(void** state) {
    (void)state;
    for (int r = 0; r < PAIR_ROWS; r++) {
        const PairRow* row = pair_table[r];
        assert_true(row->about[0] != 0);
        assert_true(row->safe_step || row->stop); // else nothing would separate the two
        for (int other = 0; other < r; other++)
            assert_string_not_equal(row->name, pair_table[other]->name);
    }
}

/// A search for the nearest triangle within a reach that is NaN would never end.
static void a_ball_whose_velocity_is_not_a_number_halts(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "ball-rests", "guard='off'");
    world.contacts.sphere[0].v[1] = (real)NAN;
    world_step(&world);
    assert_true(world.blowup.halted);
    world_close(&world);

    // under `split` the step is taken back to the last good state, and made again in halves
    WORLD_OF(&world, "ball-rests", "guard=split");
    world.contacts.sphere[0].v[1] = (real)NAN;
    world_step(&world);
    assert_true(world.blowup.halted || world.guard.taken_back > 0);
    assert_true(isfinite((double)world.contacts.sphere[0].v[1]));
    world_close(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_pair_is_a_row_of_its_own),
        cmocka_unit_test(rubber_bounces_a_ball_by_every_method_that_takes_it),
        cmocka_unit_test(a_hit_keeps_momenta),
        cmocka_unit_test(nothing_passes_through),
        cmocka_unit_test(a_kilogram_bounces_off_a_real_balloon),
        cmocka_unit_test(random_throws_end_finite_and_outside),
        cmocka_unit_test(balls_pressed_on_a_skin_let_it_rest),
        cmocka_unit_test(walls_stop_balls_and_skins),
        cmocka_unit_test(a_scene_with_no_ball_pays_nothing),
        cmocka_unit_test(a_balloon_comes_to_rest_on_the_floor),
        cmocka_unit_test(a_ball_whose_velocity_is_not_a_number_halts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
