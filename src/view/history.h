/// What a balloon did lately: numbers over the last few seconds, for the plots of the lab's panel.
///
/// A point is kept every 1/rate of a second that passes on the screen, the last LAB_POINTS of
/// them: 5 s at 60 a second, and less of the world's time in slow motion. A reset and another
/// balloon begin it again.
#ifndef BALLOON_VIEW_HISTORY_H
#define BALLOON_VIEW_HISTORY_H

#include "view/lab_panel.h"
#include "world/world.h"

/// What is kept: columns of the CSV (world/probe.h), and what a step cost.
enum { HISTORY_VOLUME, HISTORY_PRESSURE, HISTORY_ENERGY, HISTORY_COST };

typedef struct History {
    int balloon;
    long last; ///< step of the last point; before the first: less than 0
    int next;  ///< place of the next point in the ring
    int count;
    double t[LAB_POINTS];                ///< [s]
    double value[LAB_PLOTS][LAB_POINTS]; ///< NAN where the balloon has no such column
} History;

/// The balloon that keys act on, or the first where they act on all.
int history_balloon(const World* world);

void history_begin(History* history);

/// Whether a point is due after this step. every: steps from one to the next.
bool history_due(const History* history, const World* world, long interval);

/// Keep a point. ms: what a step cost; NAN: nobody has measured it.
void history_add(History* history, const World* world, double ms);

/// A value of the k-th point from the oldest.
double history_value(const History* history, int quantity, int k);

/// The plots of what there is; what no point has is left out, and costs far above the rest are cut.
void history_plot(const History* history, LabPanel* panel);

#endif
