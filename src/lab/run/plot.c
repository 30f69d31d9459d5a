#include "lab/run/plot.h"

#include <errno.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "lab/run/result_file.h"

enum { SHELL_FINDS_NONE = 127 }; ///< exit status where a command does not exist

/// Whether the pictures may be written if their script is not one of the program's.
static bool may_draw(const char* folder, const char* name, Fault* fault) {
    static const char* const picture_table[] = {"svg", "png"};
    for (size_t k = 0; k < sizeof picture_table / sizeof *picture_table; k++) {
        char picture[80];
        snprintf(picture, sizeof picture, "%s.%s", name, picture_table[k]);
        if (!result_file_allowed(folder, picture, "", fault))
            return false;
    }
    return true;
}

bool plot_open(Plot* plot, const char* folder, const char* name, int width, int height,
               Fault* fault) {
    *plot = (Plot){0};
    snprintf(plot->folder, sizeof plot->folder, "%s", folder);
    snprintf(plot->name, sizeof plot->name, "%s", name);
    snprintf(plot->file, sizeof plot->file, "%s/%s.gp", folder, name);
    char script[80], mark[96];
    snprintf(script, sizeof script, "%s.gp", name);
    snprintf(mark, sizeof mark, "# gnuplot %s\n", script);
    if (access(plot->file, F_OK) != 0 && !may_draw(folder, name, fault))
        return false;
    plot->script = result_file_open(folder, script, mark, fault);
    if (!plot->script)
        return false;

    // a loop, because gnuplot cannot write two formats at once
    fprintf(plot->script,
            "%s"
            "set datafile separator ','\n"
            "do for [picture in 'svg png'] {\n"
            "if (picture eq 'svg') {\n"
            "set terminal svg size %d,%d dynamic font 'sans,14' background 'white'\n"
            "} else {\n"
            "set terminal pngcairo size %d,%d font 'sans,11'\n"
            "}\n"
            "set output '%s.'.picture\n",
            mark, width, height, width, height, name);
    return true;
}

/// Commands that change to the folder and load the script; quotes in names are doubled.
static void load(const Plot* plot, FILE* gnuplot) {
    fprintf(gnuplot, "cd '");
    for (const char* c = plot->folder; *c; c++)
        fprintf(gnuplot, *c == '\'' ? "''" : "%c", *c);
    fprintf(gnuplot, "'\nload '%s.gp'\n", plot->name);
}

bool plot_close(Plot* plot, Fault* fault) {
    fprintf(plot->script, "unset output\n}\n");
    const bool whole = !ferror(plot->script);
    if (fclose(plot->script) != 0 || !whole)
        return fault_set(fault, plot->file, "cannot be written: %s", strerror(errno));

    // if gnuplot ends early, writing must return an error rather than raise a signal
    signal(SIGPIPE, SIG_IGN);
    FILE* gnuplot = popen("command -v gnuplot >/dev/null || exit 127; exec gnuplot -", "w");
    if (!gnuplot)
        return fault_set(fault, plot->file, "no pipe to gnuplot: %s", strerror(errno));
    load(plot, gnuplot);
    const int status = pclose(gnuplot);
    if (WIFEXITED(status) && WEXITSTATUS(status) == SHELL_FINDS_NONE)
        return fault_set(
            fault, plot->file,
            "charts need gnuplot (apt-get install gnuplot-nox); the numbers are there");
    if (status != 0)
        return fault_set(fault, plot->file, "gnuplot does not draw this");
    return true;
}
