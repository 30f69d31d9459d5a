#include "lab/run/bounded_run.h"

#include <math.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>

enum {
    SIGNALED = 128
}; ///< plus the signal: exit status of a program ended by a signal, as in shells

/// Suffices for every shipped scene by every method. A run that needs more must end with a
/// sentence.
static const unsigned long bytes_max = 2ul << 30;

const char* const ending_name[ENDINGS] = {
    [ENDING_GOOD] = "good", [ENDING_STOPPED] = "stopped", [ENDING_REFUSED] = "refused",
    [ENDING_LONG] = "long", [ENDING_WRONG] = "WRONG",
};

void bounded_run(Launch* launch, const char* program, const char* scene, double seconds, int rows,
                 double cpu) {
    *launch = (Launch){.cpu_ask = cpu, .cpu_max = 2 * cpu, .bytes = bytes_max};
    launch_add(launch, "%s", program);
    launch_add(launch, "run");
    launch_add(launch, "%s", scene);
    launch_add(launch, "--quiet");
    launch_add(launch, "--report");
    launch_add(launch, "--csv=-");
    launch_add(launch, "--seconds=%.17g", seconds);
    launch_add(launch, "--fps=%.17g", rows / seconds);
}

/// The last line on standard error if it begins with "balloon: ", else "".
static void last_sentence(const char* err, char text[ENDING_TEXT]) {
    static const char start[] = "balloon: ";
    const char* last = NULL;
    for (const char* line = err; line; line = strchr(line, '\n')) {
        line += *line == '\n';
        if (strncmp(line, start, sizeof start - 1) == 0)
            last = line + sizeof start - 1;
    }
    snprintf(text, ENDING_TEXT, "%.*s", last ? (int)strcspn(last, "\n") : 0, last ? last : "");
}

/// Name of the first number of a report that is not finite; NULL: all are finite.
static const char* not_finite(const Report* report) {
    for (int r = 0; r < report->rows; r++)
        for (int c = 0; c < report->columns; c++)
            if (!isfinite(report->value[r * report->columns + c]))
                return report->name[c];
    return NULL;
}

static Ending wrong_signal(const Launch* launch, char text[ENDING_TEXT]) {
    const int number = WTERMSIG(launch->status);
    snprintf(text, ENDING_TEXT, number == SIGKILL ? "no answer in %g s of CPU time" : "signal %g",
             number == SIGKILL ? launch->cpu_max : number);
    return ENDING_WRONG;
}

Ending bounded_run_ending(const Launch* launch, const Report* report, char text[ENDING_TEXT]) {
    if (!WIFEXITED(launch->status))
        return wrong_signal(launch, text);
    const int status = WEXITSTATUS(launch->status);
    if (status == EXIT_SUCCESS) {
        const char* column = not_finite(report);
        snprintf(text, ENDING_TEXT, "%s%s", column ? column : "", column ? " is not finite" : "");
        return column || report->rows < 2 ? ENDING_WRONG : ENDING_GOOD;
    }
    last_sentence(launch->err, text);
    if (!text[0]) {
        snprintf(text, ENDING_TEXT, "exit status %d without a sentence", status);
        return ENDING_WRONG;
    }
    if (status == SIGNALED + SIGTERM && launch->end_requested)
        return ENDING_LONG;
    return isfinite(report->ms) || report->rows > 0 ? ENDING_STOPPED : ENDING_REFUSED;
}

void bounded_run_print(const Launch* launch, FILE* out) {
    fputs("balloon", out);
    for (int k = 1; k < launch->words; k++) {
        const bool quoted = strpbrk(launch->word[k], " []{}~*") != NULL;
        fprintf(out, quoted ? " '%s'" : " %s", launch->word[k]);
    }
}
