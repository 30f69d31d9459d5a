#include "show/lab_page.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/memory.h"
#include "show/stages.h"

_Static_assert((int)MAP_ROWS == (int)PAGE_ROWS && (int)MAP_COLUMNS == (int)PAGE_COLUMNS,
               "a page holds a map");

LabPage* lab_page_open(const World* world, const SceneSet* set, int set_count, bool timed) {
    LabPage* lab = new_array(LabPage, 1);
    lab->timed = timed;
    slider_open(&lab->slider, world, set, set_count);
    lab_page_begin(lab);
    map_begin(&lab->map, world, set, set_count);
    lab_page_choose(lab, MAP_OWN_ROW, MAP_OWN_COLUMN);
    return lab;
}

void lab_page_begin(LabPage* lab) {
    history_begin(&lab->history);
    slider_begin(&lab->slider);
    lab->looked = NONE;
    lab->spent = 0;
    lab->steps = 0;
}

void lab_page_start(LabPage* lab, const World* world) {
    if (lab->history.count == 0)
        history_add(&lab->history, world, (double)NAN);
    lab->since = lab->timed ? stages_now() : 0;
}

void lab_page_step(LabPage* lab, const World* world, long every, double less) {
    const double ms = lab->timed ? stages_now() - lab->since - less : 0;
    slider_step(&lab->slider, world, ms);
    lab->spent += ms;
    lab->steps++;
    if (history_due(&lab->history, world, every)) {
        history_add(&lab->history, world, lab->timed ? lab->spent / lab->steps : (double)NAN);
        lab->spent = 0;
        lab->steps = 0;
    }
    lab_page_start(lab, world);
}

/// The axis of stretches ends at the least of these that all points are below.
static const double end_table[] = {1.05, 1.1, 1.25, 1.5, 2, 3, 5, 10};
enum { ENDS = sizeof end_table / sizeof *end_table };
/// The axis of pressures ends above the truth's highest. [1]
static const double above = 1.3;

static void curve_take(const History* history, const Spherical* round, PageCurve* curve) {
    double l = 1, p = 0, most = 1, highest = 0;
    curve->law = round->truth.law->name;
    curve->count = history->count;
    for (int k = 0; k < history->count; k++) {
        l = cbrt(history_value(history, HISTORY_VOLUME, k) / round->volume);
        p = history_value(history, HISTORY_PRESSURE, k);
        most = fmax(most, l);
        curve->way[k][0] = (float)l;
        curve->way[k][1] = (float)p;
    }
    int end = 0;
    while (end + 1 < ENDS && end_table[end] < most)
        end++;
    for (int k = 0; k < PAGE_CURVE; k++) {
        const double at = 1 + (end_table[end] - 1) * k / (PAGE_CURVE - 1);
        const double truth = truth_pressure(&round->truth, at);
        highest = fmax(highest, truth);
        curve->truth[k] = (float)truth;
    }
    curve->stretch = (float)end_table[end];
    curve->pressure = (float)(above * highest);
    snprintf(curve->value, sizeof curve->value, "l %.4g  p %.4g  truth %.4g", l, p,
             truth_pressure(&round->truth, l));
}

void lab_page_work(LabPage* lab, double parts, double ms) {
    const double end = stages_now() + ms;
    for (double part = 0; part < parts && map_work(&lab->map) && stages_now() < end; part++)
        ;
}

void lab_page_choose(LabPage* lab, int row, int column) {
    int* chosen = lab->page.map.chosen;
    if (row >= 0 && row < MAP_ROWS)
        chosen[0] = row;
    if (column >= 0 && column < MAP_COLUMNS)
        chosen[1] = column;
}

static PageCell cell_of(int verdict) {
    return verdict == MAP_UNKNOWN ? PAGE_UNKNOWN : (PageCell)(verdict + PAGE_STABLE);
}

static void map_take(const Map* map, PageMap* page) {
    for (int r = 0; r < MAP_ROWS; r++) {
        page->theory[r] = (float)map_place(map, map->theory[r]);
        page->bound[r] = (float)map_place(map, map->bound[r]);
        for (int c = 0; c < MAP_COLUMNS; c++)
            page->cell[r][c] = cell_of(map->cell[r][c]);
    }
    page->own[0] = MAP_OWN_ROW;
    page->own[1] = MAP_OWN_COLUMN;
    page->method = map->def.method ? map->def.method : method_table[0]->name;
    snprintf(page->why, sizeof page->why, "%.42s", map->why);
    snprintf(page->ends, sizeof page->ends, "%.3g to %.3g ms; x 1/16 to x 16",
             1e3 * map_step(map, 0), 1e3 * map_step(map, MAP_COLUMNS - 1));

    const int verdict = map->cell[page->chosen[0]][page->chosen[1]];
    snprintf(page->value, sizeof page->value, "%.3g ms, x %g: %s",
             1e3 * map_step(map, page->chosen[1]), map_stiffness(page->chosen[0]),
             verdict == MAP_UNKNOWN ? "not measured yet" : verdict_name[verdict]);
}

const Page* lab_page_take(LabPage* lab, const World* world, bool watched, int notch) {
    Page* page = &lab->page;
    const int balloon = history_balloon(world);
    snprintf(page->title, sizeof page->title, "Balloon %d", balloon);
    history_take(&lab->history, page);

    if (lab->looked != balloon)
        page->has_curve = world->balloon[balloon].def->inflation &&
                          spherical_find(&world->balloon[balloon], &lab->round);
    lab->looked = balloon;
    if (page->has_curve)
        curve_take(&lab->history, &lab->round, &page->curve);
    map_take(&lab->map, &page->map);
    page->map.watched = watched;
    slider_take(&lab->slider, world, notch, lab->timed, &page->slider);
    return page;
}

void lab_page_close(LabPage* lab) {
    if (lab) {
        map_end(&lab->map);
        slider_close(&lab->slider);
    }
    free(lab);
}
