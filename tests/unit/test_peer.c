/// Bullet's soft body behaves as lab/peer/peer.h describes.
#include "bodies.h"
#include "lab/peer/peer.h"

static const double h = 1e-3; ///< [s]

enum { STEPS = 200, MAX_POINTS = 1000 };

/// A cube-sphere of radius 1 with Bullet's defaults.
static Peer* peer_of(const Mesh* mesh, double pressure, double gravity) {
    PeerDef def = peer_def_default();
    def.point_count = mesh->point_count;
    def.point = mesh->point;
    def.triangle_count = mesh->triangle_count;
    def.triangle = (const int(*)[3])mesh->triangle;
    def.pressure = pressure;
    def.gravity = gravity;
    def.margin = 0.05;
    return peer_open(&def);
}

static void run(Peer* peer, int steps) {
    for (int n = 0; n < steps; n++)
        peer_step(peer, h);
}

/// truth: v = -g t, y = -g t (t + h) / 2 of semi-implicit Euler. float: h rounds to 1e-7, and each
/// velocity is a difference of positions, (x' - x) / h, whose roundings of 1e-7 m make 1e-4 m/s.
static void a_skin_falls_freely(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube-sphere:6", &mesh);
    Peer* peer = peer_of(&mesh, 0, 9.81);
    run(peer, STEPS);
    double4 x[MAX_POINTS], v[MAX_POINTS];
    peer_read(peer, x, v);
    const double t = STEPS * h;
    for (int i = 0; i < mesh.point_count; i++) {
        assert_close(mesh.point[i][1] - x[i][1], 9.81 * t * (t + h) / 2, TOLERANCE(0.01, 1e-6));
        assert_close(v[i][1], -9.81 * t, TOLERANCE(0.01, 1e-6));
        assert_near(x[i][0], mesh.point[i][0], TOLERANCE(1e-3, 1e-6));
    }
    peer_close(peer);
    mesh_free(&mesh);
}

static void a_ball_falls_freely(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube-sphere:6", &mesh);
    Peer* peer = peer_of(&mesh, 0, 9.81);
    peer_add_sphere(peer, &(Sphere){.x = {5, 0, 0}, .v = {1, 2, 0}, .radius = 0.5, .mass = 2});
    run(peer, STEPS);
    double4 x, v;
    peer_read_sphere(peer, 0, &x, &v);
    const double t = STEPS * h;
    assert_close(x[0], 5 + t, TOLERANCE(1e-5, 1e-6));
    assert_close(x[1], 2 * t - 9.81 * t * (t + h) / 2, TOLERANCE(1e-3, 1e-6));
    assert_near(v[1], 2 - 9.81 * t, TOLERANCE(1e-4, 1e-6));
    assert_int_equal(peer_contacts(peer, 0), 0);
    peer_close(peer);
    mesh_free(&mesh);
}

static void pressure_makes_a_skin_grow_and_none_leaves_it(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube-sphere:6", &mesh);
    Peer *still = peer_of(&mesh, 0, 0), *blown = peer_of(&mesh, 1000, 0);
    const double first = peer_volume(still);
    assert_close(first, 4.19, 0.05); // nearly that of the unit ball
    run(still, STEPS);
    run(blown, STEPS);
    assert_close(peer_volume(still), first, 1e-5);
    assert_less(1.01 * first, peer_volume(blown));
    peer_close(still);
    peer_close(blown);
    mesh_free(&mesh);
}

/// A ball that flies into the skin touches points, slows down and pushes the skin.
static void a_ball_and_a_skin_push_each_other(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube-sphere:12", &mesh);
    Peer* peer = peer_of(&mesh, 100, 0);
    peer_add_sphere(peer, &(Sphere){.x = {0, 1.5, 0}, .v = {0, -2, 0}, .radius = 0.4, .mass = 1});
    int touched = 0;
    for (int n = 0; n < STEPS; n++) {
        peer_step(peer, h);
        touched += peer_contacts(peer, 0) > 0;
    }
    double4 x, v, point[MAX_POINTS], velocity[MAX_POINTS];
    double down = 0;
    peer_read_sphere(peer, 0, &x, &v);
    peer_read(peer, point, velocity);
    for (int i = 0; i < mesh.point_count; i++)
        down += velocity[i][1] / mesh.point_count;
    assert_less(0, touched);
    assert_less(-2, v[1]);
    assert_less(down, 0);
    peer_close(peer);
    mesh_free(&mesh);
}

static void the_same_input_gives_the_same_state(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube-sphere:6", &mesh);
    double4 x[2][MAX_POINTS], v[2][MAX_POINTS];
    for (int k = 0; k < 2; k++) {
        Peer* peer = peer_of(&mesh, 50, 9.81);
        peer_add_sphere(peer,
                        &(Sphere){.x = {0, 1.4, 0}, .v = {0, -2, 0}, .radius = 0.4, .mass = 1});
        run(peer, STEPS);
        peer_read(peer, x[k], v[k]);
        peer_close(peer);
    }
    assert_memory_equal(x[0], x[1], (size_t)mesh.point_count * sizeof(double4));
    assert_memory_equal(v[0], v[1], (size_t)mesh.point_count * sizeof(double4));
    mesh_free(&mesh);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_skin_falls_freely),
        cmocka_unit_test(a_ball_falls_freely),
        cmocka_unit_test(pressure_makes_a_skin_grow_and_none_leaves_it),
        cmocka_unit_test(a_ball_and_a_skin_push_each_other),
        cmocka_unit_test(the_same_input_gives_the_same_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
