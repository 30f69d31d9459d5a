#include "show/live_lab.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/memory.h"
#include "show/stages.h"

_Static_assert((int)MAP_ROWS == (int)LAB_ROWS && (int)MAP_COLUMNS == (int)LAB_COLUMNS,
               "a panel holds a map");

LiveLab* live_lab_open(const World* world, const SceneSet* set, int set_count, bool timed) {
    LiveLab* lab = new_array(LiveLab, 1);
    lab->timed = timed;
    slider_open(&lab->slider, world, set, set_count);
    live_lab_begin(lab);
    map_begin(&lab->map, world, set, set_count);
    live_lab_choose(lab, MAP_OWN_ROW, MAP_OWN_COLUMN);
    return lab;
}

void live_lab_begin(LiveLab* lab) {
    history_begin(&lab->history);
    slider_begin(&lab->slider);
    lab->sphere_balloon = NONE;
    lab->point_ms = 0;
    lab->point_steps = 0;
}

void live_lab_start(LiveLab* lab, const World* world) {
    if (lab->history.count == 0)
        history_add(&lab->history, world, (double)NAN);
    lab->step_start = lab->timed ? stages_now() : 0;
}

void live_lab_step(LiveLab* lab, const World* world, long interval, double excluded_ms) {
    const double ms = lab->timed ? stages_now() - lab->step_start - excluded_ms : 0;
    slider_step(&lab->slider, world, ms);
    lab->point_ms += ms;
    lab->point_steps++;
    if (history_due(&lab->history, world, interval)) {
        history_add(&lab->history, world,
                    lab->timed ? lab->point_ms / lab->point_steps : (double)NAN);
        lab->point_ms = 0;
        lab->point_steps = 0;
    }
    live_lab_start(lab, world);
}

/// The axis of stretches ends at the smallest of these that is above all points.
static const double end_table[] = {1.05, 1.1, 1.25, 1.5, 2, 3, 5, 10};
enum { ENDS = sizeof end_table / sizeof *end_table };
/// End of the axis of pressures over the maximum of the closed form. [1]
static const double HEADROOM = 1.3;

static void fill_curve(const History* history, const Spherical* sphere, LabCurve* curve) {
    double l = 1, p = 0, max_stretch = 1, max_pressure = 0;
    curve->law = sphere->truth.law->name;
    curve->count = history->count;
    for (int k = 0; k < history->count; k++) {
        l = cbrt(history_value(history, HISTORY_VOLUME, k) / sphere->volume);
        p = history_value(history, HISTORY_PRESSURE, k);
        max_stretch = fmax(max_stretch, l);
        curve->path[k][0] = (float)l;
        curve->path[k][1] = (float)p;
    }
    int end = 0;
    while (end + 1 < ENDS && end_table[end] < max_stretch)
        end++;
    for (int k = 0; k < LAB_CURVE; k++) {
        const double stretch = 1 + (end_table[end] - 1) * k / (LAB_CURVE - 1);
        const double truth = truth_pressure(&sphere->truth, stretch);
        max_pressure = fmax(max_pressure, truth);
        curve->truth[k] = (float)truth;
    }
    curve->stretch = (float)end_table[end];
    curve->pressure = (float)(HEADROOM * max_pressure);
    snprintf(curve->value, sizeof curve->value, "l %.4g  p %.4g  truth %.4g", l, p,
             truth_pressure(&sphere->truth, l));
}

void live_lab_work(LiveLab* lab, double parts, double ms) {
    const double end = stages_now() + ms;
    for (double part = 0; part < parts && map_work(&lab->map) && stages_now() < end; part++)
        ;
}

void live_lab_choose(LiveLab* lab, int row, int column) {
    int* chosen = lab->panel.map.chosen;
    if (row >= 0 && row < MAP_ROWS)
        chosen[0] = row;
    if (column >= 0 && column < MAP_COLUMNS)
        chosen[1] = column;
}

static LabCell cell_of(int verdict) {
    return verdict == MAP_UNKNOWN ? LAB_UNKNOWN : (LabCell)(verdict + LAB_STABLE);
}

static void fill_map(const Map* map, LabMap* panel) {
    for (int r = 0; r < MAP_ROWS; r++) {
        panel->theory[r] = (float)map_position(map, map->theory[r]);
        panel->bound[r] = (float)map_position(map, map->bound[r]);
        for (int c = 0; c < MAP_COLUMNS; c++)
            panel->cell[r][c] = cell_of(map->cell[r][c]);
    }
    panel->own[0] = MAP_OWN_ROW;
    panel->own[1] = MAP_OWN_COLUMN;
    panel->method = map->def.method ? map->def.method : method_table[0]->name;
    snprintf(panel->why, sizeof panel->why, "%.42s", map->why);
    snprintf(panel->ends, sizeof panel->ends, "%.3g to %.3g ms; x 1/16 to x 16",
             1e3 * map_step(map, 0), 1e3 * map_step(map, MAP_COLUMNS - 1));

    const int verdict = map->cell[panel->chosen[0]][panel->chosen[1]];
    snprintf(panel->value, sizeof panel->value, "%.3g ms, x %g: %s",
             1e3 * map_step(map, panel->chosen[1]), map_stiffness(panel->chosen[0]),
             verdict == MAP_UNKNOWN ? "not measured yet" : verdict_name[verdict]);
}

const LabPanel* live_lab_update(LiveLab* lab, const World* world, bool watched, int notch) {
    LabPanel* panel = &lab->panel;
    const int balloon = history_balloon(world);
    snprintf(panel->title, sizeof panel->title, "Balloon %d", balloon);
    history_plot(&lab->history, panel);

    if (lab->sphere_balloon != balloon)
        panel->has_curve = world->balloon[balloon].def->inflation &&
                           spherical_find(&world->balloon[balloon], &lab->sphere);
    lab->sphere_balloon = balloon;
    if (panel->has_curve)
        fill_curve(&lab->history, &lab->sphere, &panel->curve);
    fill_map(&lab->map, &panel->map);
    panel->map.watched = watched;
    slider_fill(&lab->slider, world, notch, lab->timed, &panel->slider);
    return panel;
}

void live_lab_close(LiveLab* lab) {
    if (lab) {
        map_end(&lab->map);
        slider_close(&lab->slider);
    }
    free(lab);
}
