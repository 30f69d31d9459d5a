/// `balloon needs SCENE`: which parts of a model the scene's outputs need.
///
/// Each part of lab/advice/needs_part.h that the scene has is removed or replaced by a simpler
/// model, and the program runs the scene again. The outputs of the scene's list `about` are
/// compared:
///
///     change = |value without the part - value| / (tolerance |value|)             [tolerances]
///
/// A part is unneeded if every change is below 1. It is needed if a change is 1 or more, or if the
/// run without it is refused, fails or lacks an output. A longer step is untried if the guard
/// splits it into the scene's own. The CPU time is printed and does not affect the verdict. The
/// scene's key `because` lists the parts that it keeps for another reason.
#ifndef BALLOON_LAB_ADVICE_NEEDS_H
#define BALLOON_LAB_ADVICE_NEEDS_H

#include "scene/scene.h"

typedef struct NeedsOptions {
    const char* scene; ///< NULL: all shipped scenes that name outputs
    const char* out;   ///< folder for needs.csv, or NULL
    const SceneSet* set;
    int set_count;
    bool quick; ///< one run of each; else times are the minimum of three runs
} NeedsOptions;

/// Print the tables. False with a fault that names the unneeded parts without a reason in
/// `because`, or if the scene names no outputs.
bool needs_run(const NeedsOptions* options, Fault* fault);

/// Print the outputs of each shipped scene, or why it names none.
void needs_list(void);

#endif
