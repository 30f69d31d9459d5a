/// What a bench found, figure by figure: printed, written as a CSV, and compared with the figures
/// that were kept on this machine, in XDG_CACHE_HOME or ~/.cache.
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
    double limit_share; ///< part of the machine's limit that was reached [1]; 0: it has none
} Figure;

typedef struct Figures {
    int count, room;
    Figure* figure;
    char machine[128];
    char kept_path[512];
    int kept_count;
    Figure* kept; ///< what was kept earlier
} Figures;

/// None yet, and what was kept of this bench.
void figures_open(Figures* figures, const char* bench);

/// Print the machine and the head of the table.
void figures_head(const Figures* figures);

/// One more, and its line with the ratio to the kept one. minimum, median, limit_share: Figure's.
void figures_add(Figures* figures, const char* name, int particles, const char* metric,
                 const char* unit, double minimum, double median, double limit_share);

/// The least and the median of some samples, which it sorts.
void figures_add_samples(Figures* figures, const char* name, int particles, const char* metric,
                         const char* unit, double* sample, int count);

/// Where there are any, write them to `folder`, and where none were kept or `keep` is said keep
/// them.
bool figures_close(Figures* figures, const char* bench, const char* folder, bool keep,
                   Fault* fault);

#endif
