/// The figures of a bench: printed, written as a CSV, and compared with the figures kept on this
/// machine by an earlier run, in XDG_CACHE_HOME or ~/.cache.
///
///     case,particles,metric,unit,minimum,median,limit_share
#ifndef BALLOON_LAB_BENCH_FIGURES_H
#define BALLOON_LAB_BENCH_FIGURES_H

#include "base/fault.h"

typedef struct Figure {
    char name[32]; ///< the case
    int particles;
    char metric[32];
    char unit[16];
    double minimum, median;
    double limit_share; ///< share of the machine's limit that was reached [1]; 0: no limit
} Figure;

typedef struct Figures {
    int count, capacity;
    Figure* figure; ///< [count]
    char machine[128];
    char kept_path[512];
    int kept_count;
    Figure* kept; ///< [kept_count] figures of an earlier run
} Figures;

/// Begin without figures, and read those that were kept of this bench.
void figures_open(Figures* figures, const char* bench);

/// Print the machine and the head of the table.
void figures_head(const Figures* figures);

/// Append a figure and print its line, with the ratio to the kept one. minimum, median,
/// limit_share: as in Figure.
void figures_add(Figures* figures, const char* name, int particles, const char* metric,
                 const char* unit, double minimum, double median, double limit_share);

/// Append minimum and median of `count` samples; sorts them.
void figures_add_samples(Figures* figures, const char* name, int particles, const char* metric,
                         const char* unit, double* sample, int count);

/// Whether the figures of a bench may be written to `folder`.
bool figures_may_write(const char* bench, const char* folder, Fault* fault);

/// Write the figures, if there are any, to `folder`; keep them on this machine if `keep` or if none
/// were kept.
bool figures_close(Figures* figures, const char* bench, const char* folder, bool keep,
                   Fault* fault);

#endif
