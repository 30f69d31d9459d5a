/// Random encounters of balloons (lab/bench/encounter.h): nothing may ever cross, by a counter that
/// shares no code with the contacts.
///
/// `--only 17` runs one of them and prints it, `--only 0-499` a range.
#include <stdio.h>
#include <time.h>

#include "base/interrupt.h"
#include "lab/bench/bench.h"
#include "lab/bench/encounter.h"
#include "lab/bench/exact_crossings.h"

enum { ENCOUNTERS = 2000, ENCOUNTERS_QUICK = 12 };

static const double cpu_max = 30; ///< an encounter that takes longer is left, and said [s]

/// Sums over encounters.
typedef struct Tally {
    int run, left, halted, crossed;
    long states, crossings, zone_particles;
    double cpu, simulated;
} Tally;

static double cpu_now(void) {
    return (double)clock() / CLOCKS_PER_SEC;
}

/// Run one; says what is wrong.
static bool run_one(unsigned long long seed, bool quick, bool says_all, Tally* tally,
                    Fault* fault) {
    Encounter encounter;
    if (!encounter_open(&encounter, seed, quick, fault))
        return false;
    if (says_all) {
        for (int k = 0; k < 5; k++)
            printf("  %s\n", encounter.scene[k]);
        printf("  %s\n  plates at %.3f s\n", encounter.balloons,
               encounter.squeezed ? encounter.squeezed_at : 0);
    }
    const World* world = &encounter.world;
    const double start = cpu_now();
    int most = exact_crossings_of_world(world);
    double first = most > 0 ? 0 : -1;
    while (encounter_go_on(&encounter) && cpu_now() - start < cpu_max) {
        const int count = exact_crossings_of_world(world);
        tally->states++;
        if (count > 0 && first < 0)
            first = world_time(world);
        most = count > most ? count : most;
        if (says_all)
            printf("  %.4f s: %d crossings, %ld particles in zones so far\n", world_time(world),
                   count, world->contacts.zone_particles);
    }
    const bool left = !world->blowup.halted && world_time(world) < encounter.seconds;
    if (most > 0 || world->blowup.halted || left || says_all)
        printf("%llu: %s, %s, %d balloons%s: %d crossings, first at %g s%s%s\n", seed,
               encounter.scene[0], encounter.scene[1], world->balloon_count,
               encounter.squeezed ? ", squeezed" : "", most, first,
               left ? "; left, for it is slow" : "",
               world->blowup.halted ? world->blowup.text : "");
    fflush(stdout);
    tally->run++;
    tally->left += left;
    tally->halted += world->blowup.halted;
    tally->crossed += most > 0;
    tally->crossings += most;
    tally->zone_particles += world->contacts.zone_particles;
    tally->cpu += cpu_now() - start;
    tally->simulated += world_time(world);
    encounter_close(&encounter);
    return true;
}

static bool measure(const BenchOptions* options, Fault* fault) {
    unsigned long long first = 0, last = (options->quick ? ENCOUNTERS_QUICK : ENCOUNTERS) - 1;
    char rest;
    const int read = options->only ? sscanf(options->only, "%llu-%llu%c", &first, &last, &rest) : 2;
    if (read == 1)
        last = first;
    if (read != 1 && (read != 2 || last < first))
        return fault_set(fault, "--only",
                         "'%s' is not a number such as 17, or a range such as 0-499",
                         options->only);
    Tally tally = {0};
    bool good = true;
    for (unsigned long long seed = first; good && seed <= last && !interrupt_signal(); seed++)
        good = run_one(seed, options->quick, read == 1, &tally, fault);
    printf("%d encounters, %ld states: %d crossed, %d halted, %d left; %ld particles in zones; "
           "%.0f CPU s for %.1f s\n",
           tally.run, tally.states, tally.crossed, tally.halted, tally.left, tally.zone_particles,
           tally.cpu, tally.simulated);
    return good && (tally.crossed == 0 ||
                    fault_set(fault, "bench encounters", "%d of %d encounters crossed",
                              tally.crossed, tally.run));
}

const BenchCase bench_encounters = {
    .name = "encounters",
    .about = "random encounters of balloons, half of them squeezed: nothing ever crosses",
    .run = measure,
};
