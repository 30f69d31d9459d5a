#include <math.h>
#include <string.h>

#include "body/springs.h"
#include "lab/chart/chart.h"
#include "lab/run/machine.h"
#include "lab/run/plot.h"
#include "mesh/mesh.h"
#include "solve/method.h"

static const double real_time = 1000; ///< [ms of CPU time per simulated second]

/// Range of the error axis: a run with a larger error counts as failed. [1]
static const double error_max = 10, error_min = 1e-2;

/// Distance of failed runs below the upper edge of the picture, as a ratio. [1]
static const double edge = 1.15;

/// Okabe and Ito's colors, distinguishable for all kinds of color vision: the peer's, then the
/// methods'.
static const char* const color_table[] = {"#d55e00", "#0072b2", "#009e73", "#cc79a7",
                                          "#e69f00", "#56b4e9", "#000000"};
enum { COLORS = sizeof color_table / sizeof *color_table };

static const char* color_of(const char* method) {
    for (int k = 0; k < method_count; k++)
        if (strcmp(method_table[k]->name, method) == 0)
            return color_table[1 + k % (COLORS - 1)];
    return color_table[0];
}

/// gnuplot's point types: a filled circle for membranes, another shape for each law of springs, a
/// triangle for the peer; hollow for float.
static int shape_of(const ChartPoint* point, bool hollow) {
    static const int springs[SPRING_LAWS] = {5, 13, 11}; // square, diamond, triangle upside down
    int shape = chart_is_peer(point) ? 9 : 7;
    for (int law = 0; law < SPRING_LAWS; law++)
        if (strcmp(point->skin, "springs") == 0 && strcmp(point->law, spring_law_name[law]) == 0)
            shape = springs[law];
    return shape - hollow;
}

static bool is_drawn(const ChartPlan* plan, int from, int p) {
    if (plan->point[p].launch == NONE)
        return false;
    for (int q = from; q < p; q++)
        if (chart_same_line(&plan->point[q], &plan->point[p]))
            return false;
    return true;
}

static void error_range(const ChartPlan* plan, int from, int to, double* low, double* high) {
    *low = error_min, *high = 10 * error_min;
    if (plan->point[from].floor > 0)
        *low = fmin(*low, plan->point[from].floor);
    for (int p = from; p < to; p++) {
        const double error = plan->point[p].error;
        if (plan->point[p].launch == NONE || !(error > 0) || !isfinite(error))
            continue;
        *low = fmin(*low, error);
        *high = fmax(*high, fmin(error, error_max));
    }
    *low = pow(10, floor(log10(*low)));
    *high = pow(10, ceil(log10(*high)));
}

/// Whether a line has stable points in this precision; precision NULL: whether it has failed
/// points.
static bool has_points(const ChartPlan* plan, int from, int p, const char* precision, double top) {
    for (int q = from; q < chart_end(plan, from); q++) {
        const ChartPoint* point = &plan->point[q];
        const bool failed = !point->stable || !(point->error <= top);
        if (point->launch != NONE && chart_same_line(point, &plan->point[p]) &&
            (precision ? !failed && strcmp(point->precision, precision) == 0 : failed))
            return true;
    }
    return false;
}

