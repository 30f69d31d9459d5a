/// Random encounters, and skins that are crushed to nothing: no triangle ever crosses another.
#include "base/random.h"
#include "crossings.h"
#include "lab/bench/encounter.h"
#include "momenta.h"

/// Crush a balloon along a random axis until its layers are a few numbers of the state's precision
/// apart, and let it tumble and fly.
static void crush(World* world, Random* random, double share) {
    const Body* body = &world->balloon[0].body;
    double4 axis = {0}, spin = {0}, speed = {0}, middle = {0};
    for (int k = 0; k < 3; k++) {
        axis[k] = random_next(random) - 0.5;
        spin[k] = 2000 * (random_next(random) - 0.5);
        speed[k] = 20 * (random_next(random) - 0.5);
        middle[k] = 2 * random_next(random) - 1;
    }
    axis /= dlength(axis);
    for (int i = 0; i < body->count; i++) {
        double4 r = to_double4(body->x[i]);
        r -= (1 - share) * ddot(axis, r) * axis;
        body->x[i] = to_real4(middle + r);
        body->v[i] = to_real4(speed + dcross(spin, r));
    }
}

static void crushed_skins_that_tumble_cross_nothing(void** state) {
    (void)state;
    Random random = {7};
    int looked_at = 0;
    long in_zones = 0;
    for (int n = 0; n < 10; n++) {
        World world;
        OPEN_TEXT(&world,
                  "step: 1e-3\ngravity: 0\ncontacts: {self: true}\nballoons:\n"
                  "  - model: icosphere:1\n    size: 0.2\n    mass: {per_particle: 0.0001}\n"
                  "    skin: {springs: {structural: 1e-4}}\n");
        crush(&world, &random, TOLERANCE(2e-6, 4e-15));
        if (crossings(&world) > 0) { // rounding has crossed it
            world_close(&world);
            continue;
        }
        looked_at++;
        const Momenta before = momenta_of(&world);
        for (int k = 0; k < 6; k++) {
            world_step(&world);
            assert_false(world.blowup.halted);
            assert_int_equal(crossings(&world), 0);
        }
        in_zones += world.contacts.zone_particles;
        const Momenta after = momenta_of(&world);
        assert_true(after.kinetic < (1 + TOLERANCE(1e-3, 1e-9)) * before.kinetic);
        assert_near(dlength(after.linear - before.linear), 0,
                    TOLERANCE(1e-4, 1e-10) * before.linear_size);
        world_close(&world);
    }
    assert_true(looked_at >= 5);
    assert_true(in_zones > 1000);
}

/// The long form is `balloon bench encounters`.
static void random_encounters_cross_nothing(void** state) {
    (void)state;
    const uint64_t seed[] = {6, 8, 10, 11, 36};
    for (size_t k = 0; k < sizeof seed / sizeof *seed; k++) {
        Encounter encounter;
        Fault fault = {0};
        assert_true(encounter_open(&encounter, seed[k], true, &fault));
        assert_int_equal(exact_crossings_of_world(&encounter.world), 0);
        while (encounter_go_on(&encounter))
            assert_int_equal(exact_crossings_of_world(&encounter.world), 0);
        assert_false(encounter.world.blowup.halted);
        encounter_close(&encounter);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crushed_skins_that_tumble_cross_nothing),
        cmocka_unit_test(random_encounters_cross_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
