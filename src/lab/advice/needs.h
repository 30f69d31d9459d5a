/// `balloon needs SCENE`: what the scene could do without.
///
/// Each part of lab/advice/needs_part.h that the scene models is taken out, or the next simpler thing put
/// in its place, and the scene is run again, by the program itself. What that changes is held
/// against the outputs that the scene is about:
///
///     change = |value without - value| / (tolerance |value|)                      [tolerances]
///
/// A part is unneeded where no output changes by a tolerance or more; the CPU time that is left
/// without it is told, and decides nothing. A run that is refused, goes bad, or has no such output
/// says that the part is needed. A longer step that the guard splits into the scene's own was not
/// tried, and says nothing.
/// The scene's `because:` names the parts that stay for another reason.
#ifndef BALLOON_LAB_ADVICE_NEEDS_H
#define BALLOON_LAB_ADVICE_NEEDS_H

#include "scene/scene.h"

typedef struct NeedsOptions {
    const char* scene; ///< NULL: all shipped ones that are about something
    const char* out;   ///< folder for needs.csv, or NULL
    const SceneSet* set;
    int set_count;
    bool quick; ///< one run of each; else the times are the least of three
} NeedsOptions;

/// Print the tables. False, with a sentence that names the parts, where a scene models what it does
/// not need and gives no reason; and where it is about none.
bool needs_run(const NeedsOptions* options, Fault* fault);

/// Print what each shipped scene is about, or why it is about none.
void needs_list(void);

#endif
