#include <stdio.h>
#include <stdlib.h>

#include "cli/bench_table.h"
#include "cli/verb.h"
#include "contact/skins/crossings.h"
#include "force/force.h"
#include "lab/chart/chart_case.h"
#include "mesh/load.h"
#include "mesh/shape.h"
#include "scene/reference.h"
#include "solve/method.h"
#include "view/mode.h"
#include "world/fails.h"
#include "world/outputs.h"
#include "world/record.h"

/// Number of a triangle's face, from 1 in the order of the file.
static int face_of_triangle(const Mesh* mesh, int triangle) {
    int face = 0;
    for (int triangles = 0; face < mesh->face_count && triangles <= triangle; face++)
        triangles += face_corners(mesh->face[face]) - 2;
    return face;
}

/// Crossings of the mesh with itself: such a skin does not touch itself until it has come apart.
static void print_crossings(const Mesh* mesh) {
    Body body;
    body_make(&body, mesh, &(Placement){.scale = 1}, 1);
    const Crossings crossings = crossings_of_skin(&body);
    printf("crossing pairs of triangles: %d", crossings.count);
    const int a = face_of_triangle(mesh, crossings.triangle[0]),
              b = face_of_triangle(mesh, crossings.triangle[1]);
    if (crossings.count > 0)
        printf(", the first of faces %d and %d", a < b ? a : b, a < b ? b : a);
    printf("\n");
    body_free(&body);
}

bool verb_check(const Options* options, Fault* fault) {
    Mesh mesh = {0};
    MeshReport report = {0};
    char path[512];
    const WorldDef nowhere = {0};
    if (!options->target)
        return fault_set(fault, NULL, "check which mesh? See balloon --help");
    if (!scene_model_path(&nowhere, options->target, path, fault))
        return false;
    const bool good = mesh_load(path, &mesh, &report, fault);
    if (good || report.unusable.text[0])
        doctor_print(&report, stdout);
    if (!good)
        return false;

    int vertex = 0;
    const double paths = springs_paths(&mesh, &vertex);
    const bool all[SPRING_KINDS] = {true, true, paths <= SPRING_PATHS_MAX};
    Springs springs = {0};
    springs_find(&mesh, all, &springs);
    for (int kind = 0; kind < SPRING_KINDS; kind++)
        if (all[kind])
            printf("%s springs: %d\n", spring_kind_name[kind],
                   springs.from[kind + 1] - springs.from[kind]);
        else
            printf("%s springs: too many to be made, up to %.3g\n", spring_kind_name[kind], paths);
    springs_free(&springs);
    print_crossings(&mesh);
    mesh_free(&mesh);
    return true;
}

/// List the scenes with a `fails` block, or those without.
static void list_scenes(char** path, int count, bool failures) {
    for (int k = 0; k < count; k++) {
        WorldDef def;
        Fault bad = {0};
        const bool good = scene_load(path[k], NULL, 0, &def, &bad);
        char name[256], words[512];
        scene_name(path[k], name);
        if (failures == (good && def.fails)) {
            printf("  %-22s %s\n", name, !good ? bad.text : def.title ? def.title : "");
            if (failures) {
                fails_words(def.fails, words, sizeof words);
                printf("  %-22s %s\n", "", words);
            }
        }
        if (good)
            scene_free(&def);
    }
}

bool verb_list(const Options* options, Fault* fault) {
    (void)options;
    (void)fault;
    char** path;
    const int scenes = scene_list(&path);
    puts("scenes (assets/scenes)");
    list_scenes(path, scenes, false);
    puts("scenes that fail (assets/scenes/fails)");
    list_scenes(path, scenes, true);
    for (int k = 0; k < scenes; k++)
        free(path[k]);
    free(path);
    puts("models that the program makes itself");
    for (int k = 0; k < shape_count; k++)
        printf("  %-22s %s\n", shape_table[k].name, shape_table[k].about);
    puts("forces");
    for (int k = 0; k < force_count; k++)
        printf("  %-22s %s\n", force_table[k]->name, force_table[k]->about);
    puts("methods");
    for (int k = 0; k < method_count; k++)
        printf("  %-22s %s\n", method_table[k]->name, method_table[k]->about);
    puts("benches");
    for (int k = 0; k < bench_count; k++)
        printf("  %-22s %s\n", bench_table[k]->name, bench_table[k]->about);
    puts("charts");
    for (int k = 0; k < chart_count; k++)
        printf("  %s %-20s %s\n", chart_table[k]->letter, chart_table[k]->scene,
               chart_table[k]->about);
    puts("display modes");
    for (int k = 0; k < mode_count; k++)
        printf("  %-22s %s\n", mode_table[k]->name, mode_table[k]->about);
    return true;
}

bool verb_keys(const Options* options, Fault* fault) {
    (void)options;
    (void)fault;
    scene_reference(stdout);
    outputs_reference(stdout);
    record_reference(stdout);
    return true;
}
