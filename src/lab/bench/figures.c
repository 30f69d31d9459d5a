#include "lab/bench/figures.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/median.h"
#include "base/real.h"
#include "lab/run/result_file.h"

/// The processor's name with all other characters than letters and digits replaced by dashes.
static void machine_file_name(char name[128]) {
    char line[256];
    snprintf(name, 128, "machine");
    FILE* in = fopen("/proc/cpuinfo", "r");
    while (in && fgets(line, sizeof line, in))
        if (strncmp(line, "model name", 10) == 0 && strchr(line, ':')) {
            snprintf(name, 128, "%s", strchr(line, ':') + 2);
            break;
        }
    if (in)
        fclose(in);
    name[strcspn(name, "\n")] = 0;
    for (char* c = name; *c; c++)
        *c = isalnum((unsigned char)*c) ? *c : '-';
}

static void kept_path(char path[512], const char* bench, const char* machine) {
    const char *cache = getenv("XDG_CACHE_HOME"), *home = getenv("HOME");
    const int length = cache && *cache ? snprintf(path, 512, "%s", cache)
                                       : snprintf(path, 512, "%s/.cache", home ? home : ".");
    if (length < 300)
        snprintf(path + length, 512 - (size_t)length, "/balloon/bench-%s-%s-%s.csv", bench,
                 REAL_NAME, machine);
}

static void read_kept(Figures* figures) {
    char line[512];
    int capacity = 0;
    FILE* in = fopen(figures->kept_path, "r");
    while (in && fgets(line, sizeof line, in)) {
        Figure f = {.particles = 0};
        if (sscanf(line, "%31[^,],%d,%31[^,],%15[^,],%lf,%lf,%lf", f.name, &f.particles, f.metric,
                   f.unit, &f.minimum, &f.median, &f.limit_share) == 7) {
            array_reserve(figures->kept, figures->kept_count, capacity);
            figures->kept[figures->kept_count++] = f;
        }
    }
    if (in)
        fclose(in);
}

void figures_open(Figures* figures, const char* bench) {
    *figures = (Figures){.count = 0};
    machine_file_name(figures->machine);
    kept_path(figures->kept_path, bench, figures->machine);
    read_kept(figures);
}

void figures_head(const Figures* figures) {
    printf("%s, state of %s\n%-18s %9s  %-16s %12s %12s %-10s %9s %9s\n", figures->machine,
           REAL_NAME, "case", "particles", "metric", "minimum", "median", "unit", "of limit",
           "of kept");
}

static double kept_minimum(const Figures* figures, const Figure* figure) {
    for (int k = 0; k < figures->kept_count; k++) {
        const Figure* kept = &figures->kept[k];
        if (strcmp(kept->name, figure->name) == 0 && kept->particles == figure->particles &&
            strcmp(kept->metric, figure->metric) == 0)
            return kept->minimum;
    }
    return 0;
}

void figures_add(Figures* figures, const char* name, int particles, const char* metric,
                 const char* unit, double minimum, double median, double limit_share) {
    Figure one = {
        .particles = particles, .minimum = minimum, .median = median, .limit_share = limit_share};
    snprintf(one.name, sizeof one.name, "%s", name);
    snprintf(one.metric, sizeof one.metric, "%s", metric);
    snprintf(one.unit, sizeof one.unit, "%s", unit);
    array_reserve(figures->figure, figures->count, figures->capacity);
    figures->figure[figures->count++] = one;
    const double kept = kept_minimum(figures, &one);
    printf("%-18s %9d  %-16s %12.4g %12.4g %-10s", one.name, one.particles, one.metric, one.minimum,
           one.median, one.unit);
    if (one.limit_share > 0)
        printf(" %8.1f%%", 100 * one.limit_share);
    else
        printf(" %9s", "");
    if (kept > 0)
        printf(" %9.3f", one.minimum / kept);
    printf("\n");
    fflush(stdout);
}

void figures_add_samples(Figures* figures, const char* name, int particles, const char* metric,
                         const char* unit, double* sample, int count) {
    const double middle = median(sample, count);
    figures_add(figures, name, particles, metric, unit, sample[0], middle, 0);
}

static void csv_name(char name[64], const char* bench) {
    snprintf(name, 64, "bench-%s.csv", bench);
}

static const char head[] = "case,particles,metric,unit,minimum,median,limit_share\n";

bool figures_may_write(const char* bench, const char* folder, Fault* fault) {
    char name[64];
    csv_name(name, bench);
    return result_file_allowed(folder, name, head, fault);
}

static bool write_csv(const Figures* figures, const char* folder, const char* name, Fault* fault) {
    FILE* out = result_folder(folder, fault) ? result_file_open(folder, name, head, fault) : NULL;
    if (!out)
        return false;
    fputs(head, out);
    for (int k = 0; k < figures->count; k++) {
        const Figure* f = &figures->figure[k];
        fprintf(out, "%s,%d,%s,%s,%.6g,%.6g,%.4g\n", f->name, f->particles, f->metric, f->unit,
                f->minimum, f->median, f->limit_share);
    }
    return result_file_close(out, folder, name, fault);
}

bool figures_close(Figures* figures, const char* bench, const char* folder, bool keep,
                   Fault* fault) {
    char name[64];
    csv_name(name, bench);
    bool good = figures->count == 0 || write_csv(figures, folder, name, fault);
    if (good && figures->count > 0 && (keep || figures->kept_count == 0)) {
        char kept_folder[512];
        snprintf(kept_folder, sizeof kept_folder, "%s", figures->kept_path);
        char* slash = strrchr(kept_folder, '/');
        *slash = '\0';
        good = write_csv(figures, kept_folder, slash + 1, fault);
        if (good)
            printf("kept in %s\n", figures->kept_path);
    }
    free(figures->figure);
    free(figures->kept);
    return good;
}
