/// Files of results, in a folder that is made where it does not exist.
///
/// A file that begins with the mark of its kind, such as the header line of a table, was written by
/// the program and is replaced. Any other file is replaced only with --overwrite.
#ifndef BALLOON_LAB_RUN_RESULT_FILE_H
#define BALLOON_LAB_RUN_RESULT_FILE_H

#include "base/fault.h"

/// Whether other files may be replaced from now on; initially they may not.
void result_file_overwrite(bool allowed);

/// Make a folder and its parents.
bool result_folder(const char* folder, Fault* fault);

/// Whether FOLDER/NAME may be written; else a fault names it. mark: empty for a kind of file
/// without a
bool result_file_allowed(const char* folder, const char* name, const char* mark, Fault* fault);

/// Open FOLDER/NAME for writing. NULL with a fault if it may not or cannot be written.
FILE* result_file_open(const char* folder, const char* name, const char* mark, Fault* fault);

/// Close the file; a fault if not all of it could be written.
bool result_file_close(FILE* out, const char* folder, const char* name, Fault* fault);

#endif
