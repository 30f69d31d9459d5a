/// The broad phase misses no triangle near a ball: it finds all within reach, compared with brute
/// force in double, and some more whose boxes are within reach.
#include "bodies.h"
#include "contact/bullet/trees.h"

static double to_segment(double4 p, double4 a, double4 b) {
    const double4 ab = b - a;
    const double long2 = ddot(ab, ab);
    const double t = long2 > 0 ? fmin(fmax(ddot(p - a, ab) / long2, 0), 1) : 0;
    return dlength(p - a - t * ab);
}

/// Distance of a point from a triangle: from its plane above its face, else from its nearest edge.
static double to_triangle(double4 p, const real4* x, const int t[3]) {
    const double4 a = to_double4(x[t[0]]), b = to_double4(x[t[1]]), c = to_double4(x[t[2]]);
    const double4 n = dcross(b - a, c - a);
    double distance = fmin(to_segment(p, a, b), fmin(to_segment(p, b, c), to_segment(p, c, a)));
    if (ddot(n, n) > 0 && ddot(dcross(b - a, p - a), n) >= 0 &&
        ddot(dcross(c - b, p - b), n) >= 0 && ddot(dcross(a - c, p - c), n) >= 0)
        distance = fmin(distance, fabs(ddot(p - a, n)) / dlength(n));
    return distance;
}

/// A skin as a Bullet shape.
typedef struct Case {
    Mesh mesh;
    real4* x;
    BulletSkin* skin;
    int* found;
} Case;

typedef enum Warp { PLAIN, SHAKEN, STRETCHED, FLAT, CRUMPLED, WARPS } Warp;

static double4 warped(double4 p, Warp warp, Random* random) {
    for (int k = 0; k < 3; k++) {
        const double noise = 2 * random_next(random) - 1;
        p[k] += warp == SHAKEN ? 0.1 * noise : 0;
        p[k] *= warp == STRETCHED && k == 0 ? 50 : 1;
        p[k] *= warp == FLAT && k == 1 ? 1e-4 : 1;
        // triangles of all sizes, from needles to the whole skin
        p[k] = warp == CRUMPLED ? noise * pow(10, -4 * random_next(random)) : p[k];
    }
    return p;
}

static void open_case(Case* c, const char* name, double scale, double offset, Warp warp,
                      Random* random) {
    mesh_of(name, &c->mesh);
    c->x = new_array(real4, c->mesh.point_count);
    const double4 origin = {offset, 2 * offset, 3 * offset, 0};
    for (int i = 0; i < c->mesh.point_count; i++)
        c->x[i] = to_real4(scale * warped(c->mesh.point[i], warp, random) + origin);
    c->skin = bullet_skin_open((const int(*)[3])c->mesh.triangle, c->mesh.triangle_count, c->x,
                               c->mesh.point_count);
    c->found = new_array(int, c->mesh.triangle_count);
}

static void close_case(Case* c) {
    bullet_skin_close(c->skin);
    free(c->found);
    free(c->x);
    mesh_free(&c->mesh);
}

static int near(Case* c, double4 center, double reach) {
    return bullet_skin_near(c->skin, (double[]){center[0], center[1], center[2]}, reach, c->found,
                            c->mesh.triangle_count);
}

/// Every triangle within reach is found exactly once, in ascending order.
static void find_all(Case* c, double4 center, double reach) {
    const int count = near(c, center, reach);
    int at = 0;
    for (int t = 0; t < c->mesh.triangle_count; t++) {
        const double distance = to_triangle(center, c->x, c->mesh.triangle[t]);
        if (at < count && c->found[at] == t)
            at++;
        else if (distance <= reach) {
            print_error("triangle %d at %.9g of reach %.9g is missed\n", t, distance, reach);
            fail();
        }
    }
    assert_int_equal(at, count);
}

/// Balls of all sizes: at random around the skin, around one of its points, and exactly at a point.
static void find_all_of(Case* c, int rounds, Random* random) {
    double low[3], high[3];
    bullet_skin_box(c->skin, low, high);
    const double size = hypot(hypot(high[0] - low[0], high[1] - low[1]), high[2] - low[2]);
    for (int round = 0; round < rounds; round++) {
        const double reach = size * pow(10, -4 * random_next(random));
        const int i = (int)(random_next(random) * c->mesh.point_count);
        double4 center = {0};
        for (int k = 0; k < 3; k++) {
            const double noise = 2 * random_next(random) - 1;
            center[k] = round % 3 == 0
                            ? (low[k] + high[k] + 1.4 * noise * (high[k] - low[k])) / 2
                            : (double)c->x[i][k] + noise * reach * (round % 3 == 1 ? 1 : 1e-3);
        }
        find_all(c, center, reach);
    }
}

