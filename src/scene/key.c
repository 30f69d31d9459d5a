#include "scene/key.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/table.h"

const Key* key_find(const KeyGroup* group, const char* name) {
    return table_row_of(group->key, group->count, sizeof *group->key, name);
}

void key_names(const KeyGroup* group, char* names, size_t size) {
    table_names_of(group->key, group->count, sizeof *group->key, names, size);
}

bool key_allows(const Parameter* range, double value) {
    return (range->min_open ? value > range->min : value >= range->min) &&
           (range->max_open ? value < range->max : value <= range->max);
}

void key_range(const Parameter* range, char words[96]) {
    const char* from = range->min_open ? "greater than" : "at least";
    if (range->min == -INFINITY && range->max == INFINITY)
        snprintf(words, 96, "any number");
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
    for (int i = 0; i < group->count; i++) {
        const Key* key = &group->key[i];
        snprintf(visit->path + length, sizeof visit->path - length, "%s%s", length ? "." : "",
                 key->is.name);
        visit->visit(visit->path, key, visit->context);
        if (key->type == KEY_LIST)
            strncat(visit->path, ".*", sizeof visit->path - strlen(visit->path) - 1);
        if (key->group)
            visit_group(visit, key->group);
    }
    visit->path[length] = '\0';
}

void key_each(void (*visit)(const char* path, const Key* key, void* context), void* context) {
    Visit all = {.visit = visit, .context = context};
    visit_group(&all, &scene_keys);
}
