/// The hash of a scene's final state, for hashes.sh: a program that links only the rooms that step a
/// world, so that a second compiler need not compile the others.
///
///     state_hash SCENE METHOD SECONDS THREADS
///
/// prints the hash, `refused` where the scene cannot be run by the method or names the other
/// precision, or `halted` where the guard stopped it.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/crew.h"
#include "world/world.h"

/// Print the hash of the state after `seconds`, or one step.
static void print_hash(World* world, double seconds) {
    const long steps = lround(fmax(seconds / world->step, 1));
    while (world->clock < steps && !world->blowup.halted)
        world_step(world);
    if (world->blowup.halted)
        puts("halted");
    else
        printf("%016llx\n", (unsigned long long)world_hash(world));
}

/// Whether the scene names the precision of the other build.
static bool is_of_other_precision(const WorldDef* def) {
    const Precision own = sizeof(real) == sizeof(double) ? PRECISION_DOUBLE : PRECISION_FLOAT;
    return def->precision != PRECISION_ANY && def->precision != own;
}

int main(int argc, char** argv) {
    if (argc != 5)
        return EXIT_FAILURE;
    char method[64];
    snprintf(method, sizeof method, "method=%s", argv[2]);
    const SceneSet set = {.text = method};
    WorldDef def;
    World world;
    Fault fault = {0};
    crew_set(atoi(argv[4]));
    if (scene_load(argv[1], &set, 1, &def, &fault) && !is_of_other_precision(&def) &&
        world_open(&world, &def, &fault)) {
        print_hash(&world, atof(argv[3]));
        world_close(&world);
    } else {
        puts("refused");
    }
    crew_set(1);
    return EXIT_SUCCESS;
}
