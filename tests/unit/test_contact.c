/// Contacts: impulses and their invariants; paths through triangles.
#include "bodies.h"
#include "contact/ball_triangle.h"
#include "contact/triangle_path.h"
#include "contact/ccd.h"

static const Sphere ball = {.radius = 0.3, .mass = 0.02, .restitution = 0.5, .friction = 0.4};

static Contact contact_of(Sphere* sphere, Body* body, int triangle, real side) {
    Contact contact;
    ball_triangle_contact(&contact, sphere, body, triangle, side);
    contact_set_masses(&contact);
    return contact;
}

/// A ball that moves down on one particle of a cube, and nothing else.
static Contact head_on(Sphere* sphere, Body* body, double speed) {
    int top = 0;
    for (int i = 0; i < body->count; i++)
        if (body->mesh->point[i][1] > 0 && body->mesh->point[i][0] > 0)
            top = i;
    int triangle = 0;
    for (int t = 0; t < body->mesh->triangle_count; t++)
        for (int k = 0; k < 3; k++)
            if (body->mesh->triangle[t][k] == top)
                triangle = t;
    const real4 n = {(real)0.6, (real)0.8, 0, 0};
    sphere->x = body->x[top] + sphere->radius * n;
    sphere->v = -(real)speed * n;
    Contact contact = contact_of(sphere, body, triangle, 1);
    contact.first = true;
    return contact;
}

/// truth: j = -(1+e) v_n / (1/m + 1/M), and dKE = -(1-e^2)/2 mM/(m+M) v_n^2.
static void a_hit_takes_the_energy_of_its_restitution(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube", &mesh);
    for (double e = 0; e <= 1; e += 0.25) {
        Body body;
        body_of(&mesh, &body);
        Sphere sphere = ball;
        sphere.friction = 0;
        sphere.restitution = (real)e;
        Contact contact = head_on(&sphere, &body, 2);
        assert_near((double)contact.gap, 0, TOLERANCE(1e-6, 1e-14));
        const ContactReport report = contact_solve(&(Contact*){&contact}, 1, 1e-3);
        const double m = paper_mass, M = 0.02, reduced = m * M / (m + M);
        assert_close((double)contact.normal_impulse, (1 + e) * 2 * reduced, TOLERANCE(1e-4, 1e-12));
        // float: the energy is a difference of numbers that round to 1e-7
        assert_near(report.kinetic, -(1 - e * e) / 2 * reduced * 4, TOLERANCE(1e-8, 1e-15));
        body_free(&body);
    }
    mesh_free(&mesh);
}

static void a_ball_in_reach_but_not_there_yet_just_touches(void** state) {
    (void)state;
    Mesh mesh;
    Body body;
    mesh_of("cube", &mesh);
    body_of(&mesh, &body);
    Sphere sphere = ball;
    sphere.restitution = 0;
    Contact contact = head_on(&sphere, &body, 2);
    const real4 n = contact.normal;
    sphere.x += (real)0.001 * n;
    contact = contact_of(&sphere, &body, contact.feature, 1);
    const double h = 1e-3; // would go 0.002
    contact_solve(&(Contact*){&contact}, 1, h);
    assert_near((double)dot(n, contact_relative_velocity(&contact)) * h, -0.001,
                TOLERANCE(1e-6, 1e-12));

    // and one that does not reach it is not changed
    sphere.v = -(real)0.5 * n;
    for (int k = 1; k < CONTACT_NODES; k++)
        *contact.node[k].velocity = (real4){0};
    const ContactReport report = contact_solve(&(Contact*){&contact}, 1, h);
    assert_near(report.kinetic, 0, 0);
    body_free(&body);
    mesh_free(&mesh);
}

