/// A soak test with a user's input: random keys and throws for a simulated hour, applied to two
/// copies of a scene; the input log is written. Both copies must reach the same state to the bit,
/// no ball may pass through a skin, no scene may halt, and the memory of the process must not grow
/// after ten minutes. The hour begins with a volley of more balls than throws one by one bring
/// together (17), so that no list becomes longer later.
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

#include "base/random.h"
#include "lab/bench/bench.h"
#include "lab/run/result_file.h"
#include "world/command.h"

enum {
    SEED = 1,
    COPIES = 2,
    ROWS = 60,
    QUICK_ROWS = 2,
    VOLLEY = 60,
    SETTLED_ROW = 10, ///< from this row on the memory may no longer grow
};

static const double row_seconds[] = {60, 1}; ///< simulated, of a full and of a quick row [s]
static const double press_seconds = 0.5;     ///< from a press, with a throw, to the next one
static const double reset_share = 0.02;   ///< share of the drawn presses of reset that are made [1]
static const double ball_size = 0.05;     ///< radius of the smallest ball, of a balloon's size [1]
static const double max_speed = 100;      ///< [m/s]
static const double volley_speed = 10;    ///< [m/s]
static const double volley_seconds = 6;   ///< simulated
static const double memory_growth = 0.01; ///< maximum relative growth of the memory [1]

/// The default scene, and the heaviest one that a core steps in real time.
static const char* const scene_table[] = {"party", "crowd"};
enum { SCENES = sizeof scene_table / sizeof *scene_table };

typedef struct Soak {
    const char* scene;
    World world[COPIES];
    int opened;
    Random random;
    double4 center; ///< of the sphere about all balloons in the initial state [m]
    double radius;  ///< its radius [m]
    int pressed;    ///< row of command_table whose key is down, or -1
    long throws;
    long presses;
    double settled_memory; ///< [bytes]
    char log_name[64];
    FILE* log;
    Record event; ///< the last one
} Soak;

/// The sphere about the bounding box of all balloons.
static void bound(Soak* soak) {
    const World* world = &soak->world[0];
    double4 low = to_double4(world->balloon[0].body.x[0]), high = low;
    for (int b = 0; b < world->balloon_count; b++)
        for (int i = 0; i < world->balloon[b].body.count; i++) {
            const double4 x = to_double4(world->balloon[b].body.x[i]);
            for (int k = 0; k < 3; k++) {
                low[k] = fmin(low[k], x[k]);
                high[k] = fmax(high[k], x[k]);
            }
        }
    soak->center = (low + high) / 2;
    soak->radius = dlength(high - low) / 2;
}

static bool open_copies(Soak* soak, const char* scene, const char* folder, Fault* fault) {
    *soak = (Soak){.scene = scene, .random = {SEED}, .pressed = -1};
    snprintf(soak->log_name, sizeof soak->log_name, "soak-%s.log", scene);
    if (!result_folder(folder, fault) ||
        !(soak->log = result_file_open(folder, soak->log_name, RECORD_MARK, fault)))
        return false;
    record_title(scene, soak->log);
    for (; soak->opened < COPIES; soak->opened++) {
        WorldDef def;
        if (!scene_load(scene, NULL, 0, &def, fault) ||
            !world_open(&soak->world[soak->opened], &def, fault))
            return false;
    }
    bound(soak);
    return true;
}

static bool close_copies(Soak* soak, const char* folder, Fault* fault) {
    while (soak->opened > 0)
        world_close(&soak->world[--soak->opened]);
    record_free(&soak->event);
    return !soak->log || result_file_close(soak->log, folder, soak->log_name, fault);
}

static bool apply(Soak* soak, const Event* event, Fault* fault) {
    soak->event.count = 0;
    record_add(&soak->event, event, soak->log);
    for (int k = 0; k < COPIES; k++)
        if (!world_event(&soak->world[k], event, fault))
            return false;
    return true;
}

static bool set_key(Soak* soak, bool down, Fault* fault) {
    Event event = {.step = soak->world[0].clock, .kind = EVENT_KEY};
    snprintf(event.name, sizeof event.name, "%s", command_table[soak->pressed].name);
    snprintf(event.value, sizeof event.value, "%s", down ? "down" : "up");
    return apply(soak, &event, fault);
}

/// Release the key that is down, and press another.
static bool press_next(Soak* soak, Fault* fault) {
    if (soak->pressed >= 0 && !set_key(soak, false, fault))
        return false;
    soak->pressed = (int)(random_next(&soak->random) * command_count);
    const Command* command = &command_table[soak->pressed];
    const bool is_kept = command->down != world_reset || random_next(&soak->random) < reset_share;
    if (!is_kept) {
        soak->pressed = -1;
        return true;
    }
    soak->presses++;
    return set_key(soak, true, fault);
}

