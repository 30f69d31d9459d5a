/// Strings that join balloons and knots: equal and opposite forces, their energy and their tangent,
/// both momenta, and equilibria that are the same by both methods.
#include "base/random.h"
#include "momenta.h"
#include "scenes.h"
#include "solve/group.h"

#define SKIN                                                                                       \
    "    skin: {springs: {structural: 50, shear: 10, flexion: 10}}\n"                              \
    "    mass: {per_particle: 0.001}\n"

/// Two balloons and a free knot in free space, joined by three strings that are taut at the start.
static const char free_scene[] =
    "step: 0.001\n"
    "gravity: 0\n"
    "knots: [{position: [0.4, 0, 0.1], mass: 0.02}]\n"
    "balloons:\n"
    "  - model: cube-sphere:3\n"
    "    position: [0, 1.7, 0]\n" SKIN "    strings: [{to_knot: 0, stiffness: 50, slack: 0.7}]\n"
    "  - model: cube-sphere:3\n"
    "    position: [0.3, -1.8, 0.2]\n" SKIN "    strings:\n"
    "      - {to_knot: 0, stiffness: 40, slack: 0.8}\n"
    "      - {to_balloon: 0, at: 7, to_at: 11, stiffness: 30, slack: 0.8}\n";

/// A balloon that hangs from a fixed point, a knot that hangs from it, and a balloon on the knot.
static const char hanging_scene[] =
    "step: 0.002\n"
    "gravity: 9.8\n"
    "knots: [{position: [0, -2.5, 0], mass: 0.02}]\n"
    "balloons:\n"
    "  - model: cube-sphere:3\n" SKIN "    damping: {coefficient: 0.02}\n"
    "    strings:\n"
    "      - {to_knot: 0, at: lowest, stiffness: 50}\n"
    "      - {to: [0, 3, 0], at: highest, stiffness: 50}\n"
    "  - model: cube-sphere:3\n"
    "    position: [0, -5, 0]\n" SKIN "    helium: {base: 2}\n"
    "    damping: {coefficient: 0.02}\n"
    "    strings: [{to_knot: 0, at: highest, stiffness: 50}]\n";

static void open_scene(World* world, const char* text, const char* method, const char* step) {
    write_bytes(scene, text, strlen(text));
    WORLD_OF(world, scene, method, step);
}

/// Of balloons and knots.
static Momenta momenta_with_knots(const World* world) {
    Momenta sum = momenta_of(world);
    for (int k = 0; k < world->system.joints.knot_count; k++) {
        const Sphere* point = &world->system.joints.knot[k].point;
        momenta_add(&sum, (double)point->mass, point->x, point->v);
    }
    return sum;
}

/// Explicit: to rounding, of 400 steps as a random walk. newton solves to 1e-6 of its forces, and
/// keeps angular momentum to the order of the method only.
static void joined_balloons_keep_their_momenta(void** state) {
    (void)state;
    World world;
    open_scene(&world, free_scene, "method=euler", "step=0.001");
    run_for(&world, 0.4);
    Momenta after = momenta_with_knots(&world);
    assert_less(0.1, after.linear_size); // they move
    assert_less(dlength(after.linear), TOLERANCE(1e-5, 1e-12) * after.linear_size);
    assert_less(dlength(after.angular), TOLERANCE(1e-5, 1e-12) * after.angular_size);
    world_close(&world);

    open_scene(&world, free_scene, "method=newton", "step=0.01");
    run_for(&world, 0.4);
    after = momenta_with_knots(&world);
    assert_less(0.1, after.linear_size);
    assert_less(dlength(after.linear), 1e-4 * after.linear_size);
    world_close(&world);
}

/// A free knot between two balloons; all three move at random.
static void shake(World* world) {
    Random random = {3};
    Joints* joints = &world->system.joints;
    for (int b = 0; b < 2; b++) {
        Body* body = joints->body[b];
        for (int i = 0; i < body->count; i++)
            for (int k = 0; k < 3; k++)
                body->x[i][k] += (real)(0.05 * random_next(&random));
    }
    for (int k = 0; k < 3; k++)
        joints->knot[0].point.x[k] += (real)(0.3 * random_next(&random));
}

static real4* position_of(Joints* joints, JointEnd end) {
    return end.body != NONE ? &joints->body[end.body]->x[end.number]
                            : &joints->knot[end.number].point.x;
}

