/// The lab in the window: what its page shows, measured while it is shown and not otherwise. It
/// looks at the world and never changes it.
#ifndef BALLOON_SHOW_LAB_PAGE_H
#define BALLOON_SHOW_LAB_PAGE_H

#include "lab/stability/map.h"
#include "lab/truth/spherical.h"
#include "show/slider.h"
#include "view/history.h"

typedef struct LabPage {
    Page page;
    History history;
    double since;    ///< when the step that comes now began [ms]
    double spent;    ///< on the steps since the last point [ms]
    int steps;       ///< since the last point
    bool timed;      ///< what a step costs is plotted
    int looked;      ///< balloon that was looked at for a closed form; NONE: none was
    Spherical round; ///< its form, where the page has a curve
    Slider slider;
    Map map; ///< of the scene as it was loaded, whatever cell of it is watched
} LabPage;

/// timed: what a step costs is shown too, and then no two pictures are the same. set: overrides
/// with which the world's scene is loaded, [set_count].
LabPage* lab_page_open(const World* world, const SceneSet* set, int set_count, bool timed);

/// Another world is on: the plots begin again.
void lab_page_begin(LabPage* lab);

/// Steps begin now, which nothing but they will take time from.
void lab_page_start(LabPage* lab, const World* world);

/// After each step. every: steps between two points of a plot; less: time that was not the step's
/// [ms].
void lab_page_step(LabPage* lab, const World* world, long every, double less);

/// Go on with the map for so many parts, and for so long. [ms]
void lab_page_work(LabPage* lab, double parts, double ms);

/// Move the choice on the map; it stays within.
void lab_page_choose(LabPage* lab, int row, int column);

/// What is to be drawn. watched: the world is that of the chosen cell; notch: of the slider's, 1 …,
/// or the scene as it is, 0.
const Page* lab_page_take(LabPage* lab, const World* world, bool watched, int notch);

void lab_page_close(LabPage* lab);

#endif
