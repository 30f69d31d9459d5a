/// A matrix of throws at a free balloon of radius 1: all combinations of speed, radius, mass and
/// aim, on coarse and fine meshes, with long and short steps. No ball may pass through. Some of the
/// throws are repeated with Bullet's own soft body and judged by the same CCD test.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "base/memory.h"
#include "contact/triangle_path.h"
#include "lab/bench/bench.h"
#include "lab/peer/peer_world.h"
#include "lab/bench/throw.h"

static const double speed_table[] = {1, 5, 10, 20, 50, 100, 200}; ///< [m/s]
static const double radius_table[] = {0.02, 0.05, 0.2, 0.5};      ///< [m], the balloon's is 1
static const double rate_table[] = {60, 240};                     ///< steps a second
static const double mass_table[] = {0.1, 1, 1000};                ///< of the balloon's
static const int side_table[] = {8, 22, 43}; ///< quads a side of the cube-sphere

enum {
    SPEEDS = sizeof speed_table / sizeof *speed_table,
    RADII = sizeof radius_table / sizeof *radius_table,
    RATES = sizeof rate_table / sizeof *rate_table,
    MASSES = sizeof mass_table / sizeof *mass_table,
    SIDES = sizeof side_table / sizeof *side_table,
    THROWS = SPEEDS * RADII * RATES * MASSES * THROW_AIMS,
    QUICK = 37,      ///< a quick run makes every 37th throw; coprime to the tables' lengths
    PEER = 11,       ///< every 11th throw is repeated with Bullet's soft body
    PEER_ROUNDS = 10 ///< rounds over its links: ten times Bullet's default, in its favor
};

/// Sums over the throws at one mesh.
typedef struct Sum {
    int throws;
    int bad; ///< states that blew up
    long pass_throughs;
    double seconds; ///< CPU time [s]
    int peer_throws, peer_through;
} Sum;

/// Whether the path of the ball's center crosses a triangle in a step from `before` to `after`,
/// each the skin's points followed by the ball's center.
static bool passes(const Mesh* mesh, const double4* before, const double4* after) {
    const int ball = mesh->point_count;
    for (int t = 0; t < mesh->triangle_count; t++) {
        double4 a[3], da[3];
        for (int k = 0; k < 3; k++) {
            const int i = mesh->triangle[t][k];
            a[k] = before[i];
            da[k] = after[i] - before[i];
        }
        if (triangle_crossing_time(before[ball], after[ball] - before[ball], a, da) <= 1)
            return true;
    }
    return false;
}

static void read_all(const Peer* peer, int points, double4* x) {
    double4 v;
    peer_read(peer, x, NULL);
    peer_read_sphere(peer, 0, &x[points], &v);
}

/// Whether Bullet's soft body lets the world's ball pass through.
static bool peer_lets_through(const World* world, long steps) {
    const Mesh* mesh = &world->balloon[0].mesh;
    const int points = mesh->point_count;
    double4 *before = new_array(double4, points + 1), *after = new_array(double4, points + 1);
    Peer* peer = peer_of_world(world, PEER_ROUNDS);
    read_all(peer, points, after);
    bool through = false;
    for (long n = 0; n < steps && !through; n++) {
        double4* last = before;
        before = after;
        after = last;
        peer_step(peer, world->step);
        read_all(peer, points, after);
        through = passes(mesh, before, after);
    }
    peer_close(peer);
    free(before);
    free(after);
    return through;
}

static bool throw(const Throw* t, bool with_peer, Sum* sum, Fault* fault) {
    World world;
    if (!throw_open(t, &world, fault))
        return false;
    const long steps = throw_steps(t);
    if (with_peer) {
        sum->peer_throws++;
        sum->peer_through += peer_lets_through(&world, steps);
    }
    const clock_t start = clock();
    for (long n = 0; n < steps && !world.blowup.halted; n++)
        world_step(&world);
    sum->seconds += (double)(clock() - start) / CLOCKS_PER_SEC;
    sum->throws++;
    sum->bad += world.blowup.halted;
    sum->pass_throughs += world.contacts.pass_throughs;
    if (world.blowup.halted || world.contacts.pass_throughs)
        printf("speed %g radius %g rate %g mass %g aim %d: %ld through; %s\n", t->speed, t->radius,
               t->rate, t->mass, t->aim, world.contacts.pass_throughs, world.blowup.text);
    world_close(&world);
    return true;
}

/// All throws on one mesh, or every QUICK-th.
static bool throw_all(int side, bool quick, Sum* sum, Fault* fault) {
    for (int n = 0; n < THROWS; n++) {
        if (quick && n % QUICK != 0)
            continue;
        const Throw t = {.speed = speed_table[n % SPEEDS],
                         .radius = radius_table[n / SPEEDS % RADII],
                         .rate = rate_table[n / SPEEDS / RADII % RATES],
                         .mass = mass_table[n / SPEEDS / RADII / RATES % MASSES],
                         .aim = n / SPEEDS / RADII / RATES / MASSES,
                         .restitution = 0.5,
                         .friction = 0.3,
                         .side = side};
        if (!throw(&t, quick || n % PEER == 0, sum, fault))
            return false;
    }
    return true;
}

static bool measure(const BenchOptions* options, Fault* fault) {
    long through = 0;
    int bad = 0;
    printf("%8s %8s %14s %12s %16s %24s\n", "quads", "throws", "pass-throughs", "went bad",
           "ms a throw", "through Bullet's skin");
    for (int k = 0; k < (options->quick ? 1 : SIDES); k++) {
        Sum sum = {0};
        if (!throw_all(side_table[k], options->quick, &sum, fault))
            return false;
        printf("%8d %8d %14ld %12d %16.1f %17d of %3d\n", 6 * side_table[k] * side_table[k],
               sum.throws, sum.pass_throughs, sum.bad, 1e3 * sum.seconds / sum.throws,
               sum.peer_through, sum.peer_throws);
        fflush(stdout);
        through += sum.pass_throughs;
        bad += sum.bad;
    }
    if (through || bad)
        return fault_set(fault, "bench contacts", "%ld balls passed through, %d states went bad",
                         through, bad);
    return true;
}

const BenchCase bench_contacts = {
    .name = "contacts",
    .about = "a matrix of balls thrown at a balloon; none may pass through",
    .run = measure,
};
