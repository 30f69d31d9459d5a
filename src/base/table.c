#include "base/table.h"

#include <stdio.h>
#include <string.h>

/// The name of row k: a row begins with it, so a pointer to the row points to it too.
static const char* name_of(const void* table, int k) {
    const char* const* row;
    memcpy(&row, (const char*)table + (size_t)k * sizeof row, sizeof row);
    return *row;
}

const void* table_find(const void* table, int count, const char* name) {
    for (int k = 0; k < count; k++)
        if (strcmp(name_of(table, k), name) == 0) {
            const void* row;
            memcpy(&row, (const char*)table + (size_t)k * sizeof row, sizeof row);
            return row;
        }
    return NULL;
}

const char* table_names(const void* table, int count, char* names, size_t size) {
    size_t used = 0;
    names[0] = 0;
    for (int k = 0; k < count && used < size; k++)
        used +=
            (size_t)snprintf(names + used, size - used, "%s%s", k ? ", " : "", name_of(table, k));
    return names;
}
