/// Contacts within the equation of an implicit step: the state at rest is independent of method and
/// step.
#include <fcntl.h>

#include "worlds.h"

static char scene[64];

static void open_scene(World* world, const char* text, const char* const* set) {
    snprintf(scene, sizeof scene, "/tmp/balloon-equation-%ld.yaml", (long)getpid());
    const int file = open(scene, O_CREAT | O_TRUNC | O_WRONLY, 0600);
    assert_true(file >= 0);
    assert_true(write(file, text, strlen(text)) == (long)strlen(text));
    close(file);
    world_of(world, scene, set);
    remove(scene);
}

/// Rubber of 0.3 mm and 1 MPa, 1 % more air than fills it, on a floor that it just touches.
#define RESTS                                                                                      \
    "floor: 0\n"                                                                                   \
    "balloons:\n"                                                                                  \
    "  - model: cube-sphere:10\n"                                                                  \
    "    size: 0.3\n"                                                                              \
    "    position: [0, 0.15, 0]\n"                                                                 \
    "    skin: {membrane: {material: neo-hookean, young: 1e6, thickness: 3e-4, density: 1000}}\n"  \
    "    inflation: {law: gas, amount: 1.01}\n"                                                    \
    "    damping: {rate: 20}\n"

static void run_rest(const char* method, const char* step, const char* skin, double pressure,
                     double height, double tolerance) {
    const char* set[] = {method,
                         step,
                         skin,
                         skin ? "balloons.0.mass.per_particle=5e-4" : NULL,
                         skin ? "balloons.0.damping.rate=60" : NULL,
                         NULL};
    World world;
    open_scene(&world, RESTS, set);
    run_for(&world, 2);
    assert_near(probe(&world, "balloon0.gauge_pressure"), pressure, tolerance * pressure);
    assert_near(probe(&world, "balloon0.height"), height, 1e-3 * height);
    // no jitter and no creep: less than a micrometer in a step of 1/60 s
    const double fastest = sqrt(probe(&world, "balloon0.kinetic"));
    assert_less(fastest, 1e-4);
    world_close(&world);
}

/// 36.3 Pa and 0.28465 m (Euler's method at any step, and an independent solver).
static void rubber_rests_on_the_floor(void** state) {
    (void)state;
    run_rest("method=newton", "step=0.002", NULL, 36.3, 0.28465, 0.02);
    run_rest("method=newton", "step=0.01", NULL, 36.3, 0.28465, 0.02);
    run_rest("method=newton", "step=0.0166666666666666667", NULL, 36.3, 0.28465, 0.02);
}

/// With friction the state at rest depends on how the skin landed, unless damping ends its
/// vibrations first: here by both methods 37.66 Pa and 0.2456 m.
static void springs_rest_on_the_floor(void** state) {
    (void)state;
    const char* skin =
        "balloons.0.skin={springs: {structural: 50, shear: 20, flexion: 5, law: hooke}}";
    run_rest("method=euler", "step=0.0005", skin, 37.66, 0.2456, 0.005);
    run_rest("method=newton", "step=0.01", skin, 37.66, 0.2456, 0.005);
}

/// Two balls of 1 kg hit a round balloon of twice its gas from both sides: the deepest pole is at
/// 0.0973 m, and they leave no faster than they came. Backward Euler loses some of their speed: 4.5 % by
/// (1 + w^2 h^2)^(-1/2) a step of their half period alone.
static void balls_leave_no_faster_than_they_came(void** state) {
    (void)state;
    static const char text[] =
        "step: 0.002\n"
        "method: newton\n"
        "gravity: 0\n"
        "spheres:\n"
        "  - {position: [0, 0.3055, 0], velocity: [0, -0.4, 0], radius: 0.05, mass: 1,\n"
        "     restitution: 0, friction: 0}\n"
        "  - {position: [0, -0.3055, 0], velocity: [0, 0.4, 0], radius: 0.05, mass: 1,\n"
        "     restitution: 0, friction: 0}\n"
        "balloons:\n"
        "  - model: icosphere:3\n"
        "    scale: 0.1\n"
        "    skin: {membrane: {material: neo-hookean, young: 1e6, density: 1000, thickness: "
        "3e-4}}\n"
        "    inflation: {law: gas, amount: 1, max: 5, fill: {to: 2, seconds: 0.1}}\n"
        "    damping: {rate: 200}\n";
    World world;
    open_scene(&world, text, NULL);
    run_for(&world, 0.3);
    Event event = {.step = world.clock, .kind = EVENT_SET};
    snprintf(event.name, sizeof event.name, "balloons.0.damping.rate");
    snprintf(event.value, sizeof event.value, "0");
    Fault fault = {0};
    assert_true(world_event(&world, &event, &fault));
    double lowest = INFINITY, fastest = 0;
    for (int n = 0; n < 200; n++) {
        world_step(&world);
        lowest = fmin(lowest, probe(&world, "sphere0.y") - 0.05);
        fastest = fmax(fastest, probe(&world, "sphere0.vy"));
    }
    assert_near(lowest, 0.0973, 0.015 * 0.0973);
    assert_less(fastest, 0.4);
    assert_less(0.34, fastest);
    assert_near(probe(&world, "sphere1.vy"), -probe(&world, "sphere0.vy"), 0.01);
    assert_int_equal(world.contacts.pass_throughs, 0);
    world_close(&world);
}

/// A fast ball's velocities round by more than the skin's do: a residual that did not count them asked
/// for more than floats hold, and no part of a step was solved.
static void fast_balls_are_solved(void** state) {
    (void)state;
    static const char* const ball[] = {
        "spheres=[{position: [0, 0, 3], velocity: [0, 0, -100], radius: 0.02, mass: 0.01}]",
        "spheres=[{position: [0, 0, 3], velocity: [0, 0, -300], radius: 0.1, mass: 0.3}]"};
    for (int k = 0; k < 2; k++) {
        World world;
        WORLD_OF(&world, "cube-sphere:8", "method=newton", "step=0.002", "gravity=0", ball[k],
                 "balloons.0.inflation={law: area, amount: 3}", "balloons.0.damping={rate: 1}",
                 "balloons.0.strings=[]", "balloons.0.helium={base: 0}");
        run_for(&world, 0.03);
        if (world.blowup.halted)
            fail_msg("%s", world.blowup.text);
        world_close(&world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rubber_rests_on_the_floor),
        cmocka_unit_test(springs_rest_on_the_floor),
        cmocka_unit_test(balls_leave_no_faster_than_they_came),
        cmocka_unit_test(fast_balls_are_solved),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
