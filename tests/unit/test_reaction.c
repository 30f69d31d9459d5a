/// Forces of contacts, as columns of the CSV, against weights and closed forms; friction of planes.
#include "worlds.h"

/// The scenes of these tests: rubber, gas, no friction but what a test sets.
#define SKIN                                                                                       \
    "    skin: {membrane: {material: neo-hookean, young: 1e6, density: 1000, thickness: 3e-4}}\n"
static const char* const plates =
    "step: 5e-4\ngravity: 0\nfloor: -0.1\nfloor_friction: 0\n"
    "walls: [{at: [0, 0.1, 0], normal: [0, -1, 0], friction: 0}]\n"
    "balloons:\n  - model: icosphere:3\n    scale: 0.1\n" SKIN
    "    inflation: {law: gas, amount: 1, fill: {to: 2, seconds: 0.1}}\n    damping: {rate: 50}\n";
static const char* const resting =
    "step: 5e-4\nfloor: 0\nfloor_friction: 0\n"
    "balloons:\n  - model: cube-sphere:10\n    position: [0, 0.15, 0]\n    scale: 0.15\n" SKIN
    "    inflation: {law: gas, amount: 1.01}\n    damping: {rate: 20}\n";

/// Bounds on the area on which the floor acts: that of particles whose triangles all lie on it, a
/// third of each triangle, and that of all triangles that touch it [m^2].
static void touching_areas(const World* world, double* inner, double* outer) {
    const Body* body = &world->balloon[0].body;
    bool* rim = calloc((size_t)body->count, sizeof *rim); // or off the floor
    double* area = calloc((size_t)body->count, sizeof *area);
    *inner = *outer = 0;
    for (int t = 0; t < body->mesh->triangle_count; t++) {
        const int* corner = body->mesh->triangle[t];
        const real4 a = body->x[corner[0]], b = body->x[corner[1]], c = body->x[corner[2]];
        const double size = (double)length(cross(b - a, c - a)) / 2;
        int touching = 0;
        for (int k = 0; k < 3; k++)
            touching += plane_gap(&world->contacts.plane[0], body->x[corner[k]]) <= (real)1e-6;
        for (int k = 0; k < 3; k++) {
            rim[corner[k]] |= touching < 3;
            area[corner[k]] += size / 3;
        }
        *outer += touching > 0 ? size : 0;
    }
    for (int i = 0; i < body->count; i++)
        *inner += rim[i] ? 0 : area[i];
    free(rim);
    free(area);
}

/// The floor carries the weight, also while the balloon sleeps.
static void balloon_at_rest_presses_with_its_weight(void** state) {
    (void)state;
    World world;
    OPEN_TEXT(&world, resting, "sleep_threshold=0.01");
    run_for(&world, 1);
    assert_close(probe(&world, "floor.force"), balloon_weight(&world), 1e-3);
    run_for(&world, 1);
    assert_true(world.balloon[0].body.asleep);
    assert_close(probe(&world, "floor.force"), balloon_weight(&world), 1e-3);
    world_close(&world);
}

/// Between frictionless plates, against an axisymmetric membrane solver: the pressure has the order
/// 2 of the mesh, 0.4 % here. The force is p A, A the area of the flat part, whose rim runs through
/// triangles: its error is that of a ring of them, and larger where the flat part is small.
static void plates_feel_pressure_times_area(void** state) {
    (void)state;
    World world;
    OPEN_TEXT(&world, plates, "floor=-0.115", "walls.0.at=[0, 0.115, 0]");
    run_for(&world, 1);
    const double pressure = probe(&world, "balloon0.gauge_pressure");
    const double force = probe(&world, "floor.force");
    assert_close(pressure, 1214.015, 0.005);
    assert_close(force, 2.710, 0.04);
    assert_close(force, probe(&world, "wall0.force"), 1e-3);
    double inner, outer;
    touching_areas(&world, &inner, &outer);
    assert_less(pressure * inner, force);
    assert_less(force, pressure * outer);
    world_close(&world);
}

/// A ball on the floor: its weight, equal and opposite; one in flight: nothing.
static void ball_feels_the_floor(void** state) {
    (void)state;
    World world;
    OPEN_TEXT(&world, resting,
              "spheres=[{position: [2, 0.1, 0], radius: 0.1, mass: 3}, "
              "{position: [3, 9, 0], radius: 0.1, mass: 3}]");
    run_for(&world, 0.05);
    const double ball = 3 * 9.81;
    assert_close(probe(&world, "sphere0.fy"), ball, 1e-5);
    assert_near(probe(&world, "sphere0.fx"), 0, 1e-5);
    assert_near(probe(&world, "sphere1.fy"), 0, 0);
    run_for(&world, 0.95);
    assert_close(probe(&world, "floor.force"), ball + balloon_weight(&world), 1e-3);
    world_close(&world);
}

/// On a plane of friction 0.3 a pillow rests below arctan 0.3 = 16.70 degrees, and slides above:
/// the damping of 0.001 N s/m lets it slide a quarter of its size a second half a degree above.
static void pillow_slides_above_the_angle_of_friction(void** state) {
    (void)state;
    static const char* const tilted =
        "step: 1e-3\nwalls: [{at: [0, 0, 0], normal: [0, 1, 0], friction: 0.3}]\n"
        "balloons:\n  - model: pillow:8\n    position: [0, 0.3, 0]\n    size: 0.3\n"
        "    skin: {springs: {structural: 50, shear: 10, flexion: 10}}\n"
        "    mass: {per_particle: 1e-3}\n    inflation: {law: area, amount: 0.01}\n"
        "    damping: {coefficient: 1e-3}\n";
    for (int above = 0; above < 2; above++) {
        World world;
        char normal[64];
        const double angle = atan(0.3) + (above ? 0.5 : -0.5) * acos(-1) / 180;
        snprintf(normal, sizeof normal, "walls.0.normal=[%.9f, %.9f, 0]", sin(angle), cos(angle));
        OPEN_TEXT(&world, tilted, normal);
        run_for(&world, 2.5);
        const double before = probe(&world, "balloon0.cx");
        run_for(&world, 0.5);
        const double slid = probe(&world, "balloon0.cx") - before;
        if (above)
            assert_less(0.02, slid);
        else
            assert_near(slid, 0, 1e-5);
        world_close(&world);
    }
}

/// A balloon that begins half below the floor comes out slowly, and then rests on it.
static void balloon_below_the_floor_comes_out_gently(void** state) {
    (void)state;
    World world;
    OPEN_TEXT(&world, resting, "balloons.0.position=[0, 0, 0]");
    const double mass = balloon_weight(&world) / world.balloon[0].body.gravity;
    double fastest = 0, highest = -INFINITY;
    for (int n = 0; n < 2000; n++) {
        world_step(&world);
        fastest = fmax(fastest, probe(&world, "balloon0.py") / mass);
        highest = fmax(highest, probe(&world, "balloon0.cy"));
    }
    assert_less(fastest, 1 + 1e-5);
    assert_less(highest, 0.16);
    assert_close(probe(&world, "balloon0.height"), 0.28465, 2e-3);
    world_close(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(balloon_at_rest_presses_with_its_weight),
        cmocka_unit_test(plates_feel_pressure_times_area),
        cmocka_unit_test(ball_feels_the_floor),
        cmocka_unit_test(pillow_slides_above_the_angle_of_friction),
        cmocka_unit_test(balloon_below_the_floor_comes_out_gently),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