/// No restitution below the speed that the forces give a resting contact in one kick.
static void a_hit_slower_than_its_least_does_not_bounce(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube", &mesh);
    for (int faster = 0; faster < 2; faster++) {
        Body body;
        body_of(&mesh, &body);
        Sphere sphere = ball;
        sphere.friction = 0;
        const double speed = 2;
        Contact contact = head_on(&sphere, &body, speed);
        contact.min_bounce_speed = (real)(faster ? 1.99 : 2.01);
        contact_solve(&(Contact*){&contact}, 1, 1e-3);
        const double bounced = faster ? (double)sphere.restitution * speed : 0;
        assert_near((double)dot(contact.normal, contact_relative_velocity(&contact)), bounced,
                    TOLERANCE(1e-4, 1e-12)); // float: the gap rounds to 1e-7, over h
        body_free(&body);
    }
    mesh_free(&mesh);
}

enum { BALLS = 3, CONTACTS = 400 };

/// All contacts as one island, as an array of pointers for the solver.
static ContactReport solve_all(Contact* contact, int count, double h) {
    Contact* list[CONTACTS];
    for (int k = 0; k < count; k++)
        list[k] = &contact[k];
    return contact_solve(list, count, h);
}

/// Three fast, spinning balls pressed into a moving sphere: all triangles near each of them.
static int crowd(Body* body, Sphere* sphere, Contact* contact, Random* random) {
    int count = 0;
    for (int i = 0; i < body->count; i++)
        for (int k = 0; k < 3; k++)
            body->v[i][k] = (real)(4 * random_next(random) - 2);
    for (int s = 0; s < BALLS; s++) {
        sphere[s] = (Sphere){.radius = (real)(0.1 + 0.4 * random_next(random)),
                             .mass = (real)pow(10, -4 + 5 * random_next(random)),
                             .restitution = (real)random_next(random),
                             .friction = (real)random_next(random)};
        for (int k = 0; k < 3; k++) {
            sphere[s].x[k] = (real)(2 * random_next(random) - 1);
            sphere[s].v[k] = (real)(40 * random_next(random) - 20);
            sphere[s].spin[k] = (real)(40 * random_next(random) - 20);
        }
        sphere[s].x *= (1 + (real)0.9 * sphere[s].radius) / length(sphere[s].x);
        for (int t = 0; t < body->mesh->triangle_count && count < CONTACTS; t++) {
            Contact c = contact_of(&sphere[s], body, t, 1);
            c.first = random_next(random) < 0.5;
            if (c.gap < (real)0.2 * sphere[s].radius)
                contact[count++] = c;
        }
    }
    return count;
}

typedef struct Totals {
    double4 linear, angular;
    double kinetic, sum;
} Totals;

static Totals totals(const Body* body, const Sphere* sphere) {
    Totals total = {{0}, {0}, 0, 0};
    for (int i = 0; i < body->count; i++) {
        const double m = (double)body->mass[i];
        const double4 x = to_double4(body->x[i]), v = to_double4(body->v[i]);
        total.linear += m * v;
        total.angular += m * dcross(x, v);
        total.kinetic += 0.5 * m * ddot(v, v);
        total.sum += m * dlength(v);
    }
    for (int s = 0; s < BALLS; s++) {
        const double m = (double)sphere[s].mass, inertia = (double)sphere_inertia(&sphere[s]);
        const double4 x = to_double4(sphere[s].x), v = to_double4(sphere[s].v),
                      w = to_double4(sphere[s].spin);
        total.linear += m * v;
        total.angular += m * dcross(x, v) + inertia * w;
        total.kinetic += 0.5 * m * ddot(v, v) + 0.5 * inertia * ddot(w, w);
        total.sum += m * dlength(v);
    }
    return total;
}

