/// Files that the program writes. Bytes that were lost, on a full disk for example, are a fault of
/// the stream that lost them: every stream is closed by stream_close, standard output too.
#ifndef BALLOON_BASE_STREAM_H
#define BALLOON_BASE_STREAM_H

#include "base/fault.h"

/// Open a file for writing, "-" for standard output; NULL with a fault.
FILE* stream_create(const char* path, Fault* fault);

/// Close the stream, or flush standard output. False with a fault if anything written was lost.
bool stream_close(FILE* out, const char* path, Fault* fault);

#endif
