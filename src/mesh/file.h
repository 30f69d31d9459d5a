/// A file in memory.
#ifndef BALLOON_MESH_FILE_H
#define BALLOON_MESH_FILE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"

typedef struct FileText {
    char* text;  ///< [size + 1] ends with a zero that is not counted
    size_t size; ///< [bytes]
} FileText;

/// Read a file of at most `size_max` bytes unchanged. Other than regular files, empty and longer
/// files are refused.
bool file_read_bytes(FileText* file, const char* path, size_t size_max, Fault* fault);

/// The same for a text: every line end becomes \n, and blanks replace a byte order mark. A zero
/// byte is refused.
bool file_read(FileText* file, const char* path, size_t size_max, Fault* fault);

void file_free(FileText* file);

#endif
