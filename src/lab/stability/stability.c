#include "lab/stability/stability.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "lab/run/plot.h"
#include "lab/run/result_file.h"
#include "lab/stability/trial.h"

enum { MAX_KEYS = 4, MAX_DAMPINGS = 5 };

/// An overridden key: its value is the text or, with NULL, `factor` times the axis' value.
typedef struct Key {
    const char* key;
    double factor;
    const char* text;
} Key;

/// A map: the step on the horizontal axis, one quantity of the scene on the vertical one.
typedef struct MapCase {
    const char* scene;
    const char* axis; ///< label of the vertical axis
    Key key[MAX_KEYS];
    bool logarithmic;
    double low, high; ///< range of the vertical axis
    int rows, quick_rows;
    double shortest, longest; ///< steps [s], spaced by equal ratios
    int columns, quick_columns;
} MapCase;

/// Rows of stability.csv: a scene at each damping.
typedef struct LimitCase {
    const char* name;
    const char* scene;
    Key key[MAX_KEYS];
    double damping[MAX_DAMPINGS]; ///< coefficient, the first may be 0 [kg/s]
    int dampings;
    bool fine; ///< not in a quick run
} LimitCase;

// clang-format off
static const MapCase map_table[] = {
    {"limit-springs", "structural stiffness [N/m], shear and flexion a fifth",
     {{"balloons.0.skin.springs.structural", 1, NULL},
      {"balloons.0.skin.springs.shear", 0.2, NULL},
      {"balloons.0.skin.springs.flexion", 0.2, NULL}},
     true, 3.125, 800, 17, 5, 5e-5, 5e-2, 25, 9},
    {"limit-rubber", "gas [of what fills the skin unstretched]",
     {{"balloons.0.inflation.amount", 1, NULL}, {"balloons.0.inflation.law", 0, "gas"},
      {"balloons.0.model", 0, "icosphere:1"}, {"balloons.0.damping.rate", 0, "500"}},
     false, 1, 5, 9, 3, 1e-5, 4e-3, 27, 6},
};
static const LimitCase limit_table[] = {
    {"limit-springs", "limit-springs", {{0}}, {0, 0.05, 0.2, 1, 2}, 5, false},
    {"limit-rubber icosphere:1", "limit-rubber", {{"balloons.0.model", 0, "icosphere:1"}}, {0}, 1, false},
    {"limit-rubber icosphere:2", "limit-rubber", {{"balloons.0.model", 0, "icosphere:2"}}, {0}, 1, true},
    {"limit-rubber icosphere:3", "limit-rubber", {{"balloons.0.model", 0, "icosphere:3"}}, {0}, 1, true},
    {"limit-rubber icosphere:1 gas 2", "limit-rubber",
     {{"balloons.0.model", 0, "icosphere:1"}, {"balloons.0.inflation.law", 0, "gas"},
      {"balloons.0.inflation.amount", 2, NULL}}, {0}, 1, false},
};
// clang-format on
enum {
    MAPS = sizeof map_table / sizeof *map_table,
    LIMITS = sizeof limit_table / sizeof *limit_table
};

static void say(const char* what, const char* scene, const char* method) {
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "%s of %s, %s\n", what, scene, method);
}

/// Overrides for a value of the axis, and for the damping unless it is below 0.
static bool open_at(Trial* trial, const char* scene, const Key* key, double value, double damping,
                    const Method* method, const char** refused, Fault* fault) {
    char word[MAX_KEYS + 1][96];
    SceneSet set[MAX_KEYS + 1];
    int count = 0;
    for (; count < MAX_KEYS && key[count].key; count++)
        if (key[count].text)
            snprintf(word[count], sizeof *word, "%s=%s", key[count].key, key[count].text);
        else
            snprintf(word[count], sizeof *word, "%s=%.17g", key[count].key,
                     key[count].factor * value);
    if (damping >= 0)
        snprintf(word[count++], sizeof *word, "balloons.0.damping.coefficient=%.17g", damping);
    for (int k = 0; k < count; k++)
        set[k].text = word[k];
    return trial_open(trial, scene, set, count, method, refused, fault);
}

static double spaced(double low, double high, int k, int count, bool logarithmic) {
    const double part = (double)k / (count - 1);
    return logarithmic ? low * pow(high / low, part) : low + part * (high - low);
}

