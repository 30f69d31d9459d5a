#include "scene/find.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#include "base/paths.h"
#include "base/table.h"
#include "mesh/load.h"
#include "mesh/shape.h"
#include "scene/scene.h"

enum { NAMES_SHOWN = 8 }; ///< scenes that a sentence lists

// The paper's numbers, and the authors' program's where the paper has none. The floor is three
// below the model, which lies between -1 and 1.
const char mesh_scene[] = "units: paper\n"
                          "step: 0.002\n"
                          "floor: -4\n"
                          "balloons:\n"
                          "  - model: cube\n"
                          "    size: 2\n"
                          "    skin: {springs: {structural: 50, shear: 10, flexion: 10}}\n"
                          "    mass: {per_particle: 0.001}\n"
                          "    inflation: {law: area, amount: 1, rate: 5}\n"
                          "    helium: {base: 20, per_inflation: 5}\n"
                          "    damping: {coefficient: 0.2}\n"
                          "    strings: [{at: lowest, stiffness: 50}]\n";

static bool exists(const char* path) {
    struct stat about;
    return stat(path, &about) == 0;
}

static bool ends_with(const char* name, const char* ending) {
    const size_t length = strlen(name), tail = strlen(ending);
    return length >= tail && strcasecmp(name + length - tail, ending) == 0;
}

static const char* after_slash(const char* path) {
    const char* slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

// A path as typed, or one in our own folder.
static bool typed_or_own(const char* folder, const char* name, char path[512], Fault* fault) {
    if (exists(name) && strlen(name) < 512) {
        snprintf(path, 512, "%s", name);
        return true;
    }
    return paths_own(folder, name, path, fault);
}

static bool find_mesh(const char* name, SceneSource* source) {
    Fault unused = {0};
    if (shape_find(name)) {
        snprintf(source->file, sizeof source->file, "%s", name);
        snprintf(source->model, sizeof source->model, "%s", name);
        return true;
    }
    if (!mesh_format_of(name) || !typed_or_own("assets/models", name, source->file, &unused))
        return false;
    snprintf(source->model, sizeof source->model, "%s", after_slash(source->file));
    return true;
}

static bool find_scene(const char* name, SceneSource* source) {
    Fault unused = {0};
    char file[512];
    if (ends_with(name, ".yaml") || ends_with(name, ".yml"))
        return typed_or_own("assets/scenes", name, source->file, &unused);
    return snprintf(file, sizeof file, "%s.yaml", name) < (int)sizeof file &&
           paths_own("assets/scenes", file, source->file, &unused);
}

// "bowling, exact-cube, fails/stiff, …"
static void scene_words(char* words, size_t size) {
    char** path;
    const int count = scene_list(&path);
    words[0] = '\0';
    for (int i = 0; i < count; i++) {
        char name[256];
        scene_name(path[i], name);
        if (i < NAMES_SHOWN)
            table_add_name(words, size, name);
        free(path[i]);
    }
    free(path);
    if (count > NAMES_SHOWN)
        table_add_name(words, size, "…");
}

bool scene_find(const char* name, SceneSource* source, Fault* fault) {
    *source = (SceneSource){0};
    if (find_mesh(name, source) || find_scene(name, source))
        return true;

    char scenes[300], shapes[200];
    scene_words(scenes, sizeof scenes);
    table_names_of(shape_table, shape_count, sizeof *shape_table, shapes, sizeof shapes);
    return fault_set(fault, name,
                     "there is no such scene or mesh, here or in assets/scenes and assets/models; "
                     "scenes are %s; shapes are %s; or give the path of a .yaml or a mesh",
                     scenes, shapes);
}

static bool beside(const char* file, const char* model, char path[512]) {
    const int folder = (int)(after_slash(file) - file);
    return model[0] != '/' && snprintf(path, 512, "%.*s%s", folder, file, model) < 512 &&
           exists(path);
}

bool scene_model_path(const WorldDef* def, const char* model, char path[512], Fault* fault) {
    Fault unused = {0};
    if (!shape_find(model) &&
        (beside(def->file, model, path) || paths_own("assets/models", model, path, &unused)))
        return true;

    // a shape, or a path from the working folder
    snprintf(path, 512, "%s", model);
    if (shape_find(model) || exists(path))
        return true;

    char shapes[200];
    table_names_of(shape_table, shape_count, sizeof *shape_table, shapes, sizeof shapes);
    return fault_set(fault, def->file,
                     "no model '%s'; it is not beside the scene, in assets/models or in the "
                     "working folder, nor one of the shapes %s",
                     model, shapes);
}
