#include "lab/run/report.h"

#include <math.h>
#include <string.h>
#include <sys/wait.h>

#include "base/memory.h"
#include "lab/run/report_line.h"

static int count_of(const char* text, char c) {
    int count = 0;
    for (; *text; text++)
        count += *text == c;
    return count;
}

/// The next line of a text, terminated in place; NULL after the last.
static char* next_line(char** text) {
    char* line = *text;
    if (!*line)
        return NULL;
    char* end = strchr(line, '\n');
    *text = end ? end + 1 : line + strlen(line);
    if (end)
        *end = '\0';
    return line;
}

static void read_names(Report* report, char* line) {
    report->columns = count_of(line, ',') + 1;
    report->name = new_array(char*, report->columns);
    for (int c = 0; c < report->columns; c++) {
        report->name[c] = line;
        line += strcspn(line, ",");
        if (*line)
            *line++ = '\0';
    }
}

/// Read a row of the CSV; false for a line that is no row.
static bool read_row(const Report* report, const char* line, double* value) {
    for (int c = 0; c < report->columns; c++) {
        char* end;
        value[c] = strtod(line, &end);
        if (end == line || *end != (c + 1 < report->columns ? ',' : '\0'))
            return false;
        line = end + 1;
    }
    return true;
}

static void read_result(Report* report, const char* text) {
    ReportLine line;
    if (!report_line_read(text, &line))
        return;
    free(report->output);
    report->output = line.output;
    report->outputs = line.outputs;
    report->ms = line.cpu_ms;
    report->substeps = line.substeps;
    if (line.ended)
        snprintf(report->hash, sizeof report->hash, "%s", line.hash);
}

void report_read(Report* report, const Launch* launch) {
    *report = (Report){
        .ms = (double)NAN, .substeps = 1, .text = new_array(char, strlen(launch->out) + 1)};
    strcpy(report->text, launch->out);
    report->ended = WIFEXITED(launch->status) && WEXITSTATUS(launch->status) == 0;
    const int lines = count_of(report->text, '\n');
    char *text = report->text, *line;
    while ((line = next_line(&text))) {
        if (!report->name && strncmp(line, "t,", 2) == 0) {
            read_names(report, line);
            report->value = new_array(double, lines * report->columns);
        } else if (report->name &&
                   read_row(report, line, report->value + report->rows * report->columns)) {
            report->rows++;
        } else {
            read_result(report, line);
        }
    }
}

static int column_of(const Report* report, const char* name) {
    for (int c = 0; c < report->columns; c++)
        if (strcmp(report->name[c], name) == 0)
            return c;
    return -1;
}

double report_at(const Report* report, const char* column, int row) {
    const int c = column_of(report, column);
    if (row < 0)
        row += report->rows;
    return c >= 0 && row >= 0 && row < report->rows ? report->value[row * report->columns + c]
                                                    : (double)NAN;
}

double report_at_time(const Report* report, const char* column, double t) {
    int nearest = 0;
    for (int r = 1; r < report->rows; r++)
        if (fabs(report_at(report, "t", r) - t) < fabs(report_at(report, "t", nearest) - t))
            nearest = r;
    return report_at(report, column, nearest);
}

double report_output(const Report* report, unsigned k) {
    return k < (unsigned)report->outputs ? report->output[k] : (double)NAN;
}

void report_free(Report* report) {
    free(report->name);
    free(report->value);
    free(report->output);
    free(report->text);
    *report = (Report){0};
}
