/// What a run printed: its CSV, and the line of `--report`.
#ifndef BALLOON_LAB_RUN_REPORT_H
#define BALLOON_LAB_RUN_REPORT_H

#include "lab/run/launch.h"

typedef struct Report {
    int rows, columns;
    char** name;   ///< [columns]
    double* value; ///< [rows][columns]
    double ms;     ///< CPU time of stepping per simulated second, up to where it came [ms]; NAN
    int parts;     ///< largest number of substeps into which the guard divided a step
    char hash[24]; ///< of the state at the end, "" where there was no end
    bool ended;    ///< it came to its end: no blow-up, no crash
    int outputs;
    double* output; ///< [outputs] of the scene's list `about`
    char* text;     ///< what the names are in
} Report;

/// Read what a launch printed; a launch that printed no CSV has no rows.
void report_read(Report* report, const Launch* launch);

/// A column's value in a row; rows from -1 backwards are counted from the last. NAN where there is
/// none.
double report_at(const Report* report, const char* column, int row);

/// The same in the row whose time is nearest to t.
double report_at_time(const Report* report, const char* column, double t);

/// Value of output k of the scene's list `about`; NAN where the run did not reach its time.
double report_output(const Report* report, unsigned k);

void report_free(Report* report);

#endif
