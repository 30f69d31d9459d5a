#include "lab/stability/map.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "force/force.h"

/// Maximum size of a balloon for implicit methods, whose steps would take longer than a frame.
/// [particles]
enum { MAX_SOLVED = 700 };

/// Steps of a method without iterations in one part.
enum { PART = 64 };

static void store_near(Map* map, const real4* x, int count) {
    free(map->near);
    map->near = new_array(real4, count);
    map->near_count = count;
    memcpy(map->near, x, (size_t)count * sizeof *x);
}

void map_begin(Map* map, const World* world, const SceneSet* set, int set_count) {
    const Balloon* balloon = &world->balloon[0];
    Fault fault = {0};
    *map = (Map){.set = set, .set_count = set_count, .amount = balloon->body.inflation.amount};
    if (balloon->def->inflation)
        map->pressure = balloon_pressure(balloon);
    store_near(map, balloon->body.x, balloon->body.count);
    for (int r = 0; r < MAP_ROWS; r++) {
        map->theory[r] = map->bound[r] = (double)NAN;
        for (int c = 0; c < MAP_COLUMNS; c++)
            map->cell[r][c] = MAP_UNKNOWN;
    }
    if (!scene_load(world->def.file, set, set_count, &map->def, &fault))
        snprintf(map->why, sizeof map->why, "%s", fault.text);
    else if (balloon->def->inflation && !balloon->mesh.closed)
        snprintf(map->why, sizeof map->why, "an open skin that is blown has no rest");
    else if (world->method->can_fail && balloon->body.count > MAX_SOLVED)
        snprintf(map->why, sizeof map->why, "%s: no map above %d particles", world->method->name,
                 MAX_SOLVED);
    if (map->why[0])
        map->rows_done = MAP_ROWS;
}

double map_step(const Map* map, int column) {
    return map->def.step * pow(2, 0.5 * (column - MAP_OWN_COLUMN));
}

double map_stiffness(int row) {
    return pow(2, row - MAP_OWN_ROW);
}

double map_position(const Map* map, double step) {
    return MAP_OWN_COLUMN + 2 * log2(step / map->def.step);
}

__attribute__((format(printf, 2, 3))) static void add(MapSets* sets, const char* format, ...) {
    ASSERT(sets->words < MAP_WORDS && sets->count < MAP_SETS, "a map has room for its overrides");
    char* word = sets->word[sets->words++];
    va_list list;
    va_start(list, format);
    vsnprintf(word, MAP_WORD, format, list);
    va_end(list);
    sets->set[sets->count++].text = word;
}

static void begin_sets(const Map* map, MapSets* sets) {
    sets->count = sets->words = 0;
    ASSERT(map->set_count <= MAP_SETS - MAP_WORDS, "a map has room for its scene's overrides");
    for (; sets->count < map->set_count; sets->count++)
        sets->set[sets->count] = map->set[sets->count];
}

/// Multiply all stiffnesses of the first balloon's skin by the factor.
static void stiffen(const Map* map, double factor, MapSets* sets) {
    const SkinDef* skin = &map->def.balloons[0].skin;
    const SpringsDef* springs = skin->springs;
    if (skin->membrane)
        add(sets, "balloons.0.skin.membrane.young=%.17g", factor * skin->membrane->young);
    if (springs && springs->structural > 0)
        add(sets, "balloons.0.skin.springs.structural=%.17g", factor * springs->structural);
    if (springs && springs->shear > 0)
        add(sets, "balloons.0.skin.springs.shear=%.17g", factor * springs->shear);
    if (springs && springs->flexion > 0)
        add(sets, "balloons.0.skin.springs.flexion=%.17g", factor * springs->flexion);
    if (springs && springs->torsion > 0)
        add(sets, "balloons.0.skin.springs.torsion=%.17g", factor * springs->torsion);
}

/// The row that is measured k-th: 4, 5, 3, 6, 2, …, the scene's own first.
static int row_of(int k) {
    return MAP_OWN_ROW + (k % 2 ? (k + 1) / 2 : -k / 2);
}

