/// Display modes: a table, one file and one row each. A mode says how skins are painted and what is
/// drawn on them.
#ifndef BALLOON_VIEW_MODE_H
#define BALLOON_VIEW_MODE_H

#include "view/picture.h"
#include "world/world.h"

typedef struct Mode {
    const char* name;
    const char* about;
    SkinPaint paint;

    /// Add to a picture that has one balloon's surface already; NULL: nothing more.
    void (*fill)(Picture* picture, PictureSkin* skin, const Balloon* balloon);

    /// Most lines and balls that `fill` adds for a balloon; NULL: none.
    int (*lines)(const Balloon* balloon);
    int (*balls)(const Balloon* balloon);
} Mode;

extern const Mode mode_skin, mode_quads, mode_springs, mode_forces, mode_stretch, mode_normals;

/// In the order in which the key walks them.
extern const Mode* const mode_table[];
extern const int mode_count;

/// Row by name, or NULL.
const Mode* mode_find(const char* name);

/// The row after this one, the first after the last.
const Mode* mode_after(const Mode* mode);

/// Names of all modes, "skin, quads, …", for sentences.
const char* mode_names(void);

/// Upper end of the stretch mode's colours: the largest stretch in the picture, rounded up to a
/// value that stays the same for a while. The lower end is 1.
float mode_stretch_top(const Picture* picture);

#endif
