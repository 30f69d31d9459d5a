/// The last line of `balloon run --report` and `balloon peer --report`: "report", then KEY=VALUE
/// for each figure, separated by spaces. Programs read this line and no other text.
#ifndef BALLOON_LAB_RUN_REPORT_LINE_H
#define BALLOON_LAB_RUN_REPORT_LINE_H

#include "base/fault.h"

typedef struct ReportLine {
    bool ended;     ///< the run reached its end; false: a blowup
    long steps;     ///< steps made
    double seconds; ///< simulated time of the steps [s]
    double cpu_ms;  ///< CPU time of stepping per simulated second [ms]
    int substeps;   ///< largest number into which the guard divided a step
    char hash[24];  ///< of the last state, 16 hexadecimal digits
    int outputs;    ///< number of outputs in the scene's list `about`
    double* output; ///< [outputs] values at their times; NAN: not reached
} ReportLine;

enum { REPORT_LINE_OUTPUTS = 64 }; ///< maximum number of outputs that are read

void report_line_print(const ReportLine* line, FILE* out);

/// Read a line; false if the text is not a report. The caller frees the outputs.
bool report_line_read(const char* text, ReportLine* line);

#endif
