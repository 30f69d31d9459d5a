#include "scene/scene_range.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// clang-format off
const Range range_table[] = {
    {"step",                                 0, 1,        true},
    {"seconds",                              0, INFINITY, true},
    {"rest",                                 0, 1,        false},
    {"solver.iterations",                    0, 10000,    false},
    {"solver.tolerance",                     0, 1,        false},
    {"solver.linear_tolerance",              0, 1,        false},
    {"pipes.*.from",                         0, INFINITY, false},
    {"pipes.*.to",                           0, INFINITY, false},
    {"pipes.*.conductance",                  0, INFINITY, true},
    {"pipes.*.start",                        0, INFINITY, false},
    {"about.*.at",                           0, INFINITY, false},
    {"about.*.tolerance",                    0, INFINITY, true},
    {"fails.at",                             0, INFINITY, true},
    {"spheres.*.radius",                     0, INFINITY, true},
    {"spheres.*.mass",                       0, INFINITY, true},
    {"spheres.*.restitution",                0, 1,        false},
    {"spheres.*.friction",                   0, INFINITY, false},
    {"balloons.*.scale",                     0, INFINITY, true},
    {"balloons.*.size",                      0, INFINITY, true},
    {"balloons.*.color.*",                   0, 1,        false},
    {"balloons.*.skin.springs.structural",   0, INFINITY, false},
    {"balloons.*.skin.springs.shear",        0, INFINITY, false},
    {"balloons.*.skin.springs.flexion",      0, INFINITY, false},
    {"balloons.*.skin.springs.torsion",      0, INFINITY, false},
    {"balloons.*.skin.membrane.young",       0, INFINITY, true},
    {"balloons.*.skin.membrane.poisson",    -1, 0.5,      true},
    {"balloons.*.skin.membrane.mooney",      0, INFINITY, false},
    {"balloons.*.skin.membrane.density",     0, INFINITY, true},
    {"balloons.*.skin.membrane.thickness",   0, INFINITY, true},
    {"balloons.*.skin.membrane.patches.*.radius",    0, INFINITY, true},
    {"balloons.*.skin.membrane.patches.*.thickness", 0, INFINITY, true},
    {"balloons.*.mass.per_particle",         0, INFINITY, true},
    {"balloons.*.inflation.rate",            0, INFINITY, false},
    {"balloons.*.inflation.ambient",         0, INFINITY, false},
    {"balloons.*.inflation.unit",            0, INFINITY, true},
    {"balloons.*.inflation.temperature",     0, INFINITY, true},
    {"balloons.*.inflation.leak",            0, INFINITY, false},
    {"balloons.*.inflation.vent",            0, INFINITY, false},
    {"balloons.*.inflation.fill.start",      0, INFINITY, false},
    {"balloons.*.inflation.fill.seconds",    0, INFINITY, true},
    {"balloons.*.damping.coefficient",       0, INFINITY, false},
    {"balloons.*.damping.rate",              0, INFINITY, false},
    {"balloons.*.correction.structural",     0, INFINITY, false},
    {"balloons.*.correction.shear",          0, INFINITY, false},
    {"balloons.*.correction.flexion",        0, INFINITY, false},
    {"balloons.*.strings.*.stiffness",       0, INFINITY, false},
    {"balloons.*.strings.*.slack",           0, INFINITY, true},
};
// clang-format on
const int range_count = sizeof range_table / sizeof range_table[0];

static bool matches(const char* pattern, const char* path) {
    while (*pattern && *path) {
        if (*pattern == '*') {
            path += strspn(path, "0123456789");
            pattern++;
        } else if (*pattern++ != *path++) {
            return false;
        }
    }
    return *pattern == *path;
}

const Range* range_find(const char* path) {
    for (int i = 0; i < range_count; i++)
        if (matches(range_table[i].path, path))
            return &range_table[i];
    return NULL;
}

bool range_holds(const Range* range, double value) {
    return (range->least_open ? value > range->least : value >= range->least) &&
           value <= range->most;
}

void range_words(const Range* range, char words[96]) {
    const char* from = range->least_open ? "greater than" : "at least";
    if (range->most == INFINITY)
        snprintf(words, 96, "%s %g", from, range->least);
    else
        snprintf(words, 96, "%s %g and at most %g", from, range->least, range->most);
}