/// Measure one method's cells of a map, or set the reason why it refuses the scene.
static bool map_method(const MapCase* map, const Method* method, bool quick, FILE* cells,
                       FILE* limits, const char** refused, Fault* fault) {
    const int rows = quick ? map->quick_rows : map->rows;
    const int columns = quick ? map->quick_columns : map->columns;
    say("map", map->scene, method->name);
    for (int r = 0; r < rows; r++) {
        Trial trial;
        const double value = spaced(map->low, map->high, r, rows, map->logarithmic);
        if (!open_at(&trial, map->scene, map->key, value, -1, method, refused, fault))
            return *refused;
        fprintf(limits, "%s,%s,%.17g,%.17g,%.17g\n", map->scene, method->name, value,
                trial_theory(&trial), trial_bound(&trial));
        for (int c = 0; c < columns; c++) {
            const double h = spaced(map->shortest, map->longest, c, columns, true);
            double growth;
            const Verdict verdict = trial_run(&trial, h, &growth);
            fprintf(cells, "%s,%s,%.17g,%.17g,%s,%.17g\n", map->scene, method->name, h, value,
                    verdict_name[verdict], growth);
        }
        trial_close(&trial);
    }
    return true;
}

static void print_ratio(double a, double b) {
    if (a > 0 && b > 0 && isfinite(a) && isfinite(b))
        printf(" %9.4f", a / b);
    else
        printf(" %9s", "-");
}

/// One method's rows of stability.csv.
static bool limit_method(const LimitCase* limit, const Method* method, FILE* out, Fault* fault) {
    say("limit", limit->name, method->name);
    for (int d = 0; d < limit->dampings; d++) {
        Trial trial;
        const char* refused;
        if (!open_at(&trial, limit->scene, limit->key, 1, limit->damping[d], method, &refused,
                     fault))
            return refused;
        const double measured = trial_limit(&trial), theory = trial_theory(&trial),
                     bound = trial_bound(&trial);
        trial_close(&trial);
        fprintf(out, "%s,%s,%.17g,%.17g,%.17g,%.17g\n", limit->name, method->name,
                limit->damping[d], measured, theory, bound);
        printf("%-31s %-11s %5g %11.5g %11.5g %11.5g", limit->name, method->name, limit->damping[d],
               measured, theory, bound);
        print_ratio(measured, theory);
        print_ratio(bound, measured);
        printf("\n");
        fflush(stdout);
        if (measured * (1 + trial_precision) < bound)
            return fault_set(fault, limit->name,
                             "with method '%s' a step of %g s is not stable, and the bound is %g s",
                             method->name, measured * (1 + trial_precision), bound);
    }
    return true;
}

static const char cells_head[] = "scene,method,step,stiffness,verdict,growth_rate\n";
static const char map_limits_head[] = "scene,method,stiffness,step_theory,step_bound\n";

/// Open a file of results and write its header line.
static FILE* create(const char* folder, const char* name, const char* head, Fault* fault) {
    FILE* out = result_file_open(folder, name, head, fault);
    if (out)
        fputs(head, out);
    return out;
}

/// refused[map][method].
static bool measure_maps(const char* folder, bool quick, const char** refused, Fault* fault) {
    FILE* cells = create(folder, "map.csv", cells_head, fault);
    FILE* limits = create(folder, "map-limit.csv", map_limits_head, fault);
    bool good = cells && limits;
    for (int k = 0; good && k < MAPS; k++)
        for (int m = 0; good && m < method_count; m++)
            good = map_method(&map_table[k], method_table[m], quick, cells, limits,
                              &refused[k * method_count + m], fault);
    good = (!cells || result_file_close(cells, folder, "map.csv", fault)) && good;
    return (!limits || result_file_close(limits, folder, "map-limit.csv", fault)) && good;
}

static bool measure_limits(const char* folder, bool quick, Fault* fault) {
    FILE* out = create(folder, "stability.csv",
                       "scene,method,damping,step_measured,step_theory,step_bound\n", fault);
    bool good = out != NULL;
    if (good)
        printf("%-31s %-11s %5s %11s %11s %11s %9s %9s\n", "scene", "method", "damp", "measured s",
               "theory s", "bound s", "/theory", "bound/");
    for (int k = 0; good && k < LIMITS; k++)
        for (int m = 0; good && m < method_count; m++)
            if (!quick || !limit_table[k].fine)
                good = limit_method(&limit_table[k], method_table[m], out, fault);
    return (!out || result_file_close(out, folder, "stability.csv", fault)) && good;
}

