/// Skins that touch: nothing crosses, momenta are kept.
#include "base/random.h"
#include "contact/skins/feature_pair.h"
#include "crossings.h"
#include "momenta.h"

/// The least distance of points of the two, on a grid of their parameters.
static double sampled_distance(FeatureKind kind, const double4 x[4]) {
    enum { N = 200 };
    double nearest = INFINITY;
    for (int i = 0; i <= N; i++)
        for (int j = 0; j <= N; j++) {
            const double s = (double)i / N, t = (double)j / N;
            double4 away;
            if (kind == EDGE_EDGE)
                away = (1 - s) * x[0] + s * x[1] - (1 - t) * x[2] - t * x[3];
            else if (s + t <= 1)
                away = x[0] - (1 - s - t) * x[1] - s * x[2] - t * x[3];
            else
                continue;
            nearest = fmin(nearest, dlength(away));
        }
    return nearest;
}

static void features_have_their_distance(void** state) {
    (void)state;
    Random random = {1};
    for (int n = 0; n < 40; n++) {
        double4 x[4] = {{0}};
        for (int k = 0; k < 4; k++)
            for (int c = 0; c < 3; c++)
                x[k][c] = random_next(&random);
        const FeatureKind kind = n % 2 ? EDGE_EDGE : VERTEX_TRIANGLE;
        double weight[4];
        const double distance = feature_distance(kind, x, weight),
                     sampled = sampled_distance(kind, x);
        assert_true(distance <= sampled + 1e-12);
        assert_near(distance, sampled, 0.01);
        double4 away = {0};
        for (int k = 0; k < 4; k++)
            away += weight[k] * x[k];
        assert_near(dlength(away), distance, 1e-12);
        // a straight path to the mirror image crosses: only a part of it is safe
        double4 to_other_side[4];
        for (int k = 0; k < 4; k++)
            to_other_side[k] = k < (int)kind ? -2 * away : (double4){0};
        const double part = feature_safe_part(kind, x, to_other_side, 0.1);
        assert_true(part > 0 && part <= 0.5);
        assert_near(feature_safe_part(kind, x, (double4[4]){{0}}, 0.1), 1, 0);
    }
}

static void a_heap_never_crosses_by_any_method(void** state) {
    (void)state;
    const char* const method[] = {"euler", "newton", "xpbd", "projective"};
    for (int m = 0; m < 4; m++) {
        char text[40];
        snprintf(text, sizeof text, "method=%s", method[m]);
        World world;
        // Newton's equation with its contacts takes as long for a long step as for a short one
        WORLD_OF(&world, "heap", text, m == 1 ? "step=0.01" : "step=0.001");
        int touched = 0;
        for (int k = 0; k < 4; k++) {
            run_for(&world, 0.1);
            assert_false(world.blowup.halted);
            assert_int_equal(crossings(&world), 0);
            assert_near(probe(&world, "crossings"), 0, 0);
            touched += world.contacts.contact_count;
        }
        assert_true(touched > 0);
        world_close(&world);
    }
}

/// Pairs that are not measured in a part are those that their last distance and the motion since
/// rule out, in lists that hold.
static void a_pair_is_never_nearer_than_its_bound(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "heap", "method=euler");
    long stale = 0;
    for (int n = 0; n < 50; n++) {
        run_for(&world, 0.005);
        const SkinPairs* pairs = &world.contacts.skin_pairs;
        for (int l = 0; l < 9; l++)
            for (int k = 0; k < pairs->list[l].count; k++) {
                const PairList* list = &pairs->list[l];
                const FeaturePair* pair = &list->pair[k];
                double4 x[4];
                double weight[4];
                for (int i = 0; i < 4; i++)
                    x[i] = to_double4(
                        world.balloon[pair->skin[i >= (int)pair->kind]].body.x[pair->node[i]]);
                assert_true(feature_distance(pair->kind, x, weight) - pair->rest_gap >=
                            list->near_from[k] - list->moved);
                stale += pair->measured != pairs->drifts - 1;
            }
    }
    assert_true(stale > 100);
    world_close(&world);
}

/// The long form is `balloon bench heap`.
static void a_heap_comes_to_rest_and_stays(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "heap", "balloons.0.model=icosphere:1", "balloons.1.model=icosphere:1",
             "balloons.2.model=icosphere:1");
    double highest = 0;
    for (int n = 0; n < 40; n++) {
        run_for(&world, 0.25);
        highest = fmax(highest, momenta_of(&world).kinetic);
    }
    assert_true(momenta_of(&world).kinetic < 1e-6 * highest);
    const char* const column[] = {"balloon0.cx", "balloon1.cx", "balloon2.cy", "balloon2.cz"};
    double before[4];
    for (int k = 0; k < 4; k++)
        before[k] = probe(&world, column[k]);
    run_for(&world, 3);
    for (int k = 0; k < 4; k++) // a thousandth of its size in ten minutes
        assert_near(probe(&world, column[k]), before[k], 1e-3 * 0.2 * 3 / 600);
    assert_less(0.2, probe(&world, "balloon2.cy")); // it lies on the two others
    world_close(&world);
}

