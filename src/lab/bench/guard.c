/// The guard's results at long steps: each shipped scene by each method at its own step and at 10
/// and 100 times that, with `guard: split`, for its whole length.
///
/// A cell passes if the run ends and the last volume (area of an open balloon) of each balloon is
/// within 10 volume_tolerance of the range of the reference's volumes in the second half of the
/// scene. The reference is the scene by its own method at half its own step, in double. If the
/// scene is at rest by then, the range is one volume; if it still oscillates, methods damp it
/// differently and may rest outside, so the range is extended by its width on both sides. A cell
/// may also stop or be refused with a sentence. It fails with exit status 0 and another volume. A
/// run beyond its CPU time counts apart.
///
/// Where a scene is unstable, as a heavy ball on a soft squirrel, no run holds for its whole length:
/// a second reference, at the scene's own step, tells when its volumes agreed last within
/// volume_tolerance, and cells are compared at that time, if it is in the second half.
///
/// The scenes of the museum of failures are not included: they fail on purpose, and the tests run
/// them.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/paths.h"
#include "lab/bench/bench.h"
#include "lab/run/bounded_run.h"
#include "scene/scene.h"
#include "solve/method.h"

enum { REFERENCES = 2, FACTORS = 3, CELLS_MAX = 32, PARALLEL = 2, ROWS = 64 };
static const double factor_table[FACTORS] = {1, 10, 100}; ///< of the scene's own step

static const double volume_tolerance = 0.01; ///< of the larger of the first and the last volume [1]
static const double cpu_max = 60;            ///< of a run [s]
static const double cpu_quick = 1;           ///< of a run of the quick form [s]
static const double cpu_reference = 600;     ///< of a reference [s]

/// The quick form: small scenes, one of each kind of skin, inflation and contact.
static const char* const quick_scene[] = {"exact-cube",  "limit-rubber", "limit-springs",
                                          "sewn-discs",  "sphere-curve", "sphere-gas",
                                          "spring-kinds"};

typedef struct Cell {
    const Method* method;
    double factor;
} Cell;

/// A scene with its own step, method and length.
typedef struct GuardScene {
    char name[256];
    const char* method;
    double step, seconds;
    unsigned balloons;
} GuardScene;

/// Endings of all cells of a method and a factor.
typedef struct Counts {
    int ending[ENDINGS];
} Counts;

typedef struct Table {
    const BenchOptions* options;
    char program[2][512]; ///< float, double
    Counts counts[CELLS_MAX];
    int cells, wrong;
} Table;

static bool load_scene(const char* path, GuardScene* scene, Fault* fault) {
    WorldDef def;
    scene_name(path, scene->name);
    if (!scene_load(scene->name, NULL, 0, &def, fault))
        return false;
    const Method* method = def.method ? method_find(def.method) : method_table[0];
    scene->method = method->name;
    scene->step = def.step;
    scene->seconds = def.seconds;
    scene->balloons = def.balloons_count;
    scene_free(&def);
    return true;
}

static void add_run(const Table* table, Launch* launch, const GuardScene* scene, bool in_double,
                    const char* method, double step) {
    bounded_run(launch, table->program[in_double], scene->name, scene->seconds, ROWS,
                table->options->quick ? cpu_quick : cpu_max);
    launch_add(launch, "--guard=split");
    launch_add(launch, "--method=%s", method);
    launch_add(launch, "--step=%.17g", step);
}

/// Name of the volume's column of balloon b, of an open one the area's.
static const char* column_of(const Report* reference, unsigned b, char column[32]) {
    snprintf(column, 32, "balloon%u.volume", b);
    if (isnan(report_at(reference, column, 0)))
        snprintf(column, 32, "balloon%u.area", b);
    return column;
}

/// Largest number of a column.
static double size_of(const Report* reference, const char* column) {
    double size = 0;
    for (int r = 0; r < reference->rows; r++)
        size = fmax(size, fabs(report_at(reference, column, r)));
    return size;
}

