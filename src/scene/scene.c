#include "scene/scene.h"

#include <errno.h>
#include <locale.h>
#include <stdlib.h>
#include <string.h>

#include "base/input_file.h"
#include "base/memory.h"
#include "base/memory_missing.h"
#include "scene/find.h"
#include "scene/rename.h"
#include "scene/rules.h"
#include "scene/tree.h"
#include "scene/validate.h"

enum { SCENE_BYTES_MAX = 1 << 18 }; ///< [bytes] some hundred balloons

static bool read_stream(FILE* in, const char* path, char* text, size_t* size, Fault* fault) {
    *size = fread(text, 1, SCENE_BYTES_MAX + 1, in);
    if (ferror(in))
        return fault_set(fault, path, "it cannot be read: %s", strerror(errno));
    if (*size > SCENE_BYTES_MAX)
        return fault_set(fault, path, "a scene has at most %d bytes", SCENE_BYTES_MAX);
    return true;
}

static bool read_file(const char* path, char** text, size_t* size, Fault* fault) {
    FILE* in = input_file_open(path, fault);
    if (!in)
        return false;
    *text = new_array(char, SCENE_BYTES_MAX + 1);
    const bool good = read_stream(in, path, *text, size, fault);
    fclose(in);
    return good;
}

// The tree of a scene's file, or of the scene that a bare mesh gets.
static bool read_tree(const SceneSource* source, SceneTree* tree, Fault* fault) {
    if (source->model[0])
        return tree_parse(tree, mesh_scene, strlen(mesh_scene), fault) &&
               tree_set_text(tree, "balloons.0.model", source->model, fault);

    char* text = NULL;
    size_t size = 0;
    const bool good =
        read_file(source->file, &text, &size, fault) && tree_parse(tree, text, size, fault);
    free(text);
    if (good && !tree_node(tree, TREE_ROOT))
        return fault_set(fault, source->file, "this scene is empty; it needs a step and balloons");
    return good;
}

// Put the overrides in, all by present names.
static bool set_all(SceneTree* tree, int set_count, const Renamed* renamed, Fault* fault) {
    rename_tree(tree, renamed);
    for (int i = 0; i < set_count; i++) {
        char path[PATH_LONGEST];
        const char* value;
        if (!tree_set_path(tree, i, path, &value, fault))
            return false;
        rename_path(path, renamed);
        if (!tree_set(tree, i, path, value, fault))
            return false;
    }
    if (set_count > 0)
        rename_tree(tree, renamed);
    return true;
}

// The whole way from a name to a def, in a locale in which numbers have a point. text: the scene as
// it then is, or NULL.
static bool load(const char* name, const SceneSet* set, int set_count, bool for_people, char** text,
                 WorldDef* def, Fault* fault) {
    SceneSource source;
    if (!scene_find(name, &source, fault))
        return false;

    SceneTree tree = {.file = source.file, .numbered = !source.model[0], .set = set};
    const Renamed renamed = {def->renamed, sizeof def->renamed};
    bool good = read_tree(&source, &tree, fault) && set_all(&tree, set_count, &renamed, fault) &&
                validate_scene(&tree, def, fault) && rules_hold(def, &tree, fault);
    if (good)
        snprintf(def->file, sizeof def->file, "%s", tree.file);
    size_t size;
    if (good && text && !(*text = tree_text(&tree, for_people, &size)))
        good =
            fault_set(fault, tree.file, "a text in it is not UTF-8, and cannot be written as YAML");
    tree_free(&tree);
    if (!good)
        scene_free(def);
    return good;
}

static bool load_with_points(const char* name, const SceneSet* set, int set_count, bool for_people,
                             char** text, WorldDef* def, Fault* fault) {
    *def = (WorldDef){0};
    const locale_t point = newlocale(LC_NUMERIC_MASK, "C", (locale_t)0);
    if (!point)
        memory_missing("a locale");
    const locale_t before = uselocale(point);
    const bool good = load(name, set, set_count, for_people, text, def, fault);
    uselocale(before);
    freelocale(point);
    return good;
}

static bool loads(const char* name, const SceneSet* set, int set_count) {
    WorldDef def;
    Fault unused = {0};
    const bool good = load_with_points(name, set, set_count, false, NULL, &def, &unused);
    if (good)
        scene_free(&def);
    return good;
}

void scene_blame(const char* name, const SceneSet* set, int set_count,
                 bool (*opens)(const char* name, const SceneSet* set, int set_count),
                 Fault* fault) {
    if (strncmp(fault->location, "--set ", 6) == 0 || !opens(name, set, 0))
        return;
    int first = 1;
    while (first < set_count && opens(name, set, first))
        first++;
    snprintf(fault->location, sizeof fault->location, "--set %s", set[first - 1].text);
}

bool scene_load(const char* name, const SceneSet* set, int set_count, WorldDef* def, Fault* fault) {
    const bool good = load_with_points(name, set, set_count, false, NULL, def, fault);
    if (!good && set_count > 0)
        scene_blame(name, set, set_count, loads, fault);
    return good;
}

char* scene_text(const char* name, const SceneSet* set, int set_count, bool for_people,
                 Fault* fault) {
    WorldDef def;
    char* text = NULL;
    if (load_with_points(name, set, set_count, for_people, &text, &def, fault))
        scene_free(&def);
    return text;
}

void scene_say_renamed(const WorldDef* def) {
    if (def->renamed[0])
        fprintf(stderr, "balloon: %s: keys have new names: %s\n", def->file, def->renamed);
}

void scene_free(WorldDef* def) {
    pool_free(&def->pool);
    *def = (WorldDef){0};
}