/// The points of a line in both precisions, its failed points, and its Pareto front.
static void plot_line(const ChartPlan* plan, int from, int p, double top, FILE* script) {
    char key[160], title[96];
    const ChartPoint* point = &plan->point[p];
    const char* color = color_of(point->method);
    snprintf(key, sizeof key, "'%s','%s','%s','%s'", point->name, point->method, point->skin,
             point->law);
    if (chart_is_peer(point))
        snprintf(title, sizeof title, "Bullet soft body");
    else
        snprintf(title, sizeof title, "%s, %s%s", point->method, point->law,
                 strcmp(point->skin, "springs") == 0 ? " springs" : "");
    const bool in_double = has_points(plan, from, p, "double", top);
    const bool in_float = has_points(plan, from, p, "float", top);
    if (in_double || in_float)
        fprintf(script,
                "    'front.csv' using (is(%s) ? $5 : NaN):6 with lines lw 2 lc '%s' notitle, \\\n",
                key, color);
    for (int is_float = 0; is_float < 2; is_float++)
        if (is_float ? in_float : in_double)
            fprintf(script,
                    "    'chart.csv' using (is(%s) && state('%s', %g) ? $8 : NaN):11 with points "
                    "pt %d lc '%s' title '%s', \\\n",
                    key, is_float ? "float" : "double", top, shape_of(point, is_float), color,
                    is_float && in_double ? "" : title);
    if (has_points(plan, from, p, NULL, top))
        fprintf(script,
                "    'chart.csv' using (is(%s) && failed(%g) ? $8 : NaN):(%g) with points pt 2 lc "
                "'%s' title '%s', \\\n",
                key, top, top / edge, color, in_double || in_float ? "" : title);
}

static bool draw_one(const ChartPlan* plan, int from, int to, const char* folder, Fault* fault) {
    Plot plot;
    double low, high;
    const ChartPoint* first = &plan->point[from];
    error_range(plan, from, to, &low, &high);
    if (!plot_open(&plot, folder, first->name, 960, 640, fault))
        return false;
    fprintf(plot.script,
            "is(scene, method, skin, law) = strcol(1) eq scene && strcol(2) eq method && strcol(3) "
            "eq skin && strcol(4) eq law\n"
            "state(precision, max) = strcol(7) eq precision && strcol(12) eq '1' && $11 <= max\n"
            "failed(max) = strcol(12) eq '0' || (strcol(12) eq '1' && !($11 <= max))\n"
            "set datafile missing NaN\n"
            "set title \"{/:Bold %s}\\n{/*0.8 %s}\"\n"
            "set logscale xy\nset format y '10^{%%L}'\nset grid lt 1 lc rgb '#dddddd'\nset "
            "pointsize 1.1\n"
            "set xlabel 'CPU time per simulated second [ms]'\nset ylabel '%s%s%s%s%s'\n"
            "set yrange [%g:%g]\nset xrange [*<10:3000<*]\nset key outside right top\n"
            "set arrow from %g, graph 0 to %g, graph 1 nohead dt 2 lc '#888888'\n"
            "set label 'real time' at %g, graph 0.02 rotate left offset -0.7,0 tc '#888888'\n",
            first->chart->about, machine_name(), first->measure->unit ? "" : "error of the ",
            first->measure->about, first->measure->unit ? " [" : "",
            first->measure->unit ? first->measure->unit : "", first->measure->unit ? "]" : "", low,
            high, real_time, real_time, real_time);
    if (first->floor > 0)
        fprintf(plot.script,
                "set arrow from graph 0, first %g to graph 1, first %g nohead dt 3 lc '#888888'\n"
                "set label \"the reference's own error\" at graph 0.02, first %g offset 0,0.5 tc "
                "'#888888'\n",
                first->floor, first->floor, first->floor);
    fprintf(plot.script,
            "plot \\\n"
            "    'front.csv' using (is('%s','-','-','-') ? $5 : NaN):6 with lines lw 9 "
            "lc '#eeddaa' title 'best of all', \\\n",
            first->name);
    for (int p = from; p < to; p++)
        if (is_drawn(plan, from, p))
            plot_line(plan, from, p, high, plot.script);
    fprintf(plot.script, "    NaN with points pt 6 lc '#444444' title 'hollow: float', \\\n"
                         "    NaN with points pt 2 lc '#444444' title 'fell'\n");
    return plot_close(&plot, fault);
}

bool chart_draw(const ChartPlan* plan, const char* folder, Fault* fault) {
    for (int from = 0; from < plan->points; from = chart_end(plan, from))
        if (!draw_one(plan, from, chart_end(plan, from), folder, fault))
            return false;
    return true;
}
