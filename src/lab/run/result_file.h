/// Files of results, in a folder that is made where it does not exist.
///
/// A file that begins with the mark of its kind, such as the head of a table, is the program's own and
/// is written anew without a question. Any other is written over only with --overwrite.
#ifndef BALLOON_LAB_RUN_RESULT_FILE_H
#define BALLOON_LAB_RUN_RESULT_FILE_H

#include "base/fault.h"

/// Whether files of others may be written over from now on; at first they may not.
void result_file_overwrite(bool allowed);

/// Make a folder, and those above it.
bool result_folder(const char* folder, Fault* fault);

/// Whether FOLDER/NAME may be written; else a fault names it. mark: empty for a file without any
bool result_file_allowed(const char* folder, const char* name, const char* mark, Fault* fault);

/// Open FOLDER/NAME for writing. NULL with a fault where that may not or cannot be.
FILE* result_file_open(const char* folder, const char* name, const char* mark, Fault* fault);

/// Close it; a fault if it could not be written to its end.
bool result_file_close(FILE* out, const char* folder, const char* name, Fault* fault);

#endif