static void crowded_solves_keep_momenta_and_raise_no_energy(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube-sphere:8", &mesh);
    Random random = {3};
    Contact* contact = new_array(Contact, CONTACTS);
    for (int trial = 0; trial < 60; trial++) {
        Body body;
        Sphere sphere[BALLS];
        body_of(&mesh, &body);
        const int count = crowd(&body, sphere, contact, &random);
        assert_true(count > 3);
        const Totals before = totals(&body, sphere);
        const ContactReport report = solve_all(contact, count, 1e-3);
        const Totals after = totals(&body, sphere);
        assert_near(dlength(after.linear - before.linear), 0, TOLERANCE(1e-5, 1e-12) * before.sum);
        assert_near(dlength(after.angular - before.angular), 0,
                    TOLERANCE(1e-5, 1e-12) * 2 * before.sum);
        assert_near(after.kinetic - before.kinetic, report.kinetic,
                    TOLERANCE(3e-5, 1e-12) * before.kinetic);
        assert_true(after.kinetic <= before.kinetic * (1 + TOLERANCE(1e-6, 1e-13)));
        for (int k = 0; k < count; k++)
            assert_true(length(contact[k].tangent_impulse) <=
                        contact[k].friction * contact[k].normal_impulse * (1 + 1e-5) + 1e-12);
        body_free(&body);
    }
    free(contact);
    mesh_free(&mesh);
}

/// No gap is below zero after the drift for which the contacts were solved.
static void solved_contacts_hold(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube-sphere:8", &mesh);
    Random random = {5};
    Contact* contact = new_array(Contact, CONTACTS);
    for (int trial = 0; trial < 30; trial++) {
        Body body;
        Sphere sphere[BALLS];
        const double h = 1e-3;
        body_of(&mesh, &body);
        const int count = crowd(&body, sphere, contact, &random);
        for (int k = 0; k < count; k++)
            contact[k].friction = contact[k].restitution = 0;
        const ContactReport report = solve_all(contact, count, h);
        for (int k = 0; k < count; k++) {
            const Contact* c = &contact[k];
            const double min = c->gap > 0 ? -(double)c->gap / h : 0;
            // residual after the maximum number of iterations, relative to speeds of 20
            assert_true((double)dot(c->normal, contact_relative_velocity(c)) > min - 0.2);
        }
        assert_true(report.iterations > 0);
        body_free(&body);
    }
    free(contact);
    mesh_free(&mesh);
}

static void the_nearest_point_is_the_nearest(void** state) {
    (void)state;
    Mesh mesh;
    Body body;
    mesh_of("icosphere:1", &mesh);
    body_of(&mesh, &body);
    shake(&body, 0.3);
    Random random = {9};
    for (int trial = 0; trial < 300; trial++) {
        Sphere sphere = ball;
        for (int k = 0; k < 3; k++)
            sphere.x[k] = (real)(4 * random_next(&random) - 2);
        const int t = trial % mesh.triangle_count;
        const Contact c = contact_of(&sphere, &body, t, 1);
        const double got = (double)(c.gap + sphere.radius);
        double want = INFINITY;
        enum { GRID = 60 };
        for (int i = 0; i <= GRID; i++)
            for (int j = 0; j <= GRID - i; j++) {
                const int* corner = mesh.triangle[t];
                const double u = (double)i / GRID, v = (double)j / GRID;
                const double4 p = (1 - u - v) * to_double4(body.x[corner[0]]) +
                                  u * to_double4(body.x[corner[1]]) +
                                  v * to_double4(body.x[corner[2]]);
                want = fmin(want, dlength(to_double4(sphere.x) - p));
            }
        assert_true(got <= want + 1e-6);
        assert_near(got, want, 0.03); // the grid's own coarseness
        assert_near((double)(c.node[1].weight + c.node[2].weight + c.node[3].weight), -1,
                    TOLERANCE(3e-7, 1e-15));
    }
    body_free(&body);
    mesh_free(&mesh);
}

