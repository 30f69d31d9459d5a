#include "lab/run/result_file.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

enum { PATH_BYTES = 1024, LINE_BYTES = 256 };

static bool may_overwrite;

void result_file_overwrite(bool allowed) {
    may_overwrite = allowed;
}

bool result_folder(const char* folder, Fault* fault) {
    char part[PATH_BYTES];
    if (strlen(folder) >= sizeof part)
        return fault_set(fault, folder, "this folder's path is too long");
    for (size_t k = 1; k <= strlen(folder); k++) {
        if (folder[k] != '/' && folder[k] != '\0')
            continue;
        snprintf(part, sizeof part, "%.*s", (int)k, folder);
        if (mkdir(part, 0777) != 0 && errno != EEXIST)
            return fault_set(fault, folder, "this folder cannot be made: %s", strerror(errno));
    }
    return true;
}

/// Whether the path has no file, an empty one, a device, or a file that begins with the mark.
static bool is_own(const char* path, const char* mark) {
    struct stat about;
    if (stat(path, &about) != 0 || !S_ISREG(about.st_mode) || about.st_size == 0)
        return true;
    char line[LINE_BYTES] = "";
    FILE* in = fopen(path, "r");
    const bool has_line = in && fgets(line, sizeof line, in);
    if (in)
        fclose(in);
    return mark[0] && has_line && strncmp(line, mark, strlen(mark)) == 0;
}

bool result_file_allowed(const char* folder, const char* name, const char* mark, Fault* fault) {
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return may_overwrite || is_own(path, mark) ||
           fault_set(fault, path, "is there and not made by balloon; --overwrite writes over it");
}

FILE* result_file_open(const char* folder, const char* name, const char* mark, Fault* fault) {
    char path[PATH_BYTES];
    if (!result_file_allowed(folder, name, mark, fault))
        return NULL;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE* out = fopen(path, "w");
    if (!out)
        fault_set(fault, path, "cannot be written: %s", strerror(errno));
    return out;
}

bool result_file_close(FILE* out, const char* folder, const char* name, Fault* fault) {
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    const bool whole = !ferror(out);
    return (fclose(out) == 0 && whole) ||
           fault_set(fault, path, "could not be written to its end: %s", strerror(errno));
}
