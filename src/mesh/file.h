/// A whole text file in memory.
#ifndef BALLOON_MESH_FILE_H
#define BALLOON_MESH_FILE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"

typedef struct FileText {
    char* text;  ///< [size + 1] ends with a zero that is not counted
    size_t size; ///< [bytes]
} FileText;

/// Read a file of at most `most` bytes; every line ends with \n in memory, whatever ended it in the
/// file, and a byte order mark has become blanks. Refused: what is no regular file, empty, too
/// long, or holds a zero byte.
bool file_read(FileText* file, const char* path, size_t most, Fault* fault);

void file_free(FileText* file);

#endif
