/// Time of a step against the size of the skin: springs under area inflation and rubber with gas,
/// explicit, one thread, from 1,000 to a million particles; a second of rubber by implicit steps;
/// the same meshes as Bullet's own soft body; and the machine's memory bandwidth and arithmetic
/// throughput, measured in the same run.
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/crew.h"
#include "base/median.h"
#include "base/memory.h"
#include "force/inflation.h"
#include "lab/bench/bench.h"
#include "lab/bench/figures.h"
#include "lab/bench/machine_limit.h"
#include "lab/peer/peer_world.h"
#include "lab/truth/truth.h"
#include "world/probe.h"

enum { ROUNDS = 41, ROUNDS_QUICK = 9, SETS = 5, PEER_ROUNDS = 1 };
enum { STREAM = 1 << 24 }; ///< length of each array: far more than a cache holds

/// Sides of cube-spheres; 6 side^2 + 2 particles.
static const int side_table[] = {13, 43, 129, 400};
enum { SIDES = sizeof side_table / sizeof *side_table, SIDES_QUICK = 2 };

static const int threads_side = 129;      ///< side at which threads are compared: 100,000 particles
static const double round_seconds = 0.01; ///< steps timed together take so long, or one step [s]
static const int peer_max = 100000;       ///< particles; Bullet's setup of more takes minutes

typedef struct SpeedCase {
    const char* name;
    const char* scene;
    const char* set;
    double step; ///< step times quads a side [s]: well below the limit
} SpeedCase;

static const SpeedCase case_table[] = {
    {"springs", "limit-springs", "balloons.0.inflation={law: area, amount: 1}", 0.01},
    {"membrane", "sphere-gas", "method=euler", 4e-4},
};
enum { CASES = sizeof case_table / sizeof *case_table };

/// Minimum and median of some times.
typedef struct Times {
    double minimum, median;
} Times;

static Times times_of(double* seconds, int count) {
    const double middle = median(seconds, count);
    return (Times){seconds[0], middle};
}

/// Time of one call of `step`, CPU time of this thread.
static Times time_steps(void (*step)(void* self), void* self, int rounds) {
    double second[ROUNDS];
    const double before = clock_seconds(CLOCK_THREAD_CPUTIME_ID);
    step(self); // warms up, and gives the number of steps of a round
    const double one = clock_seconds(CLOCK_THREAD_CPUTIME_ID) - before;
    const int steps = one < round_seconds ? (int)(round_seconds / one) : 1;
    for (int r = 0; r < rounds; r++) {
        const double start = clock_seconds(CLOCK_THREAD_CPUTIME_ID);
        for (int k = 0; k < steps; k++)
            step(self);
        second[r] = (clock_seconds(CLOCK_THREAD_CPUTIME_ID) - start) / steps;
    }
    return times_of(second, rounds);
}

/// The machine's own limits.
typedef struct Machine {
    double bandwidth;    ///< [bytes/s]
    double multiply_add; ///< multiplications and additions [1/s]
} Machine;

static void add(Figures* figures, const char* name, int particles, const char* metric,
                const char* unit, Times times, double share) {
    figures_add(figures, name, particles, metric, unit, times.minimum, times.median, share);
}

static Times scaled(Times times, double by) {
    return (Times){times.minimum * by, times.median * by};
}

/// Rates; the minimum time gives the highest rate.
static Times rate(Times times, double amount) {
    return (Times){amount / times.minimum, amount / times.median};
}

static Machine measure_machine(Figures* figures, int rounds) {
    double second[ROUNDS], count = 0;
    real *a = new_array(real, STREAM), *b = new_array(real, STREAM), *c = new_array(real, STREAM);
    limits()->triad(a, b, c, 3, STREAM);
    for (int r = 0; r < rounds; r++) {
        const double start = clock_seconds(CLOCK_THREAD_CPUTIME_ID);
        limits()->triad(a, b, c, 3, STREAM);
        second[r] = clock_seconds(CLOCK_THREAD_CPUTIME_ID) - start;
    }
    const Times stream = rate(times_of(second, rounds), 3.0 * STREAM * sizeof(real));
    for (int r = 0; r < rounds; r++) {
        const double start = clock_seconds(CLOCK_THREAD_CPUTIME_ID);
        count = limits()->multiply_add(1000000, a);
        second[r] = clock_seconds(CLOCK_THREAD_CPUTIME_ID) - start;
    }
    const Times work = rate(times_of(second, rounds), count);
    add(figures, "machine", 0, "bandwidth", "GB/s", scaled(stream, 1e-9), 0);
    add(figures, "machine", 0, "multiply+add", "G/s", scaled(work, 1e-9), 0);
    free(a);
    free(b);
    free(c);
    return (Machine){stream.minimum, work.minimum};
}

