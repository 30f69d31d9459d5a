/// `balloon stability`: where each method fails, measured cell by cell, and how far that is from
/// theory and from the bound that the program holds its steps against.
///
/// Every row of the method table that takes a case's scene is tried on it (lab/stability/trial.h). Files,
/// with a line of names each:
///
///     map.csv        scene,method,step,stiffness,verdict,growth_rate
///     map-limit.csv  scene,method,stiffness,step_theory,step_bound       the lines over the maps
///     stability.csv  scene,method,damping,step_measured,step_theory,step_bound
///     map-SCENE      .gp, .svg, .png
///
/// `stiffness` is what the map's upright axis varies, for rubber the amount of gas. A step of inf
/// is one that no step was found above: theory knows no limit, or the longest step tried, 100 times
/// 2/w, was stable. 0 is a method that no step is short enough for.
#ifndef BALLOON_LAB_STABILITY_STABILITY_H
#define BALLOON_LAB_STABILITY_STABILITY_H

#include "base/fault.h"

/// Measure all into the folder and print the table; `quick` takes fewer cells and no fine meshes.
/// False where it could not be done, or where a step below the bound was not stable.
bool stability(const char* folder, bool quick, Fault* fault);

#endif