static void winding_tells_inside_from_outside(void** state) {
    (void)state;
    const char* names[] = {"cube-sphere:6", "torus:16x8"};
    Mesh mesh;
    Body body;
    for (int k = 0; k < 2; k++) {
        mesh_of(names[k], &mesh);
        body_of(&mesh, &body);
        const double4 inside = k ? (double4){1, 0, 0, 0} : (double4){0.2, -0.3, 0.1, 0};
        assert_near(winding_number(&mesh, body.x, inside), 1, TOLERANCE(1e-5, 1e-12));
        assert_near(winding_number(&mesh, body.x, (double4){0, 3, 0, 0}), 0,
                    TOLERANCE(1e-5, 1e-12));
        if (k)
            assert_near(winding_number(&mesh, body.x, (double4){0}), 0, TOLERANCE(1e-5, 1e-12));
        body_free(&body);
        mesh_free(&mesh);
    }
}

static void paths_through_moving_triangles_are_found(void** state) {
    (void)state;
    const double4 still[3] = {{0}, {0}, {0}};
    const double4 a[3] = {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}};
    const double4 above = {0.25, 1, 0.25, 0}, down = {0, -4, 0, 0};
    assert_near(triangle_crossing_time(above, down, a, still), 0.25, 1e-12);
    assert_near(triangle_crossing_time(above, -down, a, still), 2, 0);
    assert_near(triangle_crossing_time((double4){0.8, 1, 0.8, 0}, down, a, still), 2, 0);

    // the triangle rises through a resting point, and meets a falling one halfway
    const double4 up[3] = {{0, 2, 0, 0}, {0, 2, 0, 0}, {0, 2, 0, 0}};
    assert_near(triangle_crossing_time(above, (double4){0}, a, up), 0.5, 1e-12);
    assert_near(triangle_crossing_time(above, (double4){0, -2, 0, 0}, a, up), 0.25, 1e-12);

    // a rotating triangle crosses the point at the angle where its plane contains it
    const double4 tip[3] = {{0}, {0, 2, 0, 0}, {0}};
    const double t = triangle_crossing_time((double4){0.4, 0.3, 0.2, 0}, (double4){0}, a, tip);
    assert_near(2 * t * 0.4, 0.3, 1e-9);
}

/// A center within a rounding of a triangle ends at the rounded position of the state, which may be
/// on the other side although the exact end of the path is not.
static void paths_end_where_the_drift_rounds_to(void** state) {
    (void)state;
    Mesh mesh;
    Body body;
    mesh_of("cube", &mesh);
    body_of(&mesh, &body);
    const int* corner = mesh.triangle[0];
    const real level = 8, above = level * REAL_EPSILON; // the next number after 8
    body.x[corner[0]] = (real4){0, level, 0, 0};
    body.x[corner[1]] = (real4){1, level, 0, 0};
    body.x[corner[2]] = (real4){0, level, 1, 0};
    Sphere sphere = ball;
    sphere.x = (real4){(real)0.25, level, (real)0.25, 0};
    sphere.x[1] += above;
    const real shares[] = {(real)0.7, (real)0.3};
    for (int k = 0; k < 2; k++) {
        sphere.v = (real4){0, -shares[k] * above, 0, 0};
        const Contact contact = contact_of(&sphere, &body, 0, 1);
        assert_true(sphere.x[1] + sphere.v[1] == (k ? sphere.x[1] : level));
        assert_int_equal(ccd_passes_through(&contact, 1), k == 0);
    }
    body_free(&body);
    mesh_free(&mesh);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hit_takes_the_energy_of_its_restitution),
        cmocka_unit_test(a_ball_in_reach_but_not_there_yet_just_touches),
        cmocka_unit_test(a_hit_slower_than_its_least_does_not_bounce),
        cmocka_unit_test(crowded_solves_keep_momenta_and_raise_no_energy),
        cmocka_unit_test(solved_contacts_hold),
        cmocka_unit_test(the_nearest_point_is_the_nearest),
        cmocka_unit_test(winding_tells_inside_from_outside),
        cmocka_unit_test(paths_through_moving_triangles_are_found),
        cmocka_unit_test(paths_end_where_the_drift_rounds_to),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
