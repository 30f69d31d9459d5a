/// `balloon stability`: the measured stability of each method, cell by cell, compared with theory
/// and with the bound of the guard.
///
/// Each case is measured for every method that accepts its scene (lab/stability/trial.h). Files,
/// each with a header line:
///
///     map.csv        scene,method,step,stiffness,verdict,growth_rate
///     map-limit.csv  scene,method,stiffness,step_theory,step_bound       the lines over the maps
///     stability.csv  scene,method,damping,step_measured,step_theory,step_bound
///     map-SCENE      .gp, .svg, .png
///
/// `stiffness` is the quantity of the map's vertical axis, for rubber the amount of gas. A step of
/// inf means no limit: none in theory, or the longest measured step, 100 times 2/w, was stable. A
/// step of 0 means that no step is stable.
#ifndef BALLOON_LAB_STABILITY_STABILITY_H
#define BALLOON_LAB_STABILITY_STABILITY_H

#include "base/fault.h"

/// Measure all, write the files to the folder and print the table; quick: fewer cells, no fine
/// meshes. Returns false with a fault if that failed or a step below the bound was not stable.
bool stability(const char* folder, bool quick, Fault* fault);

#endif
