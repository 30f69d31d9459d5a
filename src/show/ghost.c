#include "show/ghost.h"

#include <math.h>

#include "base/clock.h"

void ghost_step(Ghost* ghost, World* world) {
    const double start = clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
    world_step(world);
    const double middle = clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
    world_step(&ghost->world);
    ghost->spent += middle - start;
    ghost->ghost_spent += clock_seconds(CLOCK_PROCESS_CPUTIME_ID) - middle;
}

double ghost_distance(const Ghost* ghost, const World* world) {
    double sum = 0;
    int count = 0;
    for (int b = 0; b < world->balloon_count; b++) {
        const Body *own = &world->balloon[b].body, *other = &ghost->world.balloon[b].body;
        for (int i = 0; i < own->count; i++) {
            const double4 difference = to_double4(own->x[i]) - to_double4(other->x[i]);
            sum += ddot(difference, difference);
        }
        count += own->count;
    }
    return sqrt(sum / count);
}

double ghost_cost(const Ghost* ghost, const World* world, bool of_ghost) {
    const double simulated = (double)world->clock * world->step;
    return simulated > 0 ? 1e3 * (of_ghost ? ghost->ghost_spent : ghost->spent) / simulated : 0;
}

void ghost_summary(const Ghost* ghost, const World* world, char* words, size_t size) {
    const Blowup* bad = &ghost->world.blowup;
    const int used = snprintf(words, size, "%s is %.3g off, for %.3g ms per second against %.3g",
                              ghost->world.method->name, ghost_distance(ghost, world),
                              ghost_cost(ghost, world, true), ghost_cost(ghost, world, false));
    if (bad->halted && used < (int)size)
        snprintf(words + used, size - (size_t)used, "; it went bad in step %ld", bad->step);
}
