/// Balls and balloons in a world: momenta through a hit, and nothing passes through.
#include "worlds.h"

#include "base/random.h"
#include "collide/cross.h"

/// One throw at a free balloon of radius 1 in still air.
typedef struct Throw {
    double speed;  ///< [m/s]
    double radius; ///< [balloon's]
    double rate;   ///< steps a second
    int direction; ///< row of direction_table
    int quads;     ///< quads a side of the cube-sphere
    double mass;   ///< [balloon's]
    double restitution, friction;
} Throw;

/// From where the ball comes, and how far off the middle it aims.
static const struct {
    double from[3], off[3];
} direction_table[] = {
    {{1, 0, 0}, {0, 0, 0}},                 // at the middle of a patch
    {{0.577, 0.577, 0.577}, {0, 0, 0}},     // at a corner of valence 3
    {{-0.36, 0.48, 0.8}, {0.2, -0.1, 0.3}}, // somewhere
    {{0, 1, 0}, {0.85, 0, 0}},              // it grazes
};
enum { DIRECTIONS = sizeof direction_table / sizeof *direction_table };

static void open_throw(World* world, const Throw* t) {
    const double* from = direction_table[t->direction].from;
    const double* off = direction_table[t->direction].off;
    const double away = 1.6 + t->radius, balloon = 1e-3 * (6 * t->quads * t->quads + 2);
    char model[64], step[64], sphere[512];
    snprintf(model, sizeof model, "cube-sphere:%d", t->quads);
    snprintf(step, sizeof step, "step=%.17g", 1 / t->rate);
    snprintf(sphere, sizeof sphere,
             "spheres=[{position: [%.9f, %.9f, %.9f], velocity: [%.9f, %.9f, %.9f], radius: %.9f, "
             "mass: %.9f, restitution: %g, friction: %g}]",
             away * from[0] + off[0], away * from[1] + off[1], away * from[2] + off[2],
             -t->speed * from[0], -t->speed * from[1], -t->speed * from[2], t->radius,
             t->mass * balloon, t->restitution, t->friction);
    WORLD_OF(world, model, step, sphere, "gravity=0", "balloons.0.strings=[]",
             "balloons.0.helium={base: 0}", "balloons.0.damping={coefficient: 0}",
             "balloons.0.inflation={law: area, amount: 2}");
    // no floor: the scene of a mesh has one, far below
    world->collide.plane_count = 0;
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
    const Sphere* s = &world->collide.sphere[0];
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
                     .direction = 2,
                     .quads = 8,
                     .mass = 1,
                     .restitution = 0.5,
                     .friction = 0.5};
    World world;
    open_throw(&world, &t);
    const Totals before = totals(&world);
    run_for(&world, 0.5);
    const Totals after = totals(&world);
    // it did hit, and it spins
    assert_true(length(world.collide.sphere[0].v) < 9);
    assert_true(length(world.collide.sphere[0].spin) > (real)0.1);
    assert_near(dlength(after.linear - before.linear), 0, TOLERANCE(1e-5, 1e-12) * before.sum);
    assert_near(dlength(after.angular - before.angular), 0,
                TOLERANCE(1e-5, 1e-12) * 2 * before.sum);
    world_close(&world);
}

/// The count after the ball has had the time to go through, from one side to the other.
static void check_throw(const Throw* t) {
    World world;
    open_throw(&world, t);
    // until it is past the other side, or a second
    run_for(&world, fmin(1, 6 / t->speed + 0.1));
    if (world.collide.pass_throughs != 0 || !is_finite(&world) || world.blowup.halted)
        fail_msg("speed %g radius %g rate %g direction %d quads %d mass %g: %ld through, %s",
                 t->speed, t->radius, t->rate, t->direction, t->quads, t->mass,
                 world.collide.pass_throughs, world.blowup.text);
    world_close(&world);
}

/// Slowest, middle and fastest of speeds, sizes and masses, at both frame rates.
static void nothing_passes_through(void** state) {
    (void)state;
    const double speeds[] = {1, 20, 200}, radii[] = {0.02, 0.2, 0.5}, masses[] = {0.1, 1, 1000};
    int direction = 0;
    for (int s = 0; s < 3; s++)
        for (int r = 0; r < 3; r++)
            for (int m = 0; m < 3; m++)
                for (int rate = 60; rate <= 240; rate += 180) {
                    direction = (direction + 1) % DIRECTIONS;
                    check_throw(&(Throw){.speed = speeds[s],
                                         .radius = radii[r],
                                         .rate = rate,
                                         .direction = direction,
                                         .quads = 8,
                                         .mass = masses[m],
                                         .restitution = 0.5,
                                         .friction = 0.3});
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
            low = fmin(low, (double)world.collide.sphere[0].x[1]);
        }
        // pressed in, and thrown back over the balloon's top
        assert_less(low, 0.12);
        assert_less(0.15, (double)world.collide.sphere[0].x[1]);
        assert_int_equal(world.collide.pass_throughs, 0);
        assert_false(world.blowup.halted);
        world_close(&world);
    }
}

