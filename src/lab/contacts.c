/// The matrix of throws: a ball of any speed, size and mass at a free balloon of radius 1, from any
/// side, on coarse and fine meshes, at coarse and fine steps. Nothing may pass through.
#include <math.h>
#include <stdio.h>
#include <time.h>

#include "lab/bench.h"
#include "world/world.h"

static const double speed_table[] = {1, 5, 10, 20, 50, 100, 200}; ///< [m/s]
static const double radius_table[] = {0.02, 0.05, 0.2, 0.5};      ///< [m], the balloon's is 1
static const double rate_table[] = {60, 240};                     ///< steps a second
static const double mass_table[] = {0.1, 1, 1000};                ///< of the balloon's
static const int side_table[] = {8, 22, 43}; ///< quads a side of the cube-sphere

/// From where the ball comes, and how far off the middle it aims.
static const struct {
    double from[3], off[3];
} way_table[] = {
    {{1, 0, 0}, {0, 0, 0}},                 // at the middle of a patch
    {{0.577, 0.577, 0.577}, {0, 0, 0}},     // at a corner of valence 3
    {{-0.36, 0.48, 0.8}, {0.2, -0.1, 0.3}}, // somewhere
    {{0, 1, 0}, {0.85, 0, 0}},              // it grazes
};

enum {
    SPEEDS = sizeof speed_table / sizeof *speed_table,
    RADII = sizeof radius_table / sizeof *radius_table,
    RATES = sizeof rate_table / sizeof *rate_table,
    MASSES = sizeof mass_table / sizeof *mass_table,
    SIDES = sizeof side_table / sizeof *side_table,
    WAYS = sizeof way_table / sizeof *way_table,
    SETS = 7
};

typedef struct Throw {
    double speed, radius, rate, mass;
    int side, way;
} Throw;

/// What a mesh's throws added up to.
typedef struct Sum {
    int throws;
    int bad; ///< states that blew up
    long pass_throughs;
    double seconds; ///< CPU time [s]
} Sum;

static bool open_throw(const Throw* t, World* world, Fault* fault) {
    const double* from = way_table[t->way].from;
    const double* off = way_table[t->way].off;
    const double away = 1.6 + t->radius, balloon = 1e-3 * (6 * t->side * t->side + 2);
    double x[3], v[3];
    for (int k = 0; k < 3; k++) {
        x[k] = away * from[k] + off[k];
        v[k] = -t->speed * from[k];
    }
    char model[64], step[64], ball[512];
    snprintf(model, sizeof model, "cube-sphere:%d", t->side);
    snprintf(step, sizeof step, "step=%.17g", 1 / t->rate);
    snprintf(ball, sizeof ball,
             "spheres=[{position: [%.17g, %.17g, %.17g], velocity: [%.17g, %.17g, %.17g], "
             "radius: %.17g, mass: %.17g, restitution: 0.5, friction: 0.3}]",
             x[0], x[1], x[2], v[0], v[1], v[2], t->radius, t->mass * balloon);
    const SceneSet set[SETS] = {{step},
                                {ball},
                                {"gravity=0"},
                                {"balloons.0.strings=[]"},
                                {"balloons.0.helium={base: 0}"},
                                {"balloons.0.damping={coefficient: 0}"},
                                {"balloons.0.inflation={law: area, amount: 2}"}};
    WorldDef def;
    return scene_load(model, set, SETS, &def, fault) && world_open(world, &def, fault);
}

/// Long enough for the ball to go through, from one side to the other.
static bool throw(const Throw* t, Sum* sum, Fault* fault) {
    World world;
    if (!open_throw(t, &world, fault))
        return false;
    const clock_t start = clock();
    const long steps = lround(fmin(1, 4 / t->speed + 0.1) * t->rate);
    for (long n = 0; n < steps && !world.blowup.halted; n++)
        world_step(&world);
    sum->seconds += (double)(clock() - start) / CLOCKS_PER_SEC;
    sum->throws++;
    sum->bad += world.blowup.halted;
    sum->pass_throughs += world.collide.pass_throughs;
    if (world.blowup.halted || world.collide.pass_throughs)
        printf("speed %g radius %g rate %g mass %g way %d: %ld through; %s\n", t->speed, t->radius,
               t->rate, t->mass, t->way, world.collide.pass_throughs, world.blowup.text);
    world_close(&world);
    return true;
}

/// The throws on one mesh: all of them, or one in each row of the matrix in turn.
static bool throw_all(int side, bool quick, Sum* sum, Fault* fault) {
    for (int n = 0; n < SPEEDS * RADII * RATES * MASSES * WAYS; n++) {
        if (quick && n % 37 != 0) // shares no factor with the table's lengths
            continue;
        const Throw t = {.speed = speed_table[n % SPEEDS],
                         .radius = radius_table[n / SPEEDS % RADII],
                         .rate = rate_table[n / SPEEDS / RADII % RATES],
                         .mass = mass_table[n / SPEEDS / RADII / RATES % MASSES],
                         .way = n / SPEEDS / RADII / RATES / MASSES,
                         .side = side};
        if (!throw(&t, sum, fault))
            return false;
    }
    return true;
}

static bool run(bool quick, Fault* fault) {
    long through = 0;
    int bad = 0;
    printf("%8s %8s %14s %12s %16s\n", "quads", "throws", "pass-throughs", "went bad",
           "ms a throw");
    for (int k = 0; k < (quick ? 1 : SIDES); k++) {
        Sum sum = {0};
        if (!throw_all(side_table[k], quick, &sum, fault))
            return false;
        printf("%8d %8d %14ld %12d %16.1f\n", 6 * side_table[k] * side_table[k], sum.throws,
               sum.pass_throughs, sum.bad, 1e3 * sum.seconds / sum.throws);
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
    .run = run,
};
