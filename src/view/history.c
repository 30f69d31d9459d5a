#include "view/history.h"

#include <math.h>
#include <stdio.h>

#include "base/median.h"
#include "world/probe.h"

// clang-format off
static const struct Quantity {
    const char* column; ///< output of the balloon; NULL: the wall time of a step
    const char* label;
    const char* unit;
} quantity_table[LAB_PLOTS] = {
    [HISTORY_VOLUME]   = {"volume",         "volume",    ""},
    [HISTORY_PRESSURE] = {"gauge_pressure", "pressure",  ""},
    [HISTORY_ENERGY]   = {"total_energy",   "energy",    ""},
    [HISTORY_COST]     = {NULL,             "step cost", " ms"},
};
// clang-format on

int history_balloon(const World* world) {
    return world->selected == ALL_BALLOONS ? 0 : world->selected;
}

void history_begin(History* history) {
    *history = (History){.balloon = NONE, .last_step = -1};
}

bool history_due(const History* history, const World* world, long interval) {
    return history->balloon != history_balloon(world) || world->step_count < history->last_step ||
           world->step_count >= history->last_step + interval;
}

void history_add(History* history, const World* world, double step_ms) {
    const int balloon = history_balloon(world);
    if (balloon != history->balloon || world->step_count < history->last_step)
        history_begin(history);
    history->balloon = balloon;
    history->last_step = world->step_count;

    const int index = history->next;
    history->t[index] = world_time(world);
    for (int k = 0; k < LAB_PLOTS; k++) {
        char column[64];
        double* value = &history->value[k][index];
        *value = step_ms;
        if (!quantity_table[k].column)
            continue;
        snprintf(column, sizeof column, "balloon%d.%s", balloon, quantity_table[k].column);
        if (!probe_value(world, column, value))
            *value = (double)NAN;
    }
    history->next = (index + 1) % LAB_POINTS;
    history->count += history->count < LAB_POINTS;
}

/// Index in the ring of the k-th point from the oldest.
static int ring_index(const History* history, int k) {
    return (history->next - history->count + k + LAB_POINTS) % LAB_POINTS;
}

double history_value(const History* history, int quantity, int k) {
    return history->value[quantity][ring_index(history, k)];
}

/// A step that takes so many times the median was interrupted by another process. [1]
static const double SPIKE = 4;

/// Clip values above SPIKE medians: the plot's scale would otherwise flatten all other values.
static void clip_spikes(float* y, int count) {
    double sorted[LAB_POINTS];
    int known = 0;
    for (int k = 0; k < count; k++)
        if (isfinite(y[k]))
            sorted[known++] = (double)y[k];
    if (known == 0)
        return;
    const float limit = (float)(SPIKE * median(sorted, known));
    for (int k = 0; k < count; k++)
        if (y[k] > limit)
            y[k] = limit;
}

void history_plot(const History* history, LabPanel* panel) {
    panel->count = history->count;
    panel->plot_count = 0;
    for (int k = 0; k < history->count; k++)
        panel->t[k] = (float)history->t[ring_index(history, k)];

    for (int q = 0; q < LAB_PLOTS && history->count > 0; q++) {
        const double now = history_value(history, q, history->count - 1);
        if (!isfinite(now))
            continue;
        LabPlot* plot = &panel->plot[panel->plot_count++];
        plot->label = quantity_table[q].label;
        snprintf(plot->value, sizeof plot->value, "%.4g%s", now, quantity_table[q].unit);
        for (int k = 0; k < history->count; k++)
            plot->y[k] = (float)history_value(history, q, k);
        if (q == HISTORY_COST)
            clip_spikes(plot->y, history->count);
    }
}
