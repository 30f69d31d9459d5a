#include "scene/key.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/table.h"

bool key_at(const KeyGroup* group, int index, Key* key) {
    if (index < group->count) {
        *key = group->key[index];
        return true;
    }
    index -= group->count;
    if (index >= group->parameter_count)
        return group->more && group->more(index - group->parameter_count, key);
    *key = (Key){.is = group->parameter[index],
                 .type = KEY_NUMBER,
                 .offset = (size_t)index * sizeof(double)};
    return true;
}

bool key_is_of(const Key* key, const char* of) {
    return !key->of || !of || strcmp(key->of, of) == 0;
}

bool key_find(const KeyGroup* group, const char* of, const char* name, Key* key) {
    for (int i = 0; key_at(group, i, key); i++)
        if (key_is_of(key, of) && strcmp(key->is.name, name) == 0)
            return true;
    return false;
}

KeyGroup key_group(const Key* key) {
    return key->group ? *key->group
                      : (KeyGroup){.parameter = key->parameter,
                                   .parameter_count = key->parameter_count,
                                   .size = FORCE_PARAMETERS_MAX * sizeof(double)};
}

void key_names(const KeyGroup* group, const char* of, char* names, size_t size) {
    Key key;
    names[0] = '\0';
    for (int i = 0; key_at(group, i, &key); i++)
        if (key_is_of(&key, of))
            table_add_name(names, size, key.is.name);
}

bool key_allows(const Parameter* range, double value) {
    return (range->min_open ? value > range->min : value >= range->min) &&
           (range->max_open ? value < range->max : value <= range->max);
}

void key_range(const Parameter* range, char words[96]) {
    const char* from = range->min_open ? "greater than" : "at least";
    if (range->min == -INFINITY && range->max == INFINITY)
        snprintf(words, 96, "any number");
    else if (range->min == range->max)
        snprintf(words, 96, "%g", range->min);
    else if (range->max == INFINITY)
        snprintf(words, 96, "%s %g", from, range->min);
    else
        snprintf(words, 96, "%s %g and %s %g", from, range->min,
                 range->max_open ? "less than" : "at most", range->max);
}

typedef struct Visit {
    void (*visit)(const char* path, const Key* key, void* context);
    void* context;
    char path[128];
} Visit;

static void visit_group(Visit* visit, const KeyGroup* group) {
    const size_t length = strlen(visit->path);
    Key key;
    for (int i = 0; key_at(group, i, &key); i++) {
        snprintf(visit->path + length, sizeof visit->path - length, "%s%s", length ? "." : "",
                 key.is.name);
        visit->visit(visit->path, &key, visit->context);
        if (key.type == KEY_LIST)
            strncat(visit->path, ".*", sizeof visit->path - strlen(visit->path) - 1);
        const KeyGroup below = key_group(&key);
        visit_group(visit, &below);
    }
    visit->path[length] = '\0';
}

void key_each(void (*visit)(const char* path, const Key* key, void* context), void* context) {
    Visit all = {.visit = visit, .context = context};
    visit_group(&all, &scene_keys);
}
