/// The line that `balloon run --report` and `balloon peer --report` print last: "report", then
/// KEY=VALUE for each figure, one space before each. Programs read this line and no other words.
#ifndef BALLOON_LAB_RUN_REPORT_LINE_H
#define BALLOON_LAB_RUN_REPORT_LINE_H

#include "base/fault.h"

typedef struct ReportLine {
    bool ended;     ///< the run came to its end; false: its state went bad
    long steps;     ///< steps made
    double seconds; ///< simulated time of the steps [s]
    double cpu_ms;  ///< CPU time of stepping per simulated second [ms]
    int substeps;   ///< largest number into which the guard divided a step
    char hash[24];  ///< of the last state, 16 hexadecimal digits
    int outputs;    ///< of the scene's list `about`
    double* output; ///< [outputs] values at their times, NAN where the run did not reach one
} ReportLine;

enum { REPORT_LINE_OUTPUTS = 64 }; ///< largest number that a line is read with

void report_line_print(const ReportLine* line, FILE* out);

/// False where the text is not such a line. The outputs are new and the caller's.
bool report_line_read(const char* text, ReportLine* line);

#endif
