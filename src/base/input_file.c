#include "base/input_file.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool is_regular(int descriptor, const char* path, Fault* fault) {
    struct stat status;
    if (fstat(descriptor, &status) != 0)
        return fault_set(fault, path, "it cannot be read: %s", strerror(errno));
    if (S_ISDIR(status.st_mode))
        return fault_set(fault, path, "it is a folder; name a file in it");
    return S_ISREG(status.st_mode) ||
           fault_set(fault, path, "it is a pipe or a device; name a file");
}

FILE* input_file_open(const char* path, Fault* fault) {
    // without O_NONBLOCK to open a pipe waits for its writer
    const int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (descriptor < 0) {
        fault_set(fault, path, "it cannot be opened: %s", strerror(errno));
        return NULL;
    }
    FILE* file = is_regular(descriptor, path, fault) ? fdopen(descriptor, "rb") : NULL;
    if (!file)
        close(descriptor);
    return file;
}
