#include "base/paths.h"

#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { FOLDERS_UP = 4 }; ///< tests lie up to four folders below assets, build/KIND/PRECISION/tests

// The folder of the running program, without a slash at its end.
static bool program_folder(char path[512], Fault* fault) {
    const ssize_t length = readlink("/proc/self/exe", path, 511);
    if (length <= 0 || length >= 511)
        return fault_set(fault, "/proc/self/exe", "this does not say where the program is");
    path[length] = '\0';
    *strrchr(path, '/') = '\0';
    return true;
}

// Within the working folder a path is shown, and opened, as from there.
static void shorten(char path[512]) {
    char working[512];
    if (!getcwd(working, sizeof working))
        return;
    const size_t length = strlen(working);
    if (strncmp(path, working, length) == 0 && path[length] == '/' && path[length + 1])
        memmove(path, path + length + 1, strlen(path + length + 1) + 1);
}

static bool is_there(char path[512], const char* base, const char* share, const char* folder,
                     const char* file) {
    struct stat about;
    if (snprintf(path, 512, "%s%s/%s/%s", base, share, folder, file) >= 512 ||
        stat(path, &about) != 0)
        return false;
    shorten(path);
    return true;
}

bool paths_own(const char* folder, const char* file, char path[512], Fault* fault) {
    char program[512];
    if (!program_folder(program, fault))
        return false;

    char base[512];
    snprintf(base, sizeof base, "%s", program);
    for (int up = 0; up < FOLDERS_UP && strrchr(base, '/'); up++) {
        *strrchr(base, '/') = '\0';
        if (is_there(path, base, "", folder, file) ||
            is_there(path, base, "/share/balloon", folder, file))
            return true;
    }
    return fault_set(fault, file, "there is none in %s or share/balloon/%s above the program in %s",
                     folder, folder, program);
}

bool paths_sibling(const char* name, char path[512], Fault* fault) {
    char program[512];
    if (!program_folder(program, fault))
        return false;
    if (snprintf(path, 512, "%s/%s", program, name) < 512 && access(path, X_OK) == 0)
        return true;
    return fault_set(fault, name, "there is no such program in %s; build it with make", program);
}
