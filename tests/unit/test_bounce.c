/// A ball bounces on the floor to the heights that Newton's law of restitution gives.
#include "contact/contacts.h"
#include "law.h"

static const double gravity = 9.81;
static const Plane floor_plane = {.normal = {0, 1, 0, 0}};

static void open_at(Contacts* contacts, double height, double radius, double restitution) {
    const Sphere ball = {.x = {0, (real)height, 0, 0},
                         .radius = (real)radius,
                         .mass = 1,
                         .restitution = (real)restitution};
    contacts_open(contacts, CONTACT_IMPULSE, gravity, &floor_plane, 1, (SkinContacts){0}, NULL,
                  NULL, 0);
    contacts_add(contacts, &ball);
}

/// A step of a world, in as many drifts as contacts allow.
static void step_ball(Contacts* contacts, double h) {
    for (double remaining = h; remaining > 1e-12 * h;) {
        const double safe = contacts_safe_step(contacts, remaining);
        const double drift = contacts_velocities(contacts, safe);
        contacts_drift(contacts, drift);
        remaining -= drift;
    }
}

/// Maximum heights above the floor between bounces.
static void find_tops(double radius, double restitution, double h, double* top, int count) {
    Contacts contacts;
    open_at(&contacts, 1 + radius, radius, restitution);
    double before = 1, now = 1;
    for (int found = 0; found < count;) {
        step_ball(&contacts, h);
        const double next = (double)contacts.sphere[0].x[1] - radius;
        if (now > before && now >= next)
            top[found++] = now;
        before = now;
        now = next;
    }
    contacts_close(&contacts);
}

static const double steps[] = {5e-4, 1e-3, 2e-3}, radii[] = {0.02, 0.1, 0.5};

/// e^2, e^4, e^6 of the height.
static void tops_fall_by_the_square_of_the_restitution(void** state) {
    (void)state;
    for (int k = 0; k < 9; k++) {
        double top[3];
        find_tops(radii[k / 3], 0.8, steps[k % 3], top, 3);
        for (int n = 0; n < 3; n++)
            assert_close(top[n], pow(0.64, n + 1), 0.005);
    }
}

/// The first kick is a whole one, g h^2 / 8 of height; the rest is rounding of twelve bounces.
static void elastic_ball_keeps_its_height(void** state) {
    (void)state;
    for (int k = 0; k < 9; k++) {
        double top[12];
        const double h = steps[k % 3];
        find_tops(radii[k / 3], 1, h, top, 12);
        for (int n = 0; n < 12; n++)
            assert_near(top[n], 1, gravity * h * h / 8 + TOLERANCE(5e-5, 1e-5));
    }
}

static void tiny_ball_comes_to_rest_at_its_radius(void** state) {
    (void)state;
    for (int k = 0; k < 3; k++) {
        Contacts contacts;
        const double radius = 1e-3;
        open_at(&contacts, 1, radius, 0.8);
        for (int n = 0; n * steps[k] < 6; n++)
            step_ball(&contacts, steps[k]);
        assert_close(contacts.sphere[0].x[1], radius, 1e-4);
        assert_near(contacts.sphere[0].v[1], 0, 1e-6);
        contacts_close(&contacts);
    }
}

/// A ball that begins below the floor, also with an upward velocity, comes out at 1 m/s at most and
/// then rests on it.
static void ball_below_the_floor_comes_out_gently(void** state) {
    (void)state;
    for (int k = 0; k < 9; k++) {
        Contacts contacts;
        const double radius = radii[k / 3], h = steps[k % 3];
        open_at(&contacts, -radius, radius, 0.8);
        contacts.sphere[0].v[1] = 5;
        for (int n = 0; n * h < 5; n++) {
            step_ball(&contacts, h);
            assert_less(contacts.sphere[0].v[1], 1 + 1e-5);
            assert_less(contacts.sphere[0].x[1], 1.1 * radius);
        }
        assert_close(contacts.sphere[0].x[1], radius, 1e-4);
        contacts_close(&contacts);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tops_fall_by_the_square_of_the_restitution),
        cmocka_unit_test(elastic_ball_keeps_its_height),
        cmocka_unit_test(tiny_ball_comes_to_rest_at_its_radius),
        cmocka_unit_test(ball_below_the_floor_comes_out_gently),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
