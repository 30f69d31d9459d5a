/// Friction between skins: it keeps both momenta, takes energy, and holds below arctan mu.
#include "base/random.h"
#include "momenta.h"

// ---- one contact ----

/// Four particles of random masses, and a contact of a vertex and a triangle or of two edges of them.
typedef struct Stencil {
    real4 x[4], v[4];
    real mass[4];
    Contact contact;
} Stencil;

static real4 random_vector(Random* random, double size) {
    real4 a = {0, 0, 0, 0};
    for (int k = 0; k < 3; k++)
        a[k] = (real)(size * (2 * random_next(random) - 1));
    return a;
}

static void make_stencil(Stencil* stencil, Random* random, FeatureKind kind, double friction) {
    double4 x[4], arm = {0};
    double weight[4];
    for (int k = 0; k < 4; k++) {
        stencil->x[k] = random_vector(random, 0.1);
        stencil->v[k] = random_vector(random, 1);
        stencil->mass[k] = (real)(1e-4 * (1 + random_next(random)));
        x[k] = to_double4(stencil->x[k]);
    }
    const double distance = feature_distance(kind, x, weight);
    for (int k = 0; k < 4; k++)
        arm += weight[k] * x[k];
    Contact* contact = &stencil->contact;
    *contact = (Contact){.node_count = 4,
                         .normal = to_real4(arm / distance),
                         .friction = (real)friction,
                         .side = {0, 1}};
    for (int k = 0; k < 4; k++)
        contact->node[k] = (ContactNode){&stencil->v[k], &stencil->x[k], (real)weight[k],
                                         (real)weight[k] / stencil->mass[k], stencil->mass[k]};
    contact_set_masses(contact);
    contact_set_couple(contact, arm);
}

static Momenta momenta_of_stencil(const Stencil* stencil) {
    Momenta sum = {0};
    for (int k = 0; k < 4; k++)
        momenta_add(&sum, (double)stencil->mass[k], stencil->x[k], stencil->v[k]);
    return sum;
}

static void one_contact_keeps_momenta_and_takes_energy(void** state) {
    (void)state;
    Random random = {7};
    int slid = 0, stuck = 0;
    for (int n = 0; n < 400; n++) {
        Stencil stencil;
        const double friction = n % 4 * 0.5;
        make_stencil(&stencil, &random, n % 2 ? EDGE_EDGE : VERTEX_TRIANGLE, friction);
        Contact* contact = &stencil.contact;
        const Momenta before = momenta_of_stencil(&stencil);
        contact_solve(&contact, 1, 1e-3);
        const Momenta after = momenta_of_stencil(&stencil);
        assert_momenta(&after, &before, TOLERANCE(1e-5, 1e-12));
        assert_true(after.kinetic <= before.kinetic * (1 + TOLERANCE(1e-6, 1e-14)));
        const double tangent = (double)length(contact->tangent_impulse),
                     bound = friction * (double)contact->normal_impulse;
        assert_true(tangent <= bound * (1 + TOLERANCE(1e-6, 1e-14)));
        if (friction == 0 || bound == 0)
            continue;
        slid += tangent > 0.999 * bound;
        stuck += tangent < 0.999 * bound;
        if (tangent < 0.999 * bound) // nothing of u is left
            assert_near((double)length(contact_relative_velocity(contact)), 0, 0.01);
    }
    assert_true(slid > 20 && stuck > 20);
}

static void a_rigid_motion_rubs_nothing(void** state) {
    (void)state;
    Random random = {8};
    for (int n = 0; n < 100; n++) {
        Stencil stencil;
        make_stencil(&stencil, &random, n % 2 ? EDGE_EDGE : VERTEX_TRIANGLE, 1);
        const real4 velocity = random_vector(&random, 1), spin = random_vector(&random, 20);
        for (int k = 0; k < 4; k++)
            stencil.v[k] = velocity + cross(spin, stencil.x[k]);
        assert_near((double)length(contact_relative_velocity(&stencil.contact)), 0,
                    TOLERANCE(1e-5, 1e-13));
    }
}

// ---- two balloons ----

