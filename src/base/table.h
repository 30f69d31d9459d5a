/// Families are tables whose rows begin with their names. A table holds rows, or pointers to rows:
///
///     typedef struct Row { const char* name; … } Row;
///     extern const Row row_table[];            table_row_of, table_names_of, with the size of a row
///     extern const Row* const row_table[];     table_find, table_names
///
/// A plain list of names, const char* const list[], is a table of rows that hold nothing else.
#ifndef BALLOON_BASE_TABLE_H
#define BALLOON_BASE_TABLE_H

#include <stddef.h>

/// The row of this name, or NULL. table: [count] rows of row_size bytes.
const void* table_row_of(const void* table, int count, size_t row_size, const char* name);

/// "first, second, …" into names, for sentences; returns names. What does not fit is cut off.
const char* table_names_of(const void* table, int count, size_t row_size, char* names, size_t size);

/// The same for [count] pointers to rows.
const void* table_find(const void* table, int count, const char* name);
const char* table_names(const void* table, int count, char* names, size_t size);

/// Append ", NAME", or "NAME" to an empty text, for lists that leave some names out.
void table_add_name(char* names, size_t size, const char* name);

#endif
