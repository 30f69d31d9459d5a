#include "lab/peer/peer_run.h"

#include <math.h>
#include <stdlib.h>

#include "base/clock.h"
#include "base/interrupt.h"
#include "base/memory.h"
#include "force/inflation.h"
#include "lab/run/report_line.h"
#include "mesh/measure.h"
#include "world/probe.h"

enum {
    MAX_ROUNDS = 64,   ///< maximum rounds of a fit: more than any game uses
    FIT_HALVINGS = 10, ///< bisections of the stiffness: to a thousandth
    FIT_STEPS = 100,   ///< minimum number of steps until a skin is at rest
};

static const double fit_seconds = 0.3; ///< minimum time until a skin is at rest [s]

/// A state is bad if its volume is not finite or exceeds this many times size^3. [1]
static const double too_large = 1e6;

/// A peer and the world whose first balloon and balls receive its state after each step.
typedef struct Pair {
    World* world;
    Peer* peer;
    double first_area;
    double spent; ///< CPU time of the peer's steps [s]
} Pair;

static void copy_state(Pair* pair) {
    World* world = pair->world;
    Body* body = &world->balloon[0].body;
    double4* state = new_array(double4, 2 * body->count);
    peer_read(pair->peer, state, state + body->count);
    for (int i = 0; i < body->count; i++) {
        body->x[i] = to_real4(state[i]);
        body->v[i] = to_real4(state[body->count + i]);
    }
    free(state);
    for (int s = 0; s < world->contacts.sphere_count; s++) {
        double4 x, v;
        peer_read_sphere(pair->peer, s, &x, &v);
        world->contacts.sphere[s].x = to_real4(x);
        world->contacts.sphere[s].v = to_real4(v);
    }
}

/// One step under a gauge pressure.
static void step(Pair* pair, double pressure, double h) {
    const Balloon* balloon = &pair->world->balloon[0];
    peer_set_pressure(pair->peer, peer_pressure(&balloon->mesh, pressure, peer_volume(pair->peer),
                                                measure_area(&balloon->mesh, balloon->body.x),
                                                pair->first_area));
    const double start = clock_seconds(CLOCK_THREAD_CPUTIME_ID);
    peer_step(pair->peer, h);
    pair->spent += clock_seconds(CLOCK_THREAD_CPUTIME_ID) - start;
    copy_state(pair);
}

static Pair pair_open(World* world, const PeerLinks* links) {
    return (Pair){.world = world,
                  .peer = peer_with_links(world, links),
                  .first_area = measure_area(&world->balloon[0].mesh, world->balloon[0].body.x)};
}

/// Measured by size^3, because an open sheet has no volume.
static bool is_bad(const Pair* pair) {
    const double volume = peer_volume(pair->peer), size = pair->world->balloon[0].body.size;
    return !(fabs(volume) < too_large * size * size * size);
}

/// Volume at rest under the fit's pressure over the initial volume [1]; the pressure rises during
/// the first quarter of the time.
static double volume_at_rest(World* world, const PeerFit* fit, const PeerLinks* links) {
    world_reset(world);
    Pair pair = pair_open(world, links);
    const double first = peer_volume(pair.peer), h = fit->step > 0 ? fit->step : world->step;
    const double steps = fmax(FIT_STEPS, fit_seconds / h);
    for (int n = 1; n <= steps && !is_bad(&pair); n++)
        step(&pair, fit->pressure * fmin(1, 4 * n / steps), h);
    const double ratio = is_bad(&pair) ? INFINITY : peer_volume(pair.peer) / first;
    peer_close(pair.peer);
    world_reset(world);
    return ratio;
}

/// Links like springs of stiffness k, in as many rounds as needed.
static PeerLinks links_like(const World* world, double spring) {
    const Body* body = &world->balloon[0].body;
    double max = 0;
    for (int i = 0; i < body->count; i++)
        max = fmax(max, (double)body->inverse_mass[i]);
    const double moved = spring * world->step * world->step * 2 * max;
    const int rounds = (int)fmin(MAX_ROUNDS, ceil(moved));
    return (PeerLinks){fmin(1, moved / rounds), rounds};
}

