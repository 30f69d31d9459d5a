#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/hash.h"
#include "base/input_file.h"
#include "base/memory.h"
#include "base/paths.h"
#include "lab/advice/advise.h"
#include "lab/run/machine.h"

enum { MAX_NUMBERS = 1000, MAX_POINTS = 10000, MAX_FILE_BYTES = 1 << 21 };

/// Maximum relative difference of two numbers for the advice of one scene to be valid for the
/// other. [1]
static const double number_tolerance = 0.2;

/// What is compared of a scene: a hash of its text without the numbers, and the numbers.
typedef struct Likeness {
    uint64_t words;
    double number[MAX_NUMBERS];
    int count;
} Likeness;

/// text: has every scalar in quotes, so that a number is a quoted text of digits alone.
static void likeness_of(const char* text, Likeness* likeness) {
    *likeness = (Likeness){.words = HASH_START};
    for (const char* c = text; *c; c++) {
        char* end;
        const bool digit = *c == '"' && c[1] && strchr("0123456789+-.", c[1]);
        const double number = digit ? strtod(c + 1, &end) : 0;
        if (digit && end > c + 1 && *end == '"' && likeness->count < MAX_NUMBERS) {
            likeness->number[likeness->count++] = number;
            c = end;
        }
        likeness->words = hash_bytes(likeness->words, c, 1);
    }
}

static bool find_file(const Likeness* likeness, char folder[400], char file[512]) {
    const char* cache = getenv("XDG_CACHE_HOME");
    const char* home = getenv("HOME");
    if (cache && cache[0])
        snprintf(folder, 400, "%s/balloon", cache);
    else if (home && home[0])
        snprintf(folder, 400, "%s/.cache/balloon", home);
    else
        return false;
    snprintf(file, 512, "%s/advice-%016llx.csv", folder, (unsigned long long)likeness->words);
    return true;
}

static bool make_folders(const char* folder) {
    char part[400];
    for (const char* slash = strchr(folder + 1, '/');; slash = strchr(slash + 1, '/')) {
        snprintf(part, sizeof part, "%.*s", slash ? (int)(slash - folder) : 399, folder);
        if (mkdir(part, 0777) != 0 && errno != EEXIST)
            return false;
        if (!slash)
            return true;
    }
}

/// The first line: the machine, and size and time of the measured program, which change with each
/// build.
static void write_title(char* line, size_t size) {
    char program[512];
    struct stat status = {0};
    Fault unused = {0};
    if (paths_sibling("balloon", program, &unused))
        stat(program, &status);
    snprintf(line, size, "%s, program of %lld bytes, %lld", machine_name(),
             (long long)status.st_size, (long long)status.st_mtime);
}

static bool title_fits(FILE* in) {
    char line[512], cached[512];
    write_title(line, sizeof line);
    if (!fgets(cached, sizeof cached, in))
        return false;
    cached[strcspn(cached, "\n")] = '\0';
    return strcmp(cached, line) == 0;
}

static bool numbers_fit(const Likeness* likeness, FILE* in) {
    int count;
    if (fscanf(in, "numbers %d", &count) != 1 || count != likeness->count)
        return false;
    for (int k = 0; k < count; k++) {
        double cached;
        if (fscanf(in, "%lf", &cached) != 1 ||
            !(fabs(cached - likeness->number[k]) <=
              number_tolerance * fmax(fabs(cached), fabs(likeness->number[k]))))
            return false;
    }
    return true;
}

static bool read_reference(Advice* advice, int outputs, FILE* in) {
    if (fscanf(in, " floor %lf outputs %d", &advice->floor, &advice->outputs) != 2 ||
        advice->outputs != outputs || !(advice->floor >= 0 && isfinite(advice->floor)))
        return false;
    for (int k = 0; k < outputs; k++)
        if (fscanf(in, "%lf", &advice->reference[k]) != 1 || !isfinite(advice->reference[k]) ||
            advice->reference[k] == 0)
            return false;
    return true;
}

/// Whether the values can be results of a measurement. Every comparison with NAN is false.
static bool is_possible(const AdvicePoint* p) {
    return method_find(p->method) &&
           (strcmp(p->precision, "float") == 0 || strcmp(p->precision, "double") == 0) &&
           abs(p->refinement) < 10 && p->step > 0 && p->step <= 1 && p->error >= 0 && p->ms >= 0;
}