/// Bytes of all arrays that a step reads or writes.
static double bytes_touched(const Body* body) {
    const Slices* slices = &body->slices;
    const double state = body->count * (4.0 * sizeof(real4) + 5 * sizeof(real));
    const double slot = LANES * (sizeof(uint32_t) + (body->springs.count ? 2 * sizeof(real) : 0));
    const double slots = slices->from[slices->count] * (slot + sizeof(bool));
    const double element = 3 * sizeof(uint32_t) + 4 * sizeof(real);
    return state + slots + (double)body->membrane.eights * LANES * element;
}

/// Multiplications, additions, divisions and square roots in the equations: of a spring at each of
/// its ends, of a face's corner, of an element, of a particle.
static double work(const Body* body) {
    const double spring_end = 18, corner = 33, element = 101, particle = 25;
    return 2 * spring_end * body->springs.count + 4 * corner * body->mesh->face_count +
           element * body->membrane.count + particle * body->count;
}

/// Memory that this process has allocated [bytes].
static double memory_now(void) {
    const struct mallinfo2 info = mallinfo2();
    return (double)info.uordblks + (double)info.hblkhd;
}

static void step_world(void* self) {
    world_step(self);
}

/// Bullet's soft body at the same step.
typedef struct PeerStep {
    Peer* peer;
    double h;
} PeerStep;

static void step_peer(void* self) {
    const PeerStep* step = self;
    peer_step(step->peer, step->h);
}

static const char split[] = "guard=split"; ///< the default

static bool open_case(const SpeedCase* c, int side, const char* guard, World* world, Fault* fault) {
    char model[64], step[64];
    snprintf(model, sizeof model, "balloons.0.model=cube-sphere:%d", side);
    snprintf(step, sizeof step, "step=%.17g", c->step / side);
    const SceneSet set[SETS] = {{model}, {step}, {c->set}, {"seconds=1"}, {guard}};
    WorldDef def;
    return scene_load(c->scene, set, SETS, &def, fault) && world_open(world, &def, fault);
}

/// Wall time of single steps with two threads; the minimum excludes interruptions by other
/// processes.
static void measure_threads(Figures* figures, const char* name, World* world) {
    double second[ROUNDS];
    crew_set(2);
    for (int r = 0; r < ROUNDS; r++) {
        const double start = clock_seconds(CLOCK_MONOTONIC);
        world_step(world);
        second[r] = clock_seconds(CLOCK_MONOTONIC) - start;
    }
    crew_set(1);
    add(figures, name, world->balloon[0].body.count, "step, 2 threads", "us",
        scaled(times_of(second, ROUNDS), 1e6), 0);
}

/// What the energy watch adds to a step: `guard: stop` looks at the bound alike, and watches nothing.
/// Both copies step in turn, so that other processes disturb them alike.
static bool measure_watch(Figures* figures, const SpeedCase* c, int side, int rounds,
                          Fault* fault) {
    static const char* const guard[] = {split, "guard=stop"};
    World world[2];
    double share[ROUNDS], min[2] = {INFINITY, INFINITY};
    for (int k = 0; k < 2; k++)
        if (!open_case(c, side, guard[k], &world[k], fault))
            return false;
    const Times one = time_steps(step_world, &world[0], 1);
    const int steps = 1 + (int)(round_seconds / one.minimum);
    time_steps(step_world, &world[1], 1);
    for (int r = 0; r < rounds; r++) {
        double second[2];
        for (int k = 0; k < 2; k++) {
            const int copy = (k + r) % 2;
            const double start = clock_seconds(CLOCK_THREAD_CPUTIME_ID);
            for (int n = 0; n < steps; n++)
                world_step(&world[copy]);
            second[copy] = clock_seconds(CLOCK_THREAD_CPUTIME_ID) - start;
            min[copy] = fmin(min[copy], second[copy]);
        }
        share[r] = 100 * (second[0] / second[1] - 1);
    }
    add(figures, c->name, world[0].balloon[0].body.count, "energy watch", "%",
        (Times){100 * (min[0] / min[1] - 1), median(share, rounds)}, 0);
    for (int k = 0; k < 2; k++)
        world_close(&world[k]);
    return true;
}

