#include "base/table.h"

#include <stdio.h>
#include <string.h>

/// The pointer at these bytes, which may be of any type.
static const void* pointer_at(const void* table, int k, size_t row_size) {
    const void* pointer;
    memcpy(&pointer, (const char*)table + (size_t)k * row_size, sizeof pointer);
    return pointer;
}

const void* table_row_of(const void* table, int count, size_t row_size, const char* name) {
    for (int k = 0; k < count; k++)
        if (strcmp(pointer_at(table, k, row_size), name) == 0)
            return (const char*)table + (size_t)k * row_size;
    return NULL;
}

const char* table_names_of(const void* table, int count, size_t row_size, char* names,
                           size_t size) {
    names[0] = '\0';
    for (int k = 0; k < count; k++)
        table_add_name(names, size, pointer_at(table, k, row_size));
    return names;
}

const void* table_find(const void* table, int count, const char* name) {
    for (int k = 0; k < count; k++) {
        const void* row = pointer_at(table, k, sizeof row);
        if (strcmp(pointer_at(row, 0, 0), name) == 0)
            return row;
    }
    return NULL;
}

const char* table_names(const void* table, int count, char* names, size_t size) {
    names[0] = '\0';
    for (int k = 0; k < count; k++)
        table_add_name(names, size, pointer_at(pointer_at(table, k, sizeof(void*)), 0, 0));
    return names;
}

void table_add_name(char* names, size_t size, const char* name) {
    const size_t used = strlen(names);
    snprintf(names + used, size - used, "%s%s", used ? ", " : "", name);
}
