/// The recent history of a balloon: a few outputs over the last seconds, for the plots of the lab
/// panel.
///
/// A ring of the last LAB_POINTS points. The caller chooses the interval between points in steps;
/// 60 points for each second of screen time make a history of 5 s. A reset of the world or the
/// selection of another balloon clears the ring.
#ifndef BALLOON_VIEW_HISTORY_H
#define BALLOON_VIEW_HISTORY_H

#include "view/lab_panel.h"
#include "world/world.h"

/// The quantities: columns of the CSV (world/probe.h), and the wall time of a step.
enum { HISTORY_VOLUME, HISTORY_PRESSURE, HISTORY_ENERGY, HISTORY_COST };

typedef struct History {
    int balloon;
    long last_step; ///< step of the last point; < 0: there is no point yet
    int next;       ///< index of the next point in the ring
    int count;
    double t[LAB_POINTS];                ///< [s]
    double value[LAB_PLOTS][LAB_POINTS]; ///< NAN where the balloon has no such column
} History;

/// The selected balloon, or the first if all are selected.
int history_balloon(const World* world);

void history_begin(History* history);

/// Whether a point is due after this step. interval: steps between points.
bool history_due(const History* history, const World* world, long interval);

/// Append a point. step_ms: wall time of a step [ms]; NAN: not measured.
void history_add(History* history, const World* world, double step_ms);

/// The value of a quantity at the k-th point from the oldest.
double history_value(const History* history, int quantity, int k);

/// Fill the panel's plots. A quantity without a present value has no plot; step costs far above
/// the median are clipped.
void history_plot(const History* history, LabPanel* panel);

#endif
