#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/hash.h"
#include "base/memory.h"
#include "lab/advice/advise.h"
#include "lab/run/machine.h"

enum { NUMBERS_MOST = 1000 };

/// Scenes whose numbers differ by more are others. [1]
static const double alike = 0.2;

/// A scene's words, hashed, and its numbers.
typedef struct Likeness {
    uint64_t words;
    double number[NUMBERS_MOST];
    int count;
} Likeness;

/// text has every scalar in quotes, so that a number is what stands alone between two.
static void likeness_of(const char* text, Likeness* likeness) {
    *likeness = (Likeness){.words = HASH_START};
    for (const char* c = text; *c; c++) {
        char* end;
        const bool digit = *c == '"' && c[1] && strchr("0123456789+-.", c[1]);
        const double number = digit ? strtod(c + 1, &end) : 0;
        if (digit && end > c + 1 && *end == '"' && likeness->count < NUMBERS_MOST) {
            likeness->number[likeness->count++] = number;
            c = end;
        }
        likeness->words = hash_bytes(likeness->words, c, 1);
    }
}

static bool place(const Likeness* likeness, char folder[400], char file[512]) {
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

static bool numbers_fit(const Likeness* likeness, FILE* in) {
    int count;
    if (fscanf(in, "numbers %d", &count) != 1 || count != likeness->count)
        return false;
    for (int k = 0; k < count; k++) {
        double kept;
        if (fscanf(in, "%lf", &kept) != 1 || !(fabs(kept - likeness->number[k]) <=
                                               alike * fmax(fabs(kept), fabs(likeness->number[k]))))
            return false;
    }
    return true;
}

static bool read_points(Advice* advice, FILE* in) {
    int room;
    if (fscanf(in, " floor %lf outputs %d", &advice->floor, &advice->outputs) != 2 ||
        advice->outputs < 1 || advice->outputs > ADVISE_OUTPUTS)
        return false;
    for (int k = 0; k < advice->outputs; k++)
        if (fscanf(in, "%lf", &advice->reference[k]) != 1)
            return false;
    if (fscanf(in, " points %d", &room) != 1 || room < 1)
        return false;
    advice->point = new_array(AdvicePoint, room);
    for (; advice->count < room; advice->count++) {
        AdvicePoint* p = &advice->point[advice->count];
        if (fscanf(in, " %23[^,],%7[^,],%d,%lf,%lf,%lf", p->method, p->precision, &p->level,
                   &p->step, &p->error, &p->ms) != 6)
            return false;
    }
    return true;
}

bool advise_recall(const char* text, Advice* advice) {
    Likeness likeness;
    char folder[400], file[512], machine[256] = "";
    *advice = (Advice){0};
    likeness_of(text, &likeness);
    FILE* in = place(&likeness, folder, file) ? fopen(file, "r") : NULL;
    if (!in)
        return false;
    const bool good = fgets(machine, sizeof machine, in) &&
                      strncmp(machine, machine_name(), strcspn(machine, "\n")) == 0 &&
                      numbers_fit(&likeness, in) && read_points(advice, in);
    fclose(in);
    if (!good)
        advise_free(advice);
    return good;
}

bool advise_keep(const char* text, const Advice* advice, Fault* fault) {
    Likeness likeness;
    char folder[400], file[512];
    likeness_of(text, &likeness);
    if (!place(&likeness, folder, file))
        return true; // nowhere to keep anything: it will be measured again
    FILE* out = make_folders(folder) ? fopen(file, "w") : NULL;
    if (!out)
        return fault_set(fault, file, "the cache cannot be written: %s", strerror(errno));
    fprintf(out, "%s\nnumbers %d", machine_name(), likeness.count);
    for (int k = 0; k < likeness.count; k++)
        fprintf(out, " %.17g", likeness.number[k]);
    fprintf(out, "\nfloor %.17g outputs %d", advice->floor, advice->outputs);
    for (int k = 0; k < advice->outputs; k++)
        fprintf(out, " %.17g", advice->reference[k]);
    fprintf(out, "\npoints %d\n", advice->count);
    for (int k = 0; k < advice->count; k++) {
        const AdvicePoint* p = &advice->point[k];
        fprintf(out, "%s,%s,%d,%.17g,%.17g,%.17g\n", p->method, p->precision, p->level, p->step,
                p->error, p->ms);
    }
    const bool whole = !ferror(out);
    return (fclose(out) == 0 && whole) || fault_set(fault, file, "could not be written to its end");
}