/// Whether the volumes of both references agree in a row.
static bool is_told(const Report reference[REFERENCES], unsigned balloons, int row) {
    for (unsigned b = 0; b < balloons; b++) {
        char column[32];
        column_of(&reference[0], b, column);
        const double difference =
            report_at(&reference[0], column, row) - report_at(&reference[1], column, row);
        if (fabs(difference) > volume_tolerance * size_of(&reference[0], column))
            return false;
    }
    return true;
}

/// Rows up to the last in which both references agree; all, if that is not in the second half.
static int rows_told(const Report reference[REFERENCES], unsigned balloons) {
    const int rows = reference[0].rows;
    int told = rows;
    while (told > 0 && !is_told(reference, balloons, told - 1))
        told--;
    return 2 * told > rows ? told : rows;
}

/// Distance of a value from the range of a column in the second half of the rows told, extended by
/// its width on both sides, relative to the column's largest number [1].
static double distance_from(const Report* reference, int told, const char* column, double value) {
    double low = INFINITY, high = -INFINITY;
    for (int r = 0; r < told; r++) {
        const double now = report_at(reference, column, r);
        low = 2 * r < told ? low : fmin(low, now);
        high = 2 * r < told ? high : fmax(high, now);
    }
    return fmax(fmax(low - value, value - high) - (high - low), 0) / size_of(reference, column);
}

/// Largest error of the balloons' volumes, or areas, in the last row told [1].
static double volume_error(const Report* run, const Report* reference, int told,
                           unsigned balloons) {
    const double time = report_at(reference, "t", told - 1);
    double max = 0;
    for (unsigned b = 0; b < balloons; b++) {
        char column[32];
        column_of(reference, b, column);
        const double value = told == reference->rows ? report_at(run, column, -1)
                                                     : report_at_time(run, column, time);
        const double error = distance_from(reference, told, column, value);
        max = error > max || isnan(error) ? error : max;
    }
    return max;
}

static void print_cell(Table* table, const GuardScene* scene, int cell, const Cell* of,
                       const Launch* launch, const Report* reference, int told) {
    Report report;
    char text[ENDING_TEXT];
    report_read(&report, launch);
    Ending ending = bounded_run_ending(launch, &report, text);
    double error = (double)NAN;
    if (ending == ENDING_GOOD) {
        error = volume_error(&report, reference, told, scene->balloons);
        if (!(error <= 10 * volume_tolerance)) {
            ending = ENDING_WRONG;
            snprintf(text, sizeof text, "the volume is off by %.3g %%", 100 * error);
        }
    }
    table->counts[cell].ending[ending]++;
    table->wrong += ending == ENDING_WRONG;
    printf("%s,%s,%g,%g,%s,%.3g,%.4g,%.4g,%d,%g,\"%s\"\n", scene->name, of->method->name,
           of->factor, of->factor * scene->step,
           ending == ENDING_GOOD ? "kept" : ending_name[ending], error,
           report_at(reference, "t", told - 1), report.ms * scene->seconds / 1e3, report.substeps,
           report_at(&report, "guard.taken_back", -1), text);
    fflush(stdout);
    report_free(&report);
}

static void print_cells(Table* table, const GuardScene* scene, const Launch* launch,
                        const int* index, const Cell* cell, int count, Fault* fault) {
    Report reference[REFERENCES];
    for (int r = 0; r < REFERENCES; r++) {
        report_read(&reference[r], &launch[r]);
        if (!reference[r].ended)
            fault_set(fault, scene->name, "a reference did not end: %s", launch[r].err);
    }
    const bool ended = reference[0].ended && reference[1].ended;
    const int told = ended ? rows_told(reference, scene->balloons) : 0;
    for (int k = 0; ended && k < count; k++)
        print_cell(table, scene, index[k], &cell[k], &launch[REFERENCES + k], reference, told);
    for (int r = 0; r < REFERENCES; r++)
        report_free(&reference[r]);
}

