#include "cli/overwrite.h"

#include <dirent.h>
#include <fcntl.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lab/advice/advise.h"
#include "show/run.h"
#include "show/film/video.h"
#include "world/record.h"

/// An output: its option and path, and the bytes by which the program knows its own file.
typedef struct Target {
    const char* option;
    const char* path;
    const char* mark;
} Target;

static bool is_marked(int file, size_t size, const char* mark) {
    void* bytes = mmap(NULL, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (bytes == MAP_FAILED)
        return false;
    // a film's comment may stand at its end
    const size_t length = strlen(mark);
    const char *at = bytes, *last = at + size - length;
    bool found = false;
    while (size >= length && !found && at && at <= last) {
        at = memchr(at, mark[0], (size_t)(last - at) + 1);
        found = at && memcmp(at, mark, length) == 0;
        at = at ? at + 1 : NULL;
    }
    munmap(bytes, size);
    return found;
}

/// Whether there is no file of somebody else's at the path.
static bool is_free(const char* path, const char* mark) {
    struct stat about;
    const int file = open(path, O_RDONLY | O_NONBLOCK);
    if (file < 0)
        return access(path, F_OK) != 0;
    const bool other = fstat(file, &about) == 0 && S_ISREG(about.st_mode) && about.st_size > 0 &&
                       !is_marked(file, (size_t)about.st_size, mark);
    close(file);
    return !other;
}

static bool is_same(const char* a, const char* b) {
    struct stat one, other;
    return a && b && stat(a, &one) == 0 && stat(b, &other) == 0 && S_ISREG(one.st_mode) &&
           one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}

static bool stat_folder(const char* path, struct stat* about) {
    char folder[1024];
    const char* slash = strrchr(path, '/');
    return snprintf(folder, sizeof folder, "%.*s.", slash ? (int)(slash - path) + 1 : 0, path) <
               (int)sizeof folder &&
           stat(folder, about) == 0;
}

static const char* name_within_folder(const char* path) {
    const char* slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/// Whether the two lead to one file, which need not be there yet. Not for a device.
static bool is_one_file(const char* a, const char* b) {
    struct stat one, other;
    if (!a || !b || stat(a, &one) == 0)
        return is_same(a, b);
    return strcmp(name_within_folder(a), name_within_folder(b)) == 0 && stat_folder(a, &one) &&
           stat_folder(b, &other) && one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}

static bool may_write(const Options* options, const Target* target, Fault* fault) {
    if (!target->path || strcmp(target->path, "-") == 0)
        return true;
    if (is_same(target->path, options->input) || is_same(target->path, options->target))
        return fault_set(fault, target->option,
                         "%s is read by this command too; --overwrite writes over it",
                         target->path);
    return is_free(target->path, target->mark) ||
           fault_set(fault, target->option,
                     "%s is there and not made by balloon; --overwrite writes over it",
                     target->path);
}

/// The frames of a folder, which its pictures are when they are called so.
static bool frames_may_be_written(const Options* options, const char* folder, Fault* fault) {
    DIR* entries = opendir(folder);
    bool good = true;
    const struct dirent* entry;
    while (entries && good && (entry = readdir(entries))) {
        char path[1024];
        const size_t length = strlen(entry->d_name);
        if (strncmp(entry->d_name, "frame-", 6) == 0 && length > 4 &&
            strcmp(entry->d_name + length - 4, ".png") == 0 &&
            snprintf(path, sizeof path, "%s/%s", folder, entry->d_name) < (int)sizeof path)
            good = may_write(options, &(Target){"--out", path, VIDEO_MARK}, fault);
    }
    if (entries)
        closedir(entries);
    return good;
}

bool overwrite_allowed(const Options* options, Fault* fault) {
    const Target target_table[] = {
        {"--csv", options->csv, "t,balloon0."},
        {"--mesh", options->mesh, RUN_OBJ_MARK},
        {"--record", options->record, RECORD_MARK},
        {"--out", options->out, NULL}, // overwrite_allows_pictures looks at what is there
    };
    enum { TARGETS = sizeof target_table / sizeof *target_table };
    for (int k = 0; k < TARGETS; k++)
        for (int other = 0; other < k; other++)
            if (is_one_file(target_table[k].path, target_table[other].path))
                return fault_set(fault, target_table[k].option, "%s is written by %s, too",
                                 target_table[k].path, target_table[other].option);
    for (int k = 0; !options->overwrite && k < TARGETS; k++)
        if (target_table[k].mark && !may_write(options, &target_table[k], fault))
            return false;
    return true;
}

bool overwrite_allows_scene(const Options* options, Fault* fault) {
    return options->overwrite ||
           may_write(options, &(Target){"--out", options->out, ADVISE_MARK}, fault);
}

bool overwrite_allows_pictures(const Options* options, const char* out, Fault* fault) {
    struct stat about;
    if (options->overwrite)
        return true;
    if (stat(out, &about) == 0 && S_ISDIR(about.st_mode))
        return frames_may_be_written(options, out, fault);
    return may_write(options, &(Target){"--out", out, VIDEO_MARK}, fault);
}