/// Throw a ball of this radius, of the balloon's size, and speed from outside at a random particle of
/// a balloon.
static bool throw_ball(Soak* soak, double size, double speed, Fault* fault) {
    const World* world = &soak->world[0];
    Random* random = &soak->random;
    const Body* body = &world->balloon[(int)(random_next(random) * world->balloon_count)].body;
    const double radius = body->size * size;
    double4 d = {0};
    for (int k = 0; k < 3; k++)
        d[k] = 2 * random_next(random) - 1;
    d[1] = fabs(d[1]); // from above the floor
    d /= dlength(d);
    const double4 from = soak->center + (2 * soak->radius + radius) * d;
    double4 to = to_double4(body->x[(int)(random_next(random) * body->count)]) - from;
    to /= dlength(to);

    Event event = {.step = world->clock, .kind = EVENT_THROW};
    for (int k = 0; k < 3; k++) {
        event.thrown[k] = from[k];
        event.thrown[3 + k] = speed * to[k];
    }
    event.thrown[6] = (double)body->mass[0] * body->count * pow(100, random_next(random) - 0.5);
    event.thrown[7] = radius;
    soak->throws++;
    return apply(soak, &event, fault);
}

static bool throw_next(Soak* soak, Fault* fault) {
    const double size = ball_size * pow(8, random_next(&soak->random));
    return throw_ball(soak, size, max_speed * pow(100, -random_next(&soak->random)), fault);
}

/// Step both copies for some simulated time, pressing and throwing or not, and compare their states.
static bool play(Soak* soak, double seconds, bool pressing, Fault* fault) {
    World* world = soak->world;
    const long steps = lround(seconds / world->step), every = lround(press_seconds / world->step);
    for (long n = 0; n < steps; n++) {
        if (pressing && world->clock % every == 0 &&
            !(press_next(soak, fault) && throw_next(soak, fault)))
            return false;
        for (int k = 0; k < COPIES; k++)
            world_step(&world[k]);
        if (world->blowup.halted)
            return fault_set(fault, soak->scene, "%s", world->blowup.text);
    }
    if (world->contacts.pass_throughs)
        return fault_set(fault, soak->scene, "%ld balls passed through",
                         world->contacts.pass_throughs);
    if (world_hash(&world[0]) != world_hash(&world[1]))
        return fault_set(fault, soak->scene, "two copies with the same input differ");
    return true;
}

/// Large balls at one speed, which arrive together; then time for them to press, and to go.
static bool play_volley(Soak* soak, Fault* fault) {
    for (int n = 0; n < VOLLEY; n++)
        if (!throw_ball(soak, 8 * ball_size, volley_speed, fault))
            return false;
    return play(soak, volley_seconds, false, fault);
}

/// The largest memory of the process so far [bytes].
static double peak_memory(void) {
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * (double)usage.ru_maxrss;
}

static bool soak_row(Soak* soak, int row, double seconds, Fault* fault) {
    const clock_t start = clock();
    if (!play(soak, seconds, true, fault))
        return false;
    const double memory = peak_memory();
    if (row <= SETTLED_ROW)
        soak->settled_memory = memory;
    printf("%-8s %12g %8ld %8ld %6d %10.2f  %016llx %8.1f\n", soak->scene,
           (double)soak->world[0].clock * soak->world[0].step, soak->presses, soak->throws,
           soak->world[0].contacts.sphere_count, memory / 1e6,
           (unsigned long long)world_hash(&soak->world[0]),
           (double)(clock() - start) / CLOCKS_PER_SEC);
    fflush(stdout);
    if (memory > (1 + memory_growth) * soak->settled_memory)
        return fault_set(fault, soak->scene, "memory grew from %.2f to %.2f MB",
                         soak->settled_memory / 1e6, memory / 1e6);
    return true;
}

static bool measure(const BenchOptions* options, Fault* fault) {
    bool good = true;
    printf("%-8s %12s %8s %8s %6s %10s  %-16s %8s\n", "scene", "simulated s", "presses", "throws",
           "balls", "peak MB", "hash", "CPU s");
    for (int k = 0; good && k < SCENES; k++) {
        if (options->only && !strstr(scene_table[k], options->only))
            continue;
        Soak soak;
        good = open_copies(&soak, scene_table[k], options->out, fault) &&
               (options->quick || play_volley(&soak, fault));
        const int rows = options->quick ? QUICK_ROWS : ROWS;
        for (int row = 1; good && row <= rows; row++)
            good = soak_row(&soak, row, row_seconds[options->quick], fault);
        good = close_copies(&soak, options->out, fault) && good;
    }
    if (good && options->quick)
        printf("too short to see memory grow\n");
    return good;
}

const BenchCase bench_soak = {
    .name = "soak",
    .about = "an hour of random keys and throws in party and crowd: same bits, no more memory",
    .run = measure,
};
