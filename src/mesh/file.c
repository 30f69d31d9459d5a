#include "mesh/file.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

#include "base/input_file.h"
#include "base/memory.h"

static bool read_open(FileText* file, FILE* in, const char* path, size_t size_max, Fault* fault) {
    struct stat status;
    if (fstat(fileno(in), &status) != 0)
        return fault_set(fault, path, "cannot be read: %s", strerror(errno));
    if (status.st_size == 0)
        return fault_set(fault, path, "is empty");
    if ((size_t)status.st_size > size_max)
        return fault_set(fault, path, "has %lld bytes; at most %zu can be read",
                         (long long)status.st_size, size_max);

    const size_t size = (size_t)status.st_size;
    file->text = new_array(char, size + 1);
    file->size = fread(file->text, 1, size, in);
    if (file->size != size)
        return fault_set(fault, path, "cannot be read: %s",
                         ferror(in) ? strerror(errno) : "it became shorter");
    return true;
}

/// Windows ends lines with \r\n, old Macs with \r alone; some editors begin with a byte order mark.
static void make_plain(FileText* file) {
    static const char mark[] = "\xEF\xBB\xBF";
    if (strncmp(file->text, mark, strlen(mark)) == 0)
        memset(file->text, ' ', strlen(mark));
    const char* end = file->text + file->size;
    for (char* r = memchr(file->text, '\r', file->size); r; r = memchr(r, '\r', (size_t)(end - r)))
        *r = r[1] == '\n' ? ' ' : '\n';
}

bool file_read_bytes(FileText* file, const char* path, size_t size_max, Fault* fault) {
    *file = (FileText){0};
    FILE* in = input_file_open(path, fault);
    if (!in)
        return false;
    const bool good = read_open(file, in, path, size_max, fault);
    fclose(in);
    if (!good)
        file_free(file);
    return good;
}

bool file_read(FileText* file, const char* path, size_t size_max, Fault* fault) {
    if (!file_read_bytes(file, path, size_max, fault))
        return false;
    if (memchr(file->text, 0, file->size)) {
        file_free(file);
        return fault_set(fault, path, "is a binary file, not text");
    }
    make_plain(file);
    return true;
}

void file_free(FileText* file) {
    free(file->text);
    *file = (FileText){0};
}