static bool draw(const char* folder, const MapCase* map, bool quick, const char* const* refused,
                 Fault* fault) {
    char name[64];
    snprintf(name, sizeof name, "map-%s", map->scene);
    Plot plot;
    const int columns = method_count < 3 ? method_count : 3;
    const int lines = (method_count + columns - 1) / columns;
    if (!plot_open(&plot, folder, name, 420 * columns, 420 * lines, fault))
        return false;

    // half a cell to each side
    const int rows = quick ? map->quick_rows : map->rows;
    const int steps = quick ? map->quick_columns : map->columns;
    const double part = 0.5 / (rows - 1);
    fprintf(plot.script, "right = %.9g\nup = %.9g\n",
            pow(map->longest / map->shortest, 0.5 / (steps - 1)),
            map->logarithmic ? pow(map->high / map->low, part) : part * (map->high - map->low));
    fprintf(plot.script,
            "set multiplot layout %d,%d\n"
            "set logscale x\nset format x '10^{%%T}'\n"
            "set xlabel 'step [s]'\nset ylabel '%s'\n"
            "set key bottom left opaque samplen 2 font ',9'\nset style fill solid noborder\nset "
            "tics front\n",
            lines, columns, map->axis);
    if (map->logarithmic)
        fprintf(plot.script, "set logscale y\n");
    // an empty panel says why
    fprintf(plot.script, "why(m) = ");
    for (int m = 0; m < method_count; m++)
        if (refused[m])
            fprintf(plot.script, "m eq '%s' ? \"%s\" : ", method_table[m]->name, refused[m]);
    fprintf(plot.script, "''\n");
    fprintf(plot.script,
            "low(c) = %s\nhigh(c) = %s\n"
            "is(m, v) = strcol(1) eq '%s' && strcol(2) eq m && (v eq '' || strcol(5) eq v)\n"
            "array verdict[3] = ['stable', 'marginal', 'exploded']\n"
            "array color[3] = ['#9ecae1', '#fec44f', '#cb181d']\n"
            "do for [m in '",
            map->logarithmic ? "c / up" : "c - up", map->logarithmic ? "c * up" : "c + up",
            map->scene);
    for (int m = 0; m < method_count; m++)
        fprintf(plot.script, "%s%s", m ? " " : "", method_table[m]->name);
    fprintf(
        plot.script,
        "'] {\n"
        "set title m\n"
        "set label 1 why(m) at graph 0.5,0.5 center font ',10'\n"
        "if (why(m) eq '') {set key on} else {set key off}\n"
        "plot [%.9g / right:%.9g * right] [low(%.9g):high(%.9g)] \\\n"
        "    for [k = 1:3] 'map.csv' skip 1 using (is(m, verdict[k]) ? $3 : NaN):4:($3 / right):"
        "($3 * right):(low($4)):(high($4)) with boxxyerror lc rgb color[k] title verdict[k], \\\n"
        "    'map-limit.csv' skip 1 using (is(m, '') ? $4 : NaN):3 with lines lw 2 lc 'black' "
        "title 'theory', \\\n"
        "    '' skip 1 using (is(m, '') ? $5 : NaN):3 with lines dt 2 lw 2 lc 'black' title "
        "'bound'\n"
        "}\nunset multiplot\n",
        map->shortest, map->longest, map->low, map->high);
    return plot_close(&plot, fault);
}

bool stability(const char* folder, bool quick, Fault* fault) {
    const char** refused = new_array(const char*, MAPS* method_count);
    bool good = result_folder(folder, fault) &&
                result_file_allowed(folder, "map.csv", cells_head, fault) &&
                result_file_allowed(folder, "map-limit.csv", map_limits_head, fault) &&
                measure_limits(folder, quick, fault) && measure_maps(folder, quick, refused, fault);
    for (int k = 0; good && k < MAPS; k++)
        good = draw(folder, &map_table[k], quick, &refused[k * method_count], fault);
    free(refused);
    return good;
}
