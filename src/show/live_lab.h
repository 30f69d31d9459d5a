/// The data of the lab panel, measured while the panel is visible. It reads the world and never
/// changes it.
#ifndef BALLOON_SHOW_LIVE_LAB_H
#define BALLOON_SHOW_LIVE_LAB_H

#include "lab/stability/map.h"
#include "lab/truth/spherical.h"
#include "show/slider.h"
#include "view/history.h"

typedef struct LiveLab {
    LabPanel panel;
    History history;
    double step_start;  ///< wall time at which the present step began [ms]
    double point_ms;    ///< wall time of the steps since the last point of a plot [ms]
    int point_steps;    ///< number of these steps
    bool timed;         ///< the cost of a step is plotted
    int sphere_balloon; ///< balloon that was tested for a closed form; NONE: none yet
    Spherical sphere;   ///< its closed form, if the panel has a curve
    Slider slider;
    Map map; ///< of the scene with its own settings, whichever cell is watched
} LiveLab;

/// timed: plot the cost of a step, so that pictures depend on the machine. set: [set_count] overrides
/// with which the world's scene was loaded.
LiveLab* live_lab_open(const World* world, const SceneSet* set, int set_count, bool timed);

/// Clear the plots, for another world.
void live_lab_begin(LiveLab* lab);

/// Call before the first step of a frame: the time of a step counts from here.
void live_lab_start(LiveLab* lab, const World* world);

/// Call after each step. interval: steps between two points of a plot; excluded_ms: wall time since
/// the last call that the step did not use [ms].
void live_lab_step(LiveLab* lab, const World* world, long interval, double excluded_ms);

/// Continue measuring the map for at most `parts` calls of map_work and `ms` of wall time.
void live_lab_work(LiveLab* lab, double parts, double ms);

/// Choose a cell of the map; a row or column outside the map is ignored.
void live_lab_choose(LiveLab* lab, int row, int column);

/// The panel to be drawn. watched: the world has the settings of the chosen cell; notch: of the
/// slider, 1 …, or 0 for the scene's own settings.
const LabPanel* live_lab_update(LiveLab* lab, const World* world, bool watched, int notch);

void live_lab_close(LiveLab* lab);

#endif