/// A ball from anywhere at anything up to 200 m/s, of any size, at the balloon's middle or past it.
static void throw_at_random(World* world, Random* random) {
    Event event = {.step = world->clock, .kind = EVENT_THROW};
    double4 d = {0};
    for (int k = 0; k < 3; k++)
        d[k] = 2 * random_next(random) - 1;
    d[1] = fabs(d[1]);
    d /= dlength(d);
    const double speed = pow(10, 2.3 * random_next(random));
    const double radius = 0.03 * pow(10, 1.2 * random_next(random));
    const char* middle[] = {"balloon0.cx", "balloon0.cy", "balloon0.cz"};
    for (int k = 0; k < 3; k++) {
        event.thrown[k] = probe(world, middle[k]) + (4 + radius) * d[k];
        event.thrown[3 + k] = speed * (0.2 * (random_next(random) - 0.5) - d[k]);
    }
    event.thrown[6] = 0.386 * pow(10, -1 + 2 * random_next(random));
    event.thrown[7] = radius;
    Fault fault = {0};
    assert_true(world_event(world, &event, &fault));
}

/// Random throws at a balloon on the floor that is blown up and let out: all stays finite, the
/// count stays 0, and the winding number says the same of every ball.
static void random_throws_end_finite_and_outside(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "cube-sphere:8", "step=0.004", "floor=-3", "balloons.0.strings=[]",
             "balloons.0.helium={base: 0}",
             "balloons.0.inflation={law: area, amount: 3, rate: 8, least: 0.2, most: 25}");
    Random random = {1};
    for (long n = 0; n < 5000; n++) {
        if (n % 125 == 0)
            throw_at_random(&world, &random);
        if (n % 1000 == 0)
            press(&world, random_next(&random) < 0.5 ? "inflate" : "deflate", "down");
        if (n % 1000 == 500) {
            press(&world, "inflate", "up");
            press(&world, "deflate", "up");
        }
        if (n % 2500 == 2499)
            press(&world, "clear", "down");
        world_step(&world);
        assert_false(world.blowup.halted);
        assert_int_equal(world.collide.pass_throughs, 0);
        const Balloon* balloon = &world.balloon[0];
        for (int s = 0; n % 125 == 124 && s < world.collide.sphere_count; s++)
            assert_true(fabs(cross_winding(&balloon->mesh, balloon->body.x,
                                           to_double4(world.collide.sphere[s].x))) < 0.5);
    }
    assert_true(is_finite(&world));
    world_close(&world);
}

/// A scene with no ball is the same as if there were no contacts: Bullet is not there.
static void a_scene_with_no_ball_pays_nothing(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "tether");
    run_for(&world, 0.2);
    assert_null(world.collide.bullet);
    assert_null(world.collide.contact);
    world_close(&world);
}

/// Dropped on the floor, a balloon comes to rest and does not roll or slide by itself.
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

/// Highest that the first ball of a scene comes within some seconds.
static double launched(const char* scene, const char* sphere, const char* contact) {
    World world;
    WORLD_OF(&world, scene, sphere, contact);
    double top = -INFINITY;
    const long steps = lround(4 / world.step);
    for (long n = 0; n < steps; n++) {
        world_step(&world);
        top = fmax(top, (double)world.collide.sphere[0].x[1]);
    }
    assert_false(world.blowup.halted);
    assert_int_equal(world.collide.pass_throughs, 0);
    world_close(&world);
    return top;
}

/// Figures 16 to 18: the heavier the ball, the less high, by the paper's penalty and by ours.
static void heavier_balls_are_launched_less_high(void** state) {
    (void)state;
    const char* scenes[] = {"launch-1", "launch-100", "launch-1000"};
    double top[3];
    for (int k = 0; k < 3; k++)
        top[k] = launched(scenes[k], "contact=paper", "contact=paper");
    assert_less(top[1], top[0]);
    assert_less(top[2], top[1]);

    const double skin = 0.794; // the pillow's particles of 1 g
    for (int k = 0; k < 3; k++) {
        char sphere[128];
        snprintf(sphere, sizeof sphere, "spheres.0.mass=%g", skin * pow(10, k - 1));
        top[k] = launched("launch-1", sphere, "contact=impulse");
    }
    assert_less(top[1], top[0]);
    assert_less(top[2], top[1]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hit_keeps_momenta),
        cmocka_unit_test(nothing_passes_through),
        cmocka_unit_test(a_kilogram_bounces_off_a_real_balloon),
        cmocka_unit_test(random_throws_end_finite_and_outside),
        cmocka_unit_test(a_scene_with_no_ball_pays_nothing),
        cmocka_unit_test(a_balloon_comes_to_rest_on_the_floor),
        cmocka_unit_test(heavier_balls_are_launched_less_high),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
