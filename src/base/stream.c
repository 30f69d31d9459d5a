#include "base/stream.h"

#include <errno.h>
#include <string.h>

FILE* stream_create(const char* path, Fault* fault) {
    FILE* out = strcmp(path, "-") == 0 ? stdout : fopen(path, "w");
    if (!out)
        fault_set(fault, path, "cannot be written: %s", strerror(errno));
    return out;
}

bool stream_close(FILE* out, const char* path, Fault* fault) {
    const bool lost_before = ferror(out) != 0;
    errno = 0;
    const bool flushed = fflush(out) == 0;
    const int flush_error = errno;
    const bool closed = out == stdout || fclose(out) == 0;
    if (flushed && closed && !lost_before)
        return true;
    const int error = flushed ? errno : flush_error;
    return fault_set(fault, path, "could not be written to its end%s%s", error ? ": " : "",
                     error ? strerror(error) : "");
}
