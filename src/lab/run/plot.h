/// A chart drawn by gnuplot.
///
/// The script stays beside its data as NAME.gp, so that `gnuplot NAME.gp` in that folder draws
/// NAME.svg and NAME.png again. The caller prints commands to `script`, from `set` to `plot`;
/// gnuplot executes them once for each picture. Data files are comma-separated, with a header line.
///
///     Plot plot;
///     if (!plot_open(&plot, "out", "chart", 960, 720, fault))
///         return false;
///     fprintf(plot.script, "plot 'chart.csv' using 1:2 with lines\n");
///     return plot_close(&plot, fault);
#ifndef BALLOON_LAB_RUN_PLOT_H
#define BALLOON_LAB_RUN_PLOT_H

#include "base/fault.h"

typedef struct Plot {
    FILE* script;
    char folder[300];
    char name[64];
    char file[400]; ///< of the script
} Plot;

/// Begin the script FOLDER/NAME.gp of a picture of that size [pixels].
bool plot_open(Plot* plot, const char* folder, const char* name, int width, int height,
               Fault* fault);

/// End the script and draw it. It is a fault if the script cannot be written, or if gnuplot is
/// missing or fails.
bool plot_close(Plot* plot, Fault* fault);

#endif
