/// Families are tables of pointers to rows, and each row begins with its name:
///
///     typedef struct Row { const char* name; … } Row;
///     extern const Row* const row_table[];
#ifndef BALLOON_BASE_TABLE_H
#define BALLOON_BASE_TABLE_H

#include <stddef.h>

/// The row of this name, or NULL. table: [count] pointers to rows that begin with a name.
const void* table_find(const void* table, int count, const char* name);

/// "first, second, …" into names, for sentences; returns names.
const char* table_names(const void* table, int count, char* names, size_t size);

#endif
