#include "lab/run/report_line.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

static const char name[] = "report ";

void report_line_print(const ReportLine* line, FILE* out) {
    fprintf(out, "%sended=%d steps=%ld seconds=%.17g cpu_ms_per_second=%.9g substeps=%d hash=%s",
            name, line->ended, line->steps, line->seconds, line->cpu_ms, line->substeps,
            line->hash);
    for (int k = 0; k < line->outputs; k++)
        fprintf(out, " output=%.17g", line->output[k]);
    fputc('\n', out);
}

static void read_value(ReportLine* line, const char* key, size_t length, const char* value) {
#define IS(word) (length == sizeof(word) - 1 && strncmp(key, word, length) == 0)
    if (IS("ended"))
        line->ended = atoi(value) != 0;
    else if (IS("steps"))
        line->steps = atol(value);
    else if (IS("seconds"))
        line->seconds = strtod(value, NULL);
    else if (IS("cpu_ms_per_second"))
        line->cpu_ms = strtod(value, NULL);
    else if (IS("substeps"))
        line->substeps = atoi(value);
    else if (IS("hash"))
        snprintf(line->hash, sizeof line->hash, "%.*s", (int)strcspn(value, " "), value);
    else if (IS("output") && line->outputs < REPORT_LINE_OUTPUTS)
        line->output[line->outputs++] = strtod(value, NULL);
#undef IS
}

bool report_line_read(const char* text, ReportLine* line) {
    if (strncmp(text, name, sizeof name - 1) != 0)
        return false;
    *line = (ReportLine){.cpu_ms = (double)NAN, .output = new_array(double, REPORT_LINE_OUTPUTS)};
    const char* key = text + sizeof name - 1;
    while (*key) {
        const size_t length = strcspn(key, "= ");
        if (key[length] == '=')
            read_value(line, key, length, key + length + 1);
        key += strcspn(key, " ");
        key += strspn(key, " ");
    }
    return true;
}