static void a_rubbing_hit_keeps_momenta_and_takes_energy(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "heap", "gravity=0", "floor=-100", "walls=[]", "contacts.friction=1.5",
             "balloons.0.damping.rate=0", "balloons.1.damping.rate=0",
             "balloons.0.inflation={law: none}", "balloons.1.inflation={law: none}",
             "balloons.2.position=[0, 5, 0]", "balloons.1.position=[0.19, 0.2, 0.03]");
    for (int b = 0; b < 2; b++) {
        Body* body = &world.balloon[b].body;
        for (int i = 0; i < body->count; i++)
            body->v[i][0] = (real)(b == 0 ? 2 : -2);
    }
    Momenta before = {0}, after = {0};
    for (int k = 0; k < 2; k++) {
        Momenta* sum = k == 0 ? &before : &after;
        for (int b = 0; b < 2; b++)
            for (int i = 0; i < world.balloon[b].body.count; i++) {
                const Body* body = &world.balloon[b].body;
                momenta_add(sum, (double)body->mass[i], body->x[i], body->v[i]);
            }
        if (k == 0)
            run_for(&world, 0.05);
    }
    assert_momenta(&after, &before, TOLERANCE(1e-5, 1e-12));
    assert_true(after.kinetic < before.kinetic);
    world_close(&world);
}

// ---- a slope ----

static real4 tilted(double angle, double along, double up, double across) {
    return (real4){(real)(along * cos(angle) + up * sin(angle)),
                   (real)(up * cos(angle) - along * sin(angle)), (real)across, 0};
}

/// A box slides on a sheet that is held still, tilted by so many degrees: how fast it is in the end,
/// down the slope [m/s].
static double speed_on_slope(const char* method, double friction, double degrees, double seconds,
                             const char* step) {
    char by[40], mu[60], h[40];
    snprintf(by, sizeof by, "method=%s", method);
    snprintf(mu, sizeof mu, "contacts={others: true, friction: %g}", friction);
    snprintf(h, sizeof h, "step=%s", step);
    World world;
    WORLD_OF(&world, "heap", by, h, mu, "floor=-100", "walls=[]", "balloons.0.model=grid:6x6",
             "balloons.0.inflation={law: none}", "balloons.1.model=cube:2",
             "balloons.1.skin.springs.shear=20", "balloons.1.inflation={law: none}",
             "balloons.2.position=[0, 5, 0]");
    const double angle = degrees * acos(-1) / 180;
    Body *sheet = &world.balloon[0].body, *box = &world.balloon[1].body;
    for (int i = 0; i < sheet->count; i++) {
        const double4 p = sheet->mesh->point[i];
        sheet->inverse_mass[i] = 0;
        sheet->x[i] = tilted(angle, 0.3 * p[0], 0, 0.3 * (p[1] + p[2]));
    }
    double low = 0;
    for (int i = 0; i < box->count; i++)
        low = fmin(low, box->mesh->point[i][1]);
    for (int i = 0; i < box->count; i++) {
        const double4 p = box->scale * (box->mesh->point[i] - (double4){0, low, 0, 0});
        box->x[i] = tilted(angle, p[0] + 0.013, p[1] + 0.011, p[2] + 0.007);
    }
    run_for(&world, seconds);
    assert_false(world.blowup.halted);
    double4 velocity = {0};
    for (int i = 0; i < box->count; i++)
        velocity += to_double4(box->v[i]) / box->count;
    world_close(&world);
    return velocity[0] * cos(angle) - velocity[1] * sin(angle);
}

/// truth: it slides where the slope is steeper than arctan mu; drag of 3 /s ends at
/// g (sin - mu cos) / 3, here 0.064 m/s.
static void a_box_slides_above_arctan_mu_and_sticks_below_by_every_method(void** state) {
    (void)state;
    const struct {
        const char *method, *step;
    } by[] = {{"euler", "0.001"}, {"newton", "0.01"}, {"xpbd", "0.002"}, {"projective", "0.002"}};
    const double mu = 0.5, limit = atan(mu) * 180 / acos(-1);
    for (int k = 0; k < 4; k++) {
        const double below = speed_on_slope(by[k].method, mu, limit - 1, 1, by[k].step),
                     above = speed_on_slope(by[k].method, mu, limit + 1, 1, by[k].step);
        assert_near(below, 0, 0.003); // the landing's last vibrations
        assert_near(above, 0.064, 0.015);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_contact_keeps_momenta_and_takes_energy),
        cmocka_unit_test(a_rigid_motion_rubs_nothing),
        cmocka_unit_test(a_rubbing_hit_keeps_momenta_and_takes_energy),
        cmocka_unit_test(a_box_slides_above_arctan_mu_and_sticks_below_by_every_method),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