static void without_contacts_it_crosses(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "heap", "contacts.others=false");
    run_for(&world, 0.3);
    const int count = crossings(&world);
    assert_true(count > 10);
    assert_near(probe(&world, "crossings"), count, 0.05 * count); // it also tests neighbors
    world_close(&world);
}

/// Two balloons of the heap, the others far away, fly at each other.
static void fling(World* world, double speed, const char* step) {
    char text[40];
    snprintf(text, sizeof text, "step=%s", step);
    WORLD_OF(world, "heap", text, "gravity=0", "floor=-100", "walls=[]",
             "balloons.0.damping.rate=0", "balloons.1.damping.rate=0", "balloons.2.damping.rate=0",
             "balloons.2.position=[0, 5, 0]", "balloons.1.position=[0.26, 0.15, 0.02]");
    for (int b = 0; b < 2; b++) {
        Body* body = &world->balloon[b].body;
        for (int i = 0; i < body->count; i++)
            body->v[i][0] = (real)(b == 0 ? speed : -speed);
    }
}

static void a_hit_keeps_momenta_and_crosses_nothing(void** state) {
    (void)state;
    const struct {
        double speed;
        const char* step;
    } hit[] = {{2, "0.001"}, {10, "0.001"}, {20, "0.02"}};
    for (int k = 0; k < 3; k++) {
        World world;
        fling(&world, hit[k].speed, hit[k].step);
        const Momenta before = momenta_of(&world);
        for (int n = 0; n < 5; n++) {
            run_for(&world, fmax(0.1 / hit[k].speed, world.step));
            assert_int_equal(crossings(&world), 0);
        }
        const Momenta after = momenta_of(&world);
        assert_true(after.kinetic < 1.5 * before.kinetic); // their gas is a little above ambient
        assert_momenta(&after, &before, TOLERANCE(1e-5, 1e-12));
        assert_true(world.balloon[0].body.v[0][0] < (real)(0.9 * hit[k].speed)); // they have hit
        world_close(&world);
    }
}

static void skins_that_begin_crossed_touch_once_they_are_apart(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "heap", "gravity=0", "walls=[]", "balloons.1.position=[0.15, 0.117, 0.011]",
             "balloons.1.damping.rate=0", "balloons.0.damping.rate=0");
    assert_true(crossings(&world) > 0);
    world_step(&world);
    const PairList* list = &world.contacts.skin_pairs.list[1];
    assert_true(list->crossed);
    // pulled apart, then pushed together
    const real speed[] = {2, -4};
    for (int k = 0; k < 2; k++) {
        Body* body = &world.balloon[1].body;
        for (int i = 0; i < body->count; i++)
            body->v[i] = (real4){speed[k], 0, 0, 0};
        run_for(&world, 0.08);
        assert_false(list->crossed);
        assert_int_equal(crossings(&world), 0);
    }
    assert_true(probe(&world, "balloon0.px") < -0.01); // it was hit
    world_close(&world);
}

/// Whether a scene of two like balloons, the second at (x, y, 0), says `word` of them at the start.
static bool says_at_start(double x, double y, const char* word) {
    char position[64];
    snprintf(position, sizeof position, "balloons.1.position=[%g, %g, 0]", x, y);
    World world;
    OPEN_TEXT(&world,
              "step: 0.001\n"
              "contacts: {others: true}\n"
              "balloons:\n"
              "  - {model: cube-sphere:6, scale: 0.5, mass: {per_particle: 0.001}}\n"
              "  - {model: cube-sphere:6, scale: 0.5, mass: {per_particle: 0.001}}\n",
              position);
    const bool says = strstr(world.notice, word) != NULL;
    assert_true(says || !world.notice[0]);
    world_close(&world);
    return says;
}

/// Along an axis of their symmetry edges lie on edges, and no triangle is known to pierce another.
static void balloons_that_begin_in_each_other_are_named(void** state) {
    (void)state;
    assert_true(says_at_start(0.6, 0.013, "crosses balloons.1"));
    assert_true(says_at_start(0.6, 0, "meets balloons.1"));
    assert_true(says_at_start(0, 0, "meets balloons.1"));
    assert_false(says_at_start(1.2, 0, "balloons.1"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(features_have_their_distance),
        cmocka_unit_test(a_heap_never_crosses_by_any_method),
        cmocka_unit_test(a_pair_is_never_nearer_than_its_bound),
        cmocka_unit_test(a_heap_comes_to_rest_and_stays),
        cmocka_unit_test(without_contacts_it_crosses),
        cmocka_unit_test(a_hit_keeps_momenta_and_crosses_nothing),
        cmocka_unit_test(balloons_that_begin_in_each_other_are_named),
        cmocka_unit_test(skins_that_begin_crossed_touch_once_they_are_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
