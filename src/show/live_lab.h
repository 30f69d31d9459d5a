/// The lab in the window: what its panel shows, measured while it is shown and not otherwise. It
/// looks at the world and never changes it.
#ifndef BALLOON_SHOW_LIVE_LAB_H
#define BALLOON_SHOW_LIVE_LAB_H

#include "lab/stability/map.h"
#include "lab/truth/spherical.h"
#include "show/slider.h"
#include "view/history.h"

typedef struct LiveLab {
    LabPanel panel;
    History history;
    double step_start;  ///< when the step that comes now began [ms]
    double point_ms;    ///< on the steps since the last point [ms]
    int point_steps;    ///< since the last point
    bool timed;         ///< what a step costs is plotted
    int sphere_balloon; ///< balloon that was looked at for a closed form; NONE: none was
    Spherical sphere;   ///< its form, where the panel has a curve
    Slider slider;
    Map map; ///< of the scene as it was loaded, whatever cell of it is watched
} LiveLab;

/// timed: what a step costs is shown too, and then no two pictures are the same. set: overrides
/// with which the world's scene is loaded, [set_count].
LiveLab* live_lab_open(const World* world, const SceneSet* set, int set_count, bool timed);

/// Another world is on: the plots begin again.
void live_lab_begin(LiveLab* lab);

/// Steps begin now, which nothing but they will take time from.
void live_lab_start(LiveLab* lab, const World* world);

/// After each step. interval: steps between two points of a plot; excluded_ms: time that was not the step's
/// [ms].
void live_lab_step(LiveLab* lab, const World* world, long interval, double excluded_ms);

/// Go on with the map for so many parts, and for so long. [ms]
void live_lab_work(LiveLab* lab, double parts, double ms);

/// Move the choice on the map; it stays within.
void live_lab_choose(LiveLab* lab, int row, int column);

/// What is to be drawn. watched: the world is that of the chosen cell; notch: of the slider's, 1 …,
/// or the scene as it is, 0.
const LabPanel* live_lab_update(LiveLab* lab, const World* world, bool watched, int notch);

void live_lab_close(LiveLab* lab);

#endif
