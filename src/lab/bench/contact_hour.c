/// An hour of random throws, as a user might do. The state must stay finite and no ball may pass
/// through the skin, by the world's count and by the winding number of the skin around each ball.
#include <stdio.h>
#include <time.h>

#include "lab/bench/bench.h"
#include "lab/bench/storm.h"

enum { SEED = 1, ROWS = 12, MINUTES_A_ROW = 5 };

static bool measure(const BenchOptions* options, Fault* fault) {
    Storm storm;
    if (!storm_open(&storm, SEED, fault))
        return false;
    const long row = options->quick ? 60 * STORM_RATE : MINUTES_A_ROW * 60 * STORM_RATE;
    long looks = 0, astray = 0;
    bool good = true;
    printf("%12s %8s %14s %14s %10s %12s\n", "simulated s", "throws", "pass-throughs",
           "balls looked at", "gone astray", "CPU s");
    for (int k = 0; good && k < (options->quick ? 1 : ROWS); k++) {
        const clock_t start = clock();
        for (long n = 1; good && n <= row; n++) {
            good = storm_step(&storm, fault) && !storm.world.blowup.halted;
            if (n % STORM_THROW == 0) {
                looks += storm.world.contacts.sphere_count;
                astray += storm_astray(&storm);
            }
        }
        printf("%12g %8ld %14ld %15ld %11ld %12.1f\n", (double)storm.world.clock / STORM_RATE,
               storm.world.clock / STORM_THROW, storm.world.contacts.pass_throughs, looks, astray,
               (double)(clock() - start) / CLOCKS_PER_SEC);
        fflush(stdout);
    }
    const long through = storm.world.contacts.pass_throughs;
    if (storm.world.blowup.halted)
        good = fault_set(fault, "bench contact-hour", "%s", storm.world.blowup.text);
    else if (good && (through || astray))
        good = fault_set(fault, "bench contact-hour",
                         "%ld balls passed through, and the skin winds otherwise around %ld",
                         through, astray);
    storm_close(&storm);
    return good;
}

const BenchCase bench_contact_hour = {
    .name = "contact-hour",
    .about = "an hour of random throws at a balloon that is blown up and let out",
    .run = measure,
};