/// Sum of the forces on the particle or knot of an end.
static double4 force_on(const Joints* joints, JointEnd end) {
    double4 sum = {0};
    for (int k = 0; k < joints->count; k++)
        for (int e = 0; e < 2; e++) {
            const JointEnd* at = &joints->joint[k].end[e];
            if (at->body == end.body && at->number == end.number)
                sum += (e ? -1 : 1) * to_double4(joint_force(joints, &joints->joint[k], 0));
        }
    return sum;
}

static void a_force_is_the_gradient_of_its_energy(void** state) {
    (void)state;
    World world;
    open_scene(&world, free_scene, "method=euler", "step=0.001");
    shake(&world);
    Joints* joints = &world.system.joints;
    const double h = TOLERANCE(1e-2, 1e-5); // error h^2; rounding of positions of 1 over h
    int taut = 0;
    for (int k = 0; k < joints->count; k++) {
        const Joint* joint = &joints->joint[k];
        taut += joint_tension(joints, joint) > 0;
        for (int e = 0; e < 2; e++) {
            const double4 force = force_on(joints, joint->end[e]);
            for (int c = 0; c < 3; c++) {
                real4* const x = position_of(joints, joint->end[e]);
                const real4 before = *x;
                (*x)[c] = before[c] + (real)h;
                const double above = joints_energy(joints), high = (double)(*x)[c];
                (*x)[c] = before[c] - (real)h;
                const double slope = (above - joints_energy(joints)) / (high - (double)(*x)[c]);
                *x = before;
                assert_near(force[c], -slope, TOLERANCE(2e-2, 1e-6));
            }
        }
    }
    assert_int_equal(taut, joints->count);
    world_close(&world);
}

/// H against differences of the impulses h F over velocities, for the joint of a knot.
static void a_tangent_is_the_derivative_of_the_impulse(void** state) {
    (void)state;
    if (sizeof(real) == sizeof(float))
        skip(); // differences of float forces are noise
    World world;
    open_scene(&world, free_scene, "method=newton", "step=0.01");
    shake(&world);
    Joints* joints = &world.system.joints;
    const double h = 0.01, change = 1e-5;
    for (int j = 0; j < joints->count; j++) {
        JointTerm term = {.joint = &joints->joint[j],
                          .node = {{NONE, NONE, 0, 0}, {NONE, NONE, 0, 0}}};
        Group group = {.joint = &term, .joint_count = 1, .joints = joints};
        joint_terms_add_impulses(&group, h);
        for (int c = 0; c < 3; c++) {
            real4* const x = position_of(joints, term.joint->end[0]);
            const real4 before = *x;
            (*x)[c] += (real)(h * change); // a velocity changes by `change`
            const real4 above = joint_force(joints, term.joint, h);
            (*x)[c] = before[c] - (real)(h * change);
            const real4 below = joint_force(joints, term.joint, h);
            *x = before;
            for (int row = 0; row < 3; row++)
                assert_near((double)term.tangent.column[c][row],
                            -h * (double)(above[row] - below[row]) / (2 * change), 1e-7);
        }
        assert_true(joint_terms_potential(&group, h) > 0);
    }
    world_close(&world);
}

/// A free knot that hangs from one balloon and holds another: its upper string bears the weight of
/// the knot and of the lower balloon less that one's lift.
static void rest_is_the_same_by_both_methods(void** state) {
    (void)state;
    const char* const method[] = {"method=euler", "method=newton"};
    const char* const step[] = {"step=0.002", "step=0.0166667"};
    const double mass = 56e-3, knot = 0.02, g = 9.8; // 56 particles
    for (int m = 0; m < 2; m++) {
        World world;
        open_scene(&world, hanging_scene, method[m], step[m]);
        run_for(&world, 12);
        assert_close(probe(&world, "balloon1.string0.tension"), mass * (g - 2), 2e-3);
        assert_close(probe(&world, "balloon0.string0.tension"), mass * (g - 2) + knot * g, 2e-3);
        assert_close(probe(&world, "knot0.fy"), knot * g, 1e-2); // its strings carry it
        world_close(&world);
    }
}