/// Run the references and the cells of a scene, those with a word in their names.
static bool measure_scene(Table* table, const GuardScene* scene, Fault* fault) {
    Launch launch[REFERENCES + CELLS_MAX];
    Cell cell[CELLS_MAX];
    int index[CELLS_MAX], count = 0;
    for (int r = 0; r < REFERENCES; r++) {
        add_run(table, &launch[r], scene, true, scene->method, scene->step / (r ? 1 : 2));
        launch[r].cpu_ask = launch[r].cpu_max = cpu_reference;
    }
    for (int m = 0; m < method_count; m++)
        for (int f = 0; f < FACTORS; f++) {
            char row[320];
            snprintf(row, sizeof row, "%s %s %g", scene->name, method_table[m]->name,
                     factor_table[f]);
            if (table->options->only && !strstr(row, table->options->only))
                continue;
            cell[count] = (Cell){method_table[m], factor_table[f]};
            index[count] = m * FACTORS + f;
            add_run(table, &launch[REFERENCES + count++], scene, false, method_table[m]->name,
                    factor_table[f] * scene->step);
        }
    bool good = count == 0 || launch_all(launch, REFERENCES + count, PARALLEL, scene->name, fault);
    if (good && count > 0) {
        print_cells(table, scene, launch, index, cell, count, fault);
        good = fault->text[0] == 0;
    }
    for (int k = 0; k < REFERENCES + count; k++)
        launch_free(&launch[k]);
    table->cells += count;
    return good;
}

static bool is_measured(const Table* table, const char* name) {
    if (strncmp(name, "fails/", 6) == 0)
        return false;
    if (!table->options->quick)
        return true;
    for (size_t k = 0; k < sizeof quick_scene / sizeof *quick_scene; k++)
        if (strcmp(quick_scene[k], name) == 0)
            return true;
    return false;
}

static void print_counts(const Table* table) {
    printf("\n%-12s %6s %8s %8s %8s %8s %8s\n", "method", "step", "kept", "stopped", "refused",
           "long", "WRONG");
    for (int k = 0; k < method_count * FACTORS; k++) {
        const int* ending = table->counts[k].ending;
        printf("%-12s %5gx %8d %8d %8d %8d %8d\n", method_table[k / FACTORS]->name,
               factor_table[k % FACTORS], ending[ENDING_GOOD], ending[ENDING_STOPPED],
               ending[ENDING_REFUSED], ending[ENDING_LONG], ending[ENDING_WRONG]);
    }
    printf("%d cells, %d of them WRONG\n", table->cells, table->wrong);
}

static bool measure(const BenchOptions* options, Fault* fault) {
    Table table = {.options = options};
    ASSERT(method_count * FACTORS <= CELLS_MAX, "there is room for the cells of a scene");
    if (!paths_sibling("balloon", table.program[0], fault) ||
        !paths_sibling("balloon-double", table.program[1], fault))
        return false;
    char** path;
    const int count = scene_list(&path);
    bool good = true;
    puts("scene,method,factor,step,verdict,volume_error,at_s,cpu_s,substeps,taken_back,sentence");
    for (int k = 0; k < count; k++) {
        GuardScene scene;
        scene_name(path[k], scene.name);
        good = good && (!is_measured(&table, scene.name) || (load_scene(path[k], &scene, fault) &&
                                                             measure_scene(&table, &scene, fault)));
        free(path[k]);
    }
    free(path);
    print_counts(&table);
    return good && (table.wrong == 0 || fault_set(fault, "bench guard", "%d of %d cells are wrong",
                                                  table.wrong, table.cells));
}

const BenchCase bench_guard = {
    .name = "guard",
    .about = "every scene by every method at 1, 10 and 100 times its step: kept, or stopped",
    .run = measure,
};
