/// From fast to accurate: the ways of stepping a scene that were measured on this machine
/// (lab/advice/advise.h) as the notches of a slider, what was expected of the present one, and what it
/// turns out to cost and to be off.
#ifndef BALLOON_SHOW_SLIDER_H
#define BALLOON_SHOW_SLIDER_H

#include "lab/advice/advise.h"
#include "view/lab_panel.h"

typedef struct Slider {
    Advice advice;
    const AdvicePoint** front; ///< [notches] from the cheapest to the closest, of this precision
    int notches;               ///< 0: nothing is measured of this scene
    double error;              ///< of the outputs whose time has come; NAN: none [1]
    double spent;              ///< on the steps so far [ms]
} Slider;

/// What the cache has of the world's scene; set: its overrides, [set_count].
void slider_open(Slider* slider, const World* world, const SceneSet* set, int set_count);

/// Another world is on.
void slider_begin(Slider* slider);

/// After each step, which took so long. [ms]
void slider_step(Slider* slider, const World* world, double ms);

/// What makes the scene, as it was begun, that of a notch, 1 … notches.
void slider_sets(const Slider* slider, const World* begun, int notch, Overrides* sets);

/// notch: the present one, 0: none. timed: what a frame costs is said.
void slider_fill(const Slider* slider, const World* world, int notch, bool timed, LabSlider* panel);

void slider_close(Slider* slider);

#endif