static bool measure_case(Figures* figures, const SpeedCase* c, int side, const Machine* machine,
                         int rounds, Fault* fault) {
    const double before = memory_now();
    World world;
    if (!open_case(c, side, split, &world, fault))
        return false;
    const Body* body = &world.balloon[0].body;
    const int n = body->count, parts = body->springs.count + body->membrane.count;
    const Times times = time_steps(step_world, &world, rounds);
    const double bytes = bytes_touched(body), memory = memory_now() - before;
    const double moved = bytes / times.minimum / machine->bandwidth;
    const double done = work(body) / times.minimum / machine->multiply_add;
    if (world.blowup.halted)
        return fault_set(fault, c->name, "%s", world.blowup.text);

    add(figures, c->name, n, "step", "us", scaled(times, 1e6), 0);
    add(figures, c->name, n, "per particle", "ns", scaled(times, 1e9 / n), 0);
    add(figures, c->name, n, body->springs.count ? "per spring" : "per triangle", "ns",
        scaled(times, 1e9 / parts), 0);
    add(figures, c->name, n, "vertex-steps", "M/s", scaled(rate(times, n), 1e-6), 0);
    add(figures, c->name, n, "multiply+add", "G/s", scaled(rate(times, work(body)), 1e-9), done);
    add(figures, c->name, n, "bandwidth", "GB/s", scaled(rate(times, bytes), 1e-9), moved);
    add(figures, c->name, n, "touched", "B/particle", (Times){bytes / n, bytes / n}, 0);
    add(figures, c->name, n, "memory", "B/particle", (Times){memory / n, memory / n}, 0);
    if (side == threads_side)
        measure_threads(figures, c->name, &world);
    if (n <= peer_max) {
        PeerStep peer = {peer_of_world(&world, PEER_ROUNDS), world.step};
        const Times peers = time_steps(step_peer, &peer, rounds < ROUNDS ? 3 : 9);
        add(figures, c->name, n, "Bullet's step", "us", scaled(peers, 1e6), 0);
        peer_close(peer.peer);
    }
    world_close(&world);
    return true;
}

/// One second of the rubber balloon of 11,096 particles, filled to twice its gas by implicit steps,
/// and the relative error of its final pressure against the closed form.
static bool measure_second(Figures* figures, Fault* fault) {
    enum { RUNS = 5, FRAMES = 60 };
    static const SceneSet set[] = {{"balloons.0.model=cube-sphere:43"},
                                   {"method=newton"},
                                   {"step=0.016666666666666666"},
                                   {"seconds=1"}};
    const TruthBalloon balloon = truth_balloon_default();
    const double truth = truth_pressure(&balloon, truth_stretch_gas(&balloon, 2));
    double second[RUNS], off = 0;
    int n = 0;
    for (int k = 0; k < RUNS; k++) {
        WorldDef def;
        World world;
        if (!scene_load("sphere-gas", set, sizeof set / sizeof *set, &def, fault) ||
            !world_open(&world, &def, fault))
            return false;
        const double start = clock_seconds(CLOCK_THREAD_CPUTIME_ID);
        for (int frame = 0; frame < FRAMES; frame++)
            world_step(&world);
        second[k] = 1e3 * (clock_seconds(CLOCK_THREAD_CPUTIME_ID) - start);
        off = fabs(inflation_pressure(&world.balloon[0].body) / truth - 1);
        n = world.balloon[0].body.count;
        world_close(&world);
    }
    figures_add_samples(figures, "rubber, newton", n, "a second", "ms", second, RUNS);
    add(figures, "rubber, newton", n, "pressure off", "%", (Times){100 * off, 100 * off}, 0);
    return true;
}

/// Wall time from a file of 100,000 quads to the end of the first step.
static bool measure_load(Figures* figures, bool quick, Fault* fault) {
    enum { LOADS = 5 };
    const int side = quick ? side_table[1] : side_table[2];
    char folder[] = "/tmp/balloon-XXXXXX", path[sizeof folder + 16];
    const bool made = mkdtemp(folder) != NULL;
    snprintf(path, sizeof path, "%s/skin.obj", folder);
    FILE* out = made ? fopen(path, "w") : NULL;
    World world;
    if (!out || !open_case(&case_table[0], side, split, &world, fault))
        return fault_set(fault, path, "cannot be written");
    probe_obj(&world, out);
    fclose(out);
    const int n = world.balloon[0].body.count;
    world_close(&world);

    double second[LOADS];
    for (int k = 0; k < LOADS; k++) {
        WorldDef def;
        const double start = clock_seconds(CLOCK_MONOTONIC);
        if (!scene_load(path, NULL, 0, &def, fault) || !world_open(&world, &def, fault))
            return false;
        world_step(&world);
        second[k] = clock_seconds(CLOCK_MONOTONIC) - start;
        world_close(&world);
    }
    remove(path);
    rmdir(folder);
    add(figures, "load", n, "to first step", "ms", scaled(times_of(second, LOADS), 1e3), 0);
    return true;
}

static bool measure(const BenchOptions* options, Fault* fault) {
    const int rounds = options->quick ? ROUNDS_QUICK : ROUNDS;
    figures_head(options->figures);
    const Machine machine = measure_machine(options->figures, rounds);
    bool good = true;
    for (int c = 0; c < CASES; c++)
        for (int s = 0; good && s < (options->quick ? SIDES_QUICK : SIDES); s++)
            good = measure_case(options->figures, &case_table[c], side_table[s], &machine, rounds,
                                fault) &&
                   (s > 1 ||
                    measure_watch(options->figures, &case_table[c], side_table[s], rounds, fault));
    return good && measure_second(options->figures, fault) &&
           measure_load(options->figures, options->quick, fault);
}

const BenchCase bench_speed = {
    .name = "speed",
    .about =
        "a step of springs and of rubber, 1,000 to a million particles, beside Bullet's and the "
        "machine's limits",
    .timed = true,
    .run = measure,
};