/// A string and a free knot that are much stiffer than the skins: the guard splits the step by their
/// bound, and the total energy of the free motion does not grow beyond that of the stretched strings.
static void a_stiff_joint_is_within_the_stability_bound(void** state) {
    (void)state;
    World world;
    open_scene(&world, free_scene, "balloons.0.strings.0.stiffness=20000", "step=0.002");
    const double start = joints_energy(&world.system.joints);
    run_for(&world, 0.2);
    assert_true(world.guard.substeps > 1);
    assert_true(is_finite(&world));
    const double now = joints_energy(&world.system.joints) + probe(&world, "balloon0.kinetic") +
                       probe(&world, "balloon1.kinetic");
    assert_less(now, 1.1 * start); // semi-implicit Euler's energy oscillates by h w / 2
    world_close(&world);
}

/// Untied, the string has no tension; tied again, it has the first one.
static void a_key_ties_and_unties_joints(void** state) {
    (void)state;
    World world;
    open_scene(&world, free_scene, "method=euler", "step=0.001");
    const double tension = probe(&world, "balloon0.string0.tension");
    assert_less(0.1, tension);
    press(&world, "string", "down");
    assert_near(probe(&world, "balloon0.string0.tension"), 0, 0);
    press(&world, "string", "up");
    press(&world, "string", "down");
    assert_near(probe(&world, "balloon0.string0.tension"), tension,
                TOLERANCE(1e-5, 1e-12) * tension);
    world_close(&world);
}

/// A held knot is where its path says, also where contacts shorten drifts.
static void a_held_knot_follows_its_path(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "bunch");
    run_for(&world, 2.3);
    const Knot* knot = &world.system.joints.knot[0];
    assert_near((double)knot->point.x[0], 1.2, 1e-4);
    assert_near((double)knot->point.x[1], -3.2, 1e-4);
    assert_near(probe(&world, "knot0.x"), 1.2, 1e-4);
    assert_near(probe(&world, "knot0.vx"), 4, 1e-2); // 1.2 in 0.3 s
    double sum = 0; // of twelve strings that carry the balloons' lift
    for (int b = 0; b < world.balloon_count; b++)
        sum += joint_tension(&world.system.joints, &world.system.joints.joint[b]);
    assert_less(10, sum);
    world_close(&world);
}

static void every_key_of_strings_and_knots_loads_into_its_field(void** state) {
    (void)state;
    WorldDef def;
    must_load(full, NULL, &def);
    assert_int_equal(def.balloons->strings_count, 5);
    const StringDef* string = def.balloons->strings;
    assert_vector(string[0].to, 0, -6, 0.5);
    assert_string_equal(string[0].at, "nearest");
    assert_true(string[0].stiffness == 50 && string[0].slack == 1.2);
    assert_null(string[1].to);
    assert_string_equal(string[1].at, "12");
    assert_true(string[1].stiffness == 7 && string[1].slack == 1);
    assert_true(!string_joins(&string[1]) && string_joins(&string[2]) && string_joins(&string[3]));
    assert_true(*string[2].to_balloon == 1 && *string[3].to_knot == 1);
    assert_string_equal(string[2].to_at, "3");
    assert_true(*string[4].to_thing == 0 && string_joins(&string[4]));
    assert_string_equal(string[4].to_at, "lowest");
    assert_int_equal(def.balloons->pins_count, 2);
    assert_vector(def.balloons->pins[0].at, 0, 1, 2);
    assert_true(!def.balloons->pins[0].to_thing && def.balloons->pins[0].radius == 0.5);
    assert_true(*def.balloons->pins[1].to_thing == 0);
    assert_vector(def.things[0].path[1].rotation, 0, 90, 0);
    assert_int_equal(def.knots_count, 2);
    assert_true(def.knots[0].path[0].at == 1 && def.knots[1].mass == 0.5);
    assert_vector(def.knots[0].path[0].position, 0, 1, 0);
    assert_vector(def.knots[1].position, 1, 2, 3);
    scene_free(&def);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(joined_balloons_keep_their_momenta),
        cmocka_unit_test(a_force_is_the_gradient_of_its_energy),
        cmocka_unit_test(a_tangent_is_the_derivative_of_the_impulse),
        cmocka_unit_test(rest_is_the_same_by_both_methods),
        cmocka_unit_test(a_stiff_joint_is_within_the_stability_bound),
        cmocka_unit_test(a_key_ties_and_unties_joints),
        cmocka_unit_test(a_held_knot_follows_its_path),
        cmocka_unit_test(every_key_of_strings_and_knots_loads_into_its_field),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