static void near_finds_what_brute_force_finds(void** state) {
    (void)state;
    const char* name[] = {"icosphere:2", "torus:24x12", "grid:10x10"};
    Random random = {7};
    for (int m = 0; m < 3; m++)
        for (Warp warp = PLAIN; warp < WARPS; warp++)
            for (int far = 0; far < 2; far++) {
                Case c = {0};
                open_case(&c, name[m], 1, far ? 1000 : 0, warp, &random);
                find_all_of(&c, 60, &random);
                close_case(&c);
            }
}

/// Bullet 3.24 drops triangles whose area is near the rounding of 1 m^2: a skin of a millimeter
/// would be missing entirely in float, and so would the needles of a crumpled one.
static void near_finds_the_smallest_triangles(void** state) {
    (void)state;
    Random random = {8};
    for (Warp warp = PLAIN; warp < WARPS; warp++)
        for (int far = 0; far < 2; far++) {
            Case c = {0};
            open_case(&c, "icosphere:2", 1e-3, far ? 10 : 0, warp, &random);
            find_all_of(&c, 60, &random);
            close_case(&c);
        }
}

/// A needle at coordinates that are not round, and a ball that barely touches its face: with a
/// normal in float Bullet's distance from its plane is up to half a reach too large.
static void near_finds_needles(void** state) {
    (void)state;
    Random random = {13};
    const int triangle[1][3] = {{0, 1, 2}};
    for (int round = 0; round < 4000; round++) {
        double4 a = {0}, u = {0}, w = {0};
        for (int k = 0; k < 3; k++) {
            a[k] = 2 * random_next(&random) - 1;
            u[k] = 2 * random_next(&random) - 1;
            w[k] = 2 * random_next(&random) - 1;
        }
        real4 x[4] = {to_real4(a), to_real4(a + u), to_real4(a + u / 3 + pow(10, -round % 8) * w)};
        const double4 n = dcross(u, to_double4(x[2] - x[0]));
        if (dlength(n) == 0)
            continue;
        const double reach = 0.01 + random_next(&random);
        const double4 center = (a + a + u + to_double4(x[2])) / 3 + 0.995 * reach * n / dlength(n);

        int found[1];
        BulletSkin* skin = bullet_skin_open(triangle, 1, x, 3);
        Case c = {.mesh = {.triangle_count = 1, .triangle = (int(*)[3])triangle},
                  .x = x,
                  .skin = skin,
                  .found = found};
        find_all(&c, center, reach);
        bullet_skin_close(skin);
    }
}

static void nothing_near_gives_no_triangle(void** state) {
    (void)state;
    Random random = {9};
    Case c = {0};
    open_case(&c, "icosphere:3", 1, 0, PLAIN, &random);
    assert_int_equal(near(&c, (double4){3, 0, 0, 0}, 1.5), 0); // outside the skin's box
    assert_int_equal(near(&c, (double4){0.9, 0.9, 0.9, 0}, 0.3), 0);
    assert_int_equal(near(&c, (double4){0, 0, 0, 0}, 0.7), 0);
    assert_int_equal(near(&c, (double4){0, 0, 0, 0}, 1.1), c.mesh.triangle_count);
    close_case(&c);
}

static void near_follows_the_skin_once_refitted(void** state) {
    (void)state;
    Random random = {10};
    Case c = {0};
    open_case(&c, "icosphere:2", 1, 0, PLAIN, &random);
    for (int i = 0; i < c.mesh.point_count; i++)
        c.x[i][0] += 5;
    bullet_skin_refit(c.skin, 0);
    find_all_of(&c, 60, &random);
    assert_int_equal(near(&c, (double4){-1, 0, 0, 0}, 0.5), 0);

    double low[3], high[3];
    bullet_skin_box(c.skin, low, high);
    assert_near(low[0], 4, 0.05); // an icosphere's own box is a little smaller than its radius
    assert_near(high[0], 6, 0.05);
    close_case(&c);
}

static void near_tells_the_count_beyond_the_room(void** state) {
    (void)state;
    Random random = {11};
    Case c = {0};
    open_case(&c, "cube", 1, 0, PLAIN, &random);
    int few[3] = {NONE, NONE, NONE};
    const double center[3] = {0, 0, 0};
    assert_int_equal(bullet_skin_near(c.skin, center, 5, few, 2), c.mesh.triangle_count);
    assert_int_equal(few[0], 0);
    assert_int_equal(few[1], 1);
    assert_int_equal(few[2], NONE);
    close_case(&c);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(near_finds_what_brute_force_finds),
        cmocka_unit_test(near_finds_the_smallest_triangles),
        cmocka_unit_test(near_finds_needles),
        cmocka_unit_test(nothing_near_gives_no_triangle),
        cmocka_unit_test(near_follows_the_skin_once_refitted),
        cmocka_unit_test(near_tells_the_count_beyond_the_room),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
