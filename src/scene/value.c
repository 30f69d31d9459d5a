/// The values of a loaded scene, by the rows of the table of keys.
#include "scene/key.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct Walk {
    void (*visit)(const KeyValue* value, void* context);
    void* context;
    char path[128];
    char pattern[128];
} Walk;

/// Lengths of both paths, to go back to.
typedef struct Depth {
    size_t path, pattern;
} Depth;

static Depth enter(Walk* walk, const char* part, const char* pattern) {
    const Depth depth = {strlen(walk->path), strlen(walk->pattern)};
    const char* dot = depth.path ? "." : "";
    snprintf(walk->path + depth.path, sizeof walk->path - depth.path, "%s%s", dot, part);
    snprintf(walk->pattern + depth.pattern, sizeof walk->pattern - depth.pattern, "%s%s", dot,
             pattern);
    return depth;
}

static void leave(Walk* walk, Depth depth) {
    walk->path[depth.path] = '\0';
    walk->pattern[depth.pattern] = '\0';
}

static void* pointer_at(const char* field) {
    void* pointer;
    memcpy(&pointer, field, sizeof pointer);
    return pointer;
}

static double number_at(const Key* key, const char* field) {
    double number = NAN;
    const void* from = NULL; // what follows a field of another type may end before a pointer's size
    if (key->type == KEY_NUMBER)
        from = field;
    else if (key->type == KEY_OPTIONAL)
        from = pointer_at(field);
    if (from)
        memcpy(&number, from, sizeof number);
    return number;
}

static unsigned count_at(const Key* key, const char* filled) {
    unsigned count;
    memcpy(&count, filled + key->count_offset, sizeof count);
    return count;
}

static bool is_present(const Key* key, const char* filled) {
    const char* field = filled + key->offset;
    int name = 0;
    switch (key->type) {
        case KEY_NUMBER:
            return number_at(key, field) != 0;
        case KEY_NAME:
            memcpy(&name, field, sizeof name);
            return name != 0;
        case KEY_FLAG:
            return *field;
        case KEY_LIST:
        case KEY_TEXTS:
            return count_at(key, filled) > 0;
        case KEY_MAPPING:
            return true;
        default:
            return pointer_at(field);
    }
}

static const char* selected(const KeyGroup* group, const char* filled) {
    Key key;
    return group->selector && key_find(group, NULL, group->selector, &key)
               ? pointer_at(filled + key.offset)
               : NULL;
}

static void walk_group(Walk* walk, const KeyGroup* group, const char* filled);

static void walk_items(Walk* walk, const Key* key, const char* filled) {
    const KeyGroup group = key_group(key);
    const char* item = pointer_at(filled + key->offset);
    for (unsigned i = 0; i < count_at(key, filled); i++, item += group.size) {
        char number[16];
        snprintf(number, sizeof number, "%u", i);
        const Depth depth = enter(walk, number, "*");
        walk_group(walk, &group, item);
        leave(walk, depth);
    }
}

static void walk_value(Walk* walk, const Key* key, const char* filled) {
    const char* field = filled + key->offset;
    walk->visit(
        &(KeyValue){walk->path, walk->pattern, key, is_present(key, filled), number_at(key, field)},
        walk->context);
    const KeyGroup group = key_group(key);
    if (key->type == KEY_MAPPING)
        walk_group(walk, &group, field);
    else if (key->type == KEY_POINTER && pointer_at(field))
        walk_group(walk, &group, pointer_at(field));
    else if (key->type == KEY_LIST)
        walk_items(walk, key, filled);
}

static void walk_group(Walk* walk, const KeyGroup* group, const char* filled) {
    const char* of = selected(group, filled);
    Key key;
    for (int i = 0; key_at(group, i, &key); i++) {
        if (!key_is_of(&key, of))
            continue;
        const Depth depth = enter(walk, key.is.name, key.is.name);
        walk_value(walk, &key, filled);
        leave(walk, depth);
    }
}

void key_each_value(const WorldDef* def, void (*visit)(const KeyValue* value, void* context),
                    void* context) {
    Walk walk = {.visit = visit, .context = context};
    walk_group(&walk, &scene_keys, (const char*)def);
}
