/// The hash of a scene's final state, for hashes.sh: a program that links only the rooms that step a
/// world, so that a second compiler need not compile the others.
///
///     state_hash SCENE METHOD SECONDS THREADS
///
/// prints the hash, `refused` where the scene cannot be run by the method or names the other
/// precision, or `halted` where the guard stopped it. Of a scene with a step above SECONDS, one step
/// of a hundredth of SECONDS is made: explicit methods divide it into many.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/crew.h"
#include "world/world.h"

/// Print the hash of the state after `seconds`.
static void print_hash(World* world, double seconds) {
    const long steps = lround(seconds / world->step);
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
    double seconds = atof(argv[3]);
    crew_set(atoi(argv[4]));
    const bool loaded = scene_load(argv[1], &set, 1, &def, &fault);
    if (loaded && def.step > seconds)
        def.step = seconds = seconds / 100;
    if (loaded && !is_of_other_precision(&def) && world_open(&world, &def, &fault)) {
        print_hash(&world, seconds);
        world_close(&world);
    } else {
        puts("refused");
    }
    crew_set(1);
    return EXIT_SUCCESS;
}
