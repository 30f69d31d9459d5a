/// Common to the tests of the scene format: write a scene to a folder, load it, expect a fault.
#ifndef BALLOON_TESTS_SCENES_H
#define BALLOON_TESTS_SCENES_H

// clang-format off
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
// clang-format on

#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "mesh/shape.h"
#include "scene/key.h"
#include "scene/scene.h"

enum { MAX_SETS = 6, MUTATIONS = 1000 };

static const char smallest[] = "step: 0.01\n"
                               "balloons:\n"
                               "  - model: cube\n"
                               "    mass: {per_particle: 0.5}\n";

/// The smallest scene up to its balloon, for tests that add one mistake.
#define HEAD "step: 0.01\nballoons:\n  - model: cube\n    mass: {per_particle: 0.5}\n"

/// A balloon of rubber up to its material.
#define RUBBER                                                                                     \
    "step: 0.01\nballoons:\n  - model: cube\n"                                                     \
    "    skin: {membrane: {young: 1e6, density: 1000, thickness: 1e-3, "

// Every key of the format once.
static const char full[] =
    "title: All there is\n"
    "units: paper\n"
    "step: 0.002\n"
    "gravity: 0\n"
    "floor: -3.5\n"
    "guard: stop\n"
    "precision: double\n"
    "method: euler\n"
    "solver: {iterations: 7, tolerance: 1e-5, linear_tolerance: 1e-3, fixed: true, start: rest,\n"
    "  in_place: true, paper_tangent: true}\n"
    "show: springs\n"
    "sleep_threshold: 0.001\n"
    "seconds: 12\n"
    "camera: {eye: [1, 2, 3], look: [4, 5, 6]}\n"
    "about: [{output: balloon0.cy, at: 20, tolerance: 0.05}]\n"
    "fails: {at: 2, output: balloon0.cy, above: 0.5, truth: -1, cure: [step=0.001, gravity=1]}\n"
    "contact: paper\n"
    "spheres: [{position: [1, 2, 3], velocity: [4, 5, 6], radius: 0.5, mass: 2, restitution: "
    "0.25,\n"
    "  friction: 0.75}]\n"
    "walls: [{at: [0, 0, -7], normal: [0, 0, 2]}]\n"
    "things: [{model: box, size: [1, 2, 3], scale: 2, rotation: [10, 20, 30], color: [1, 0.5, 0],\n"
    "  friction: 0.25, path: [{at: 1, position: [0, 1, 0]}, {at: 3, position: [4, 1, 0],\n"
    "  rotation: [0, 90, 0]}]}]\n"
    "knots: [{path: [{at: 1, position: [0, 1, 0]}]}, {position: [1, 2, 3], mass: 0.5}]\n"
    "pipes: [{from: 0, to: 1, conductance: 1e-3, start: 0.5}]\n"
    "balloons:\n"
    "  - model: cube-sphere:4\n"
    "    position: [1, -2, 3e-1]\n"
    "    size: 2\n"
    "    scale: 3\n"
    "    rotation: 90\n"
    "    color: [0.1, 0.2, 1]\n"
    "    skin: {springs: {structural: 50, shear: 10, flexion: 11, torsion: 12, law: rubber}}\n"
    "    mass: {per_particle: 0.001}\n"
    "    hold_rim: true\n"
    "    inflation: {law: gas, amount: 1.5, rate: 2, min: 0.5, max: 9, ambient: 1e5,\n"
    "                unit: 2e5, temperature: 300, adiabatic: true, filling: helium, leak: 1e-6,\n"
    "                vent: 1e-5,\n"
    "                fill: {to: 3, start: 0.25, seconds: 0.5}}\n"
    "    helium: {base: 20, per_inflation: 5}\n"
    "    damping: {coefficient: 0.2, rate: 0}\n"
    "    strain_limit: {structural: 0.1, shear: 0.2, flexion: 0.3, tarantino: true,\n"
    "                 phantom: true}\n"
    "    strings:\n"
    "      - {to: [0, -6, 0.5], at: nearest, stiffness: 50, slack: 1.2}\n"
    "      - {at: 12, stiffness: 7}\n"
    "      - {to_balloon: 1, to_at: 3, stiffness: 8}\n"
    "      - {to_knot: 1, stiffness: 9}\n"
    "      - {to_thing: 0, to_at: lowest, stiffness: 9}\n"
    "    pins: [{at: [0, 1, 2], radius: 0.5}, {at: [0, 3, 2], radius: 0.25, to_thing: 0}]\n"
    "  - model: cube-sphere:4\n"
    "    skin:\n"
    "      membrane: {material: stvk-3d, young: 1e6, poisson: 0.4, density: 1000,\n"
    "        thickness: 3e-4, volume: local, patches: [{at: [0, 1, 0], radius: 0.5,\n"
    "        thickness: 1e-4}]}\n"
    "    inflation: {law: gas, amount: 2}\n";

static char folder[] = "/tmp/balloon-scene-XXXXXX";
static char scene[64];  // the file that tests write
static char beside[64]; // a model beside it

static inline int make_folder(void** state) {
    (void)state;
    if (!mkdtemp(folder))
        return -1;
    snprintf(scene, sizeof scene, "%s/scene.yaml", folder);
    snprintf(beside, sizeof beside, "%s/beside.obj", folder);
    return 0;
}

static inline int remove_folder(void** state) {
    (void)state;
    remove(scene);
    remove(beside);
    return rmdir(folder);
}

static inline void write_bytes(const char* path, const void* bytes, size_t size) {
    FILE* out = fopen(path, "wb");
    assert_non_null(out);
    assert_int_equal(fwrite(bytes, 1, size, out), size);
    assert_int_equal(fclose(out), 0);
}

// Load a text with overrides, which end with NULL.
static inline bool load(const char* text, const char* const* set, WorldDef* def, Fault* fault) {
    SceneSet sets[MAX_SETS];
    int count = 0;
    while (set && set[count]) {
        sets[count].text = set[count];
        count++;
    }
    *fault = (Fault){0};
    write_bytes(scene, text, strlen(text));
    return scene_load(scene, sets, count, def, fault);
}

static inline void must_load(const char* text, const char* const* set, WorldDef* def) {
    Fault fault;
    if (!load(text, set, def, &fault))
        fail_msg("%s: %s", fault.location, fault.text);
}

// The fault must be at this location and its sentence must hold these words.
static inline void must_refuse(const char* text, const char* const* set, const char* location,
                               const char* words) {
    WorldDef def;
    Fault fault;
    if (load(text, set, &def, &fault))
        fail_msg("this was taken, and not refused with '%s':\n%s", words, text);
    if (strcmp(fault.location, location) != 0 || !strstr(fault.text, words))
        fail_msg("got  %s: %s\nwant %s: … %s …\nof\n%s", fault.location, fault.text, location,
                 words, text);
    assert_null(strchr(fault.text, '\n'));
    assert_null(def.pool.newest);
}

static inline void assert_vector(const double* vector, double x, double y, double z) {
    assert_non_null(vector);
    assert_true(vector[0] == x && vector[1] == y && vector[2] == z);
}

#endif