static bool read_points(Advice* advice, FILE* in) {
    int count;
    if (fscanf(in, " points %d", &count) != 1 || count < 1 || count > MAX_POINTS)
        return false;
    advice->point = new_array(AdvicePoint, count);
    for (; advice->count < count; advice->count++) {
        AdvicePoint* p = &advice->point[advice->count];
        if (fscanf(in, " %23[^,],%7[^,],%d,%lf,%lf,%lf", p->method, p->precision, &p->refinement,
                   &p->step, &p->error, &p->ms) != 6 ||
            !is_possible(p))
            return false;
    }
    return true;
}

static const char hash_line[] = "hash ";

/// Cut off the last line, which must hold the hash of the text before it. False if it does not.
static bool check_hash(char* text, size_t size) {
    size_t at = size;
    while (at > 0 && !(text[at - 1] == '\n' && at < size))
        at--;
    const uint64_t hash = hash_bytes(HASH_START, text, at);
    char line[40];
    snprintf(line, sizeof line, "%s%016llx\n", hash_line, (unsigned long long)hash);
    const bool good = at > 0 && strcmp(text + at, line) == 0;
    text[at] = '\0';
    return good;
}

/// The file's text without its hash; NULL if the file is missing or its hash is wrong.
static char* read_file(const char* file) {
    Fault unused = {0};
    FILE* in = input_file_open(file, &unused);
    if (!in)
        return NULL;
    char* text = new_array(char, MAX_FILE_BYTES + 1);
    const size_t size = fread(text, 1, MAX_FILE_BYTES, in);
    fclose(in);
    if (check_hash(text, size))
        return text;
    free(text);
    return NULL;
}

bool advise_cache_read(const char* scene, int outputs, Advice* advice) {
    Likeness likeness;
    char folder[400], file[512];
    *advice = (Advice){0};
    likeness_of(scene, &likeness);
    char* text = find_file(&likeness, folder, file) ? read_file(file) : NULL;
    FILE* in = text && text[0] ? fmemopen(text, strlen(text), "r") : NULL;
    const bool good = in && title_fits(in) && numbers_fit(&likeness, in) &&
                      read_reference(advice, outputs, in) && read_points(advice, in);
    if (in)
        fclose(in);
    free(text);
    if (!good)
        advise_free(advice);
    return good;
}

static char* text_of(const Likeness* likeness, const Advice* advice) {
    char *text = NULL, title[512];
    size_t size = 0;
    FILE* out = open_memstream(&text, &size);
    write_title(title, sizeof title);
    fprintf(out, "%s\nnumbers %d", title, likeness->count);
    for (int k = 0; k < likeness->count; k++)
        fprintf(out, " %.17g", likeness->number[k]);
    fprintf(out, "\nfloor %.17g outputs %d", advice->floor, advice->outputs);
    for (int k = 0; k < advice->outputs; k++)
        fprintf(out, " %.17g", advice->reference[k]);
    fprintf(out, "\npoints %d\n", advice->count);
    for (int k = 0; k < advice->count; k++) {
        const AdvicePoint* p = &advice->point[k];
        fprintf(out, "%s,%s,%d,%.17g,%.17g,%.17g\n", p->method, p->precision, p->refinement,
                p->step, p->error, p->ms);
    }
    fflush(out);
    const uint64_t hash = hash_bytes(HASH_START, text, size);
    fprintf(out, "%s%016llx\n", hash_line, (unsigned long long)hash);
    fclose(out);
    return text;
}

/// Write a temporary file beside the file, then rename it, so that other processes never read a
/// part.
static bool replace_file(const char* file, const char* text) {
    char beside[540];
    snprintf(beside, sizeof beside, "%s.%ld", file, (long)getpid());
    FILE* out = fopen(beside, "w");
    if (!out)
        return false;
    fputs(text, out);
    const bool complete = !ferror(out);
    if (fclose(out) == 0 && complete && rename(beside, file) == 0)
        return true;
    const int reason = errno;
    unlink(beside);
    errno = reason;
    return false;
}

void advise_cache_write(const char* scene, const Advice* advice) {
    Likeness likeness;
    char folder[400], file[512];
    likeness_of(scene, &likeness);
    if (!find_file(&likeness, folder, file))
        return;
    char* text = text_of(&likeness, advice);
    if (!make_folders(folder) || !replace_file(file, text))
        fprintf(stderr, "balloon: %s: not kept, and measured again next time: %s\n", file,
                strerror(errno));
    free(text);
}
