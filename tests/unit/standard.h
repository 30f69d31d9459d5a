/// The standard balloon of the tests of rubber, as a scene file that the test writes.
#ifndef BALLOON_TESTS_STANDARD_H
#define BALLOON_TESTS_STANDARD_H

#include <fcntl.h>

#include "worlds.h"

/// Spheres of radius 1 scaled to 0.1 m.
#define STANDARD                                                                                   \
    "step: 0.001\n"                                                                                \
    "gravity: 0\n"                                                                                 \
    "method: newton\n"                                                                             \
    "balloons:\n"                                                                                  \
    "  - model: icosphere:2\n"                                                                     \
    "    scale: 0.1\n"                                                                             \
    "    skin: {membrane: {material: neo-hookean, young: 1e6, density: 1000, thickness: 3e-4}}\n"  \
    "    inflation: {law: gas, amount: 1}\n"                                                       \
    "    damping: {rate: 50}\n"

static char standard[64];

static int write_standard(void** state) {
    (void)state;
    snprintf(standard, sizeof standard, "/tmp/balloon-rubber-%ld.yaml", (long)getpid());
    const int file = open(standard, O_CREAT | O_TRUNC | O_WRONLY, 0600);
    return file < 0 || write(file, STANDARD, sizeof STANDARD - 1) < 0 || close(file);
}

static int remove_standard(void** state) {
    (void)state;
    return remove(standard);
}

#endif
