/// The slider from fast to accurate. Its notches are the settings (method, step, mesh) of the scene
/// that `balloon advise` has measured on this machine (lab/advice/advise.h). For the present notch it
/// lists the expected error and cost, and those measured now.
#ifndef BALLOON_SHOW_SLIDER_H
#define BALLOON_SHOW_SLIDER_H

#include "lab/advice/advise.h"
#include "view/lab_panel.h"

typedef struct Slider {
    Advice advice;
    const AdvicePoint**
        front;    ///< [notches] from the cheapest to the most accurate, of this precision
    int notches;  ///< 0: nothing is measured of this scene
    double error; ///< maximum relative error of the outputs so far; NAN: none yet [1]
    double spent; ///< wall time of the steps so far [ms]
} Slider;

/// Read the cached measurements of the world's scene. set: [set_count] its overrides.
void slider_open(Slider* slider, const World* world, const SceneSet* set, int set_count);

/// Reset error and time, for another world.
void slider_begin(Slider* slider);

/// Call after each step. ms: its wall time.
void slider_step(Slider* slider, const World* world, double ms);

/// The overrides that give the scene the settings of a notch, 1 … notches. original: the world with
/// the scene's own settings.
void slider_sets(const Slider* slider, const World* original, int notch, Overrides* sets);

/// Fill the panel's slider. notch: the present one, 0: none. timed: print the cost of a frame.
void slider_fill(const Slider* slider, const World* world, int notch, bool timed, LabSlider* panel);

void slider_close(Slider* slider);

#endif