/// Remove everything but skin, gas and damping; the balloon never falls asleep.
static void strip(const Map* map, MapSets* sets) {
    const BalloonDef* balloon = &map->def.balloons[0];
    add(sets, "guard='off'");
    add(sets, "gravity=0");
    if (map->def.sleep_threshold > 0)
        add(sets, "sleep_threshold=0");
    for (int k = 0; k < force_count; k++)
        if (balloon->force[k] && force_table[k]->external && force_table[k]->energy)
            add(sets, "balloons.0.%s=~", force_table[k]->name);
    if (balloon->strings_count > 0)
        add(sets, "balloons.0.strings=~");
    if (balloon->strain_limit)
        add(sets, "balloons.0.strain_limit=~");
    if (!balloon->inflation)
        return;
    const double factor = map_stiffness(row_of(map->rows_done));
    if (balloon->inflation->law != INFLATE_GAS)
        add(sets, "balloons.0.inflation={law: pressure, amount: %.17g}", factor * map->pressure);
    else {
        add(sets, "balloons.0.inflation.amount=%.17g", map->amount);
        if (balloon->inflation->fill)
            add(sets, "balloons.0.inflation.fill=~");
        if (balloon->inflation->leak > 0)
            add(sets, "balloons.0.inflation.leak=0");
    }
}

/// Load the scene with its first balloon alone.
static bool load(const Map* map, MapSets* sets, WorldDef* def, Fault* fault) {
    if (!scene_load(map->def.file, sets->set, sets->count, def, fault))
        return false;
    def->balloons_count = 1;
    def->spheres_count = def->walls_count = def->things_count = def->pipes_count = 0;
    def->floor = NULL;
    return true;
}

static bool open_row(Map* map, Fault* fault) {
    MapSets sets;
    WorldDef calm, def;
    begin_sets(map, &sets);
    strip(map, &sets);
    stiffen(map, map_stiffness(row_of(map->rows_done)), &sets);
    if (!load(map, &sets, &def, fault))
        return false;
    add(&sets, "method=%s", method_newton.name);
    add(&sets,
        "solver={iterations: 1, fixed: true}"); // one iteration a part; relaxation needs many
    if (!load(map, &sets, &calm, fault)) {
        scene_free(&def);
        return false;
    }
    if (!trial_begin(&map->trial, &calm, &def, fault))
        return false;
    Body* body = &map->trial.calm.balloon[0].body;
    if (body->count == map->near_count)
        memcpy(body->x, map->near, (size_t)body->count * sizeof *body->x);
    return true;
}

static void close_row(Map* map) {
    if (map->is_open)
        trial_close(&map->trial);
    map->is_open = map->at_rest = map->running = false;
    map->column = 0;
    map->rows_done++;
}

/// One part of the preparation of a trial.
static void prepare(Map* map) {
    Fault fault = {0};
    bool good = true;
    if (!map->is_open)
        good = map->is_open = open_row(map, &fault);
    else
        good = trial_prepare(&map->trial, &map->at_rest, &fault);
    if (map->at_rest) {
        map->theory[row_of(map->rows_done)] = trial_theory(&map->trial);
        map->bound[row_of(map->rows_done)] = trial_bound(&map->trial);
        store_near(map, map->trial.rest, map->trial.world.balloon[0].body.count);
    }
    if (good)
        return;
    snprintf(map->why, sizeof map->why, "%s", fault.text);
    close_row(map);
}

bool map_work(Map* map) {
    if (map->rows_done == MAP_ROWS)
        return false;
    if (!map->at_rest) {
        prepare(map);
        return true;
    }
    if (!map->running)
        trial_start(&map->trial, map_step(map, map->column));
    double growth;
    Verdict verdict;
    const int steps = map->trial.world.method->iterates ? 1 : PART;
    map->running = !trial_follow(&map->trial, steps, &verdict, &growth);
    if (map->running)
        return true;
    map->cell[row_of(map->rows_done)][map->column++] = (int)verdict;
    if (map->column == MAP_COLUMNS)
        close_row(map);
    return true;
}

void map_sets(const Map* map, int row, int column, MapSets* sets) {
    begin_sets(map, sets);
    add(sets, "guard=\"off\"");
    add(sets, "step=%.17g", map_step(map, column));
    stiffen(map, map_stiffness(row), sets);
}

void map_end(Map* map) {
    if (map->is_open)
        trial_close(&map->trial);
    scene_free(&map->def);
    free(map->near);
    *map = (Map){0};
}
