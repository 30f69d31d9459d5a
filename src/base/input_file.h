/// A file to be read, whatever path a user names: a pipe or a device is refused at once, where
/// fopen() would wait for a writer, or read without an end.
#ifndef BALLOON_BASE_INPUT_FILE_H
#define BALLOON_BASE_INPUT_FILE_H

#include "base/fault.h"

/// Open a regular file for reading; NULL with a fault if there is none at this path. Closed with
/// fclose().
FILE* input_file_open(const char* path, Fault* fault);

#endif
