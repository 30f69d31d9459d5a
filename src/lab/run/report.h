/// The results of a run: its CSV and the line that `--report` prints.
#ifndef BALLOON_LAB_RUN_REPORT_H
#define BALLOON_LAB_RUN_REPORT_H

#include "lab/run/launch.h"

typedef struct Report {
    int rows, columns;
    char** name;   ///< [columns]
    double* value; ///< [rows][columns]
    double ms;     ///< CPU time of stepping per simulated second [ms]; NAN: unknown
    int substeps;  ///< largest number of substeps into which the guard divided a step
    char hash[24]; ///< of the state at the end; "": the run did not reach it
    bool ended;    ///< the run reached its end: no blowup, no crash
    int outputs;
    double* output; ///< [outputs] of the scene's list `about`
    char* text;     ///< holds the names
} Report;

/// Read the output of a launch; without a CSV there are no rows.
void report_read(Report* report, const Launch* launch);

/// The value of a column in a row; negative rows count from the end, -1 is the last. NAN: none.
double report_at(const Report* report, const char* column, int row);

/// The same in the row whose time is nearest to t.
double report_at_time(const Report* report, const char* column, double t);

/// Value of output k of the scene's list `about`; NAN if the run did not reach its time.
double report_output(const Report* report, unsigned k);

void report_free(Report* report);

#endif