/// The fitted links, or the stiffest if none fit.
static PeerLinks fitted_links(World* world, const PeerFit* fit) {
    PeerLinks links = {.stiffness = 1, .rounds = 1};
    if (fit->spring > 0)
        return links_like(world, fit->spring);
    if (!(fit->ratio > 0))
        return links;
    while (volume_at_rest(world, fit, &links) > fit->ratio && links.rounds < MAX_ROUNDS)
        links.rounds *= 2;
    if (volume_at_rest(world, fit, &links) > fit->ratio)
        return links;
    double soft = 0, stiff = 1;
    for (int n = 0; n < FIT_HALVINGS; n++) {
        links.stiffness = (soft + stiff) / 2;
        *(volume_at_rest(world, fit, &links) > fit->ratio ? &soft : &stiff) = links.stiffness;
    }
    links.stiffness = stiff;
    return links;
}

/// Number of steps in a time, rounded down with a tolerance for decimal fractions.
static long steps_to(double time, double h) {
    return (long)floor(time / h * (1 + 1e-12) + 1e-9);
}

/// Step the peer and the world's clock until `until` steps are done or the state is bad.
static void advance(Pair* pair, long until) {
    World* world = pair->world;
    while (world->step_count < until && !is_bad(pair) && !interrupt_signal()) {
        balloon_fill(&world->balloon[0], (double)(world->step_count + 1) * world->step);
        step(pair, inflation_pressure(&world->balloon[0].body), world->step);
        world->step_count++;
    }
}

static void print_report(const World* world, bool ended, double spent) {
    const double seconds = world_time(world);
    ReportLine line = {.ended = ended,
                       .steps = world->step_count,
                       .seconds = seconds,
                       .cpu_ms = 1e3 * spent / seconds,
                       .substeps = 1};
    snprintf(line.hash, sizeof line.hash, "%016llx", (unsigned long long)world_hash(world));
    report_line_print(&line, stdout);
}

static void write_row(const World* world, FILE* csv) {
    probe_csv_row(world, csv);
    fputc('\n', csv);
}

bool peer_run(World* world, const PeerRun* options, FILE* csv, Fault* fault) {
    if (world->system.joints.count > 0)
        return fault_set(fault, world->def.file,
                         "Bullet's soft body takes no string to a balloon or a knot");
    const PeerLinks links = fitted_links(world, &options->fit);
    if (!options->quiet)
        fprintf(stderr, "balloon: Bullet's links have stiffness %g in %d rounds\n", links.stiffness,
                links.rounds);
    Pair pair = pair_open(world, &links);
    const long rows = steps_to(options->seconds, 1 / options->fps);
    const long steps = steps_to(options->seconds, world->step);
    if (csv) {
        probe_csv_header(world, csv);
        fputc('\n', csv);
        write_row(world, csv);
    }
    for (long k = 1; k <= rows + 1 && !is_bad(&pair) && !interrupt_signal(); k++) {
        advance(&pair, k <= rows ? steps_to((double)k / options->fps, world->step) : steps);
        if (csv && k <= rows && !is_bad(&pair) && !interrupt_signal())
            write_row(world, csv);
    }
    const bool bad = is_bad(&pair);
    if (options->time)
        printf("stepping %.6f s of CPU time for %g s: %.6f ms per simulated second\n", pair.spent,
               world_time(world), 1e3 * pair.spent / world_time(world));
    if (options->report)
        print_report(world, !bad, pair.spent);
    peer_close(pair.peer);
    if (interrupt_signal())
        return interrupt_fault(world->def.file, world_time(world), fault);
    return !bad || fault_set(fault, world->def.file, "Bullet's soft body went bad in step %ld",
                             world->step_count);
}
