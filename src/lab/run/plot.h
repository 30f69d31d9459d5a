/// A chart by gnuplot, through a pipe.
///
/// The script stays beside its data as NAME.gp, so that anyone can draw the chart again with
/// `gnuplot NAME.gp` in that folder; what it draws are NAME.svg and NAME.png. Whoever opens a plot
/// prints to `script` what gnuplot is to do, from `set` to `plot`: it is done once for each
/// picture, with comma-separated data files and a key line in each.
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

/// Make a folder for results where there is none yet.
bool plot_folder(const char* folder, Fault* fault);

/// Begin the script FOLDER/NAME.gp of a picture of that size [pixels].
bool plot_open(Plot* plot, const char* folder, const char* name, int width, int height,
               Fault* fault);

/// End the script and draw it. A script that cannot be written and a gnuplot that is missing or
/// does not take the script are faults.
bool plot_close(Plot* plot, Fault* fault);

#endif
