/// Display modes: a table, one file and one row each. A mode says how skins are painted and what is
/// drawn on them. A balloon that has nothing of what a mode shows is painted as plain rubber.
#ifndef BALLOON_VIEW_MODE_H
#define BALLOON_VIEW_MODE_H

#include "view/picture.h"
#include "world/world.h"

typedef struct Mode {
    const char* name;
    const char* about;
    SkinPaint paint;

    /// Whether a balloon has what is shown; NULL: every balloon has.
    bool (*fits)(const Balloon* balloon);

    /// Measure what is shown as colours, skin->field; NULL: colours are no scale. `range` rounds
    /// the field's least and largest number, over all balloons, to the ends of the scale, and so
    /// that these stay the same for a while.
    void (*measure)(PictureSkin* skin, const Balloon* balloon);
    void (*range)(double* low, double* high);
    const char* unit; ///< of the field, for the legend

    /// Add to a picture that has one balloon's surface already; NULL: nothing more.
    void (*fill)(Picture* picture, PictureSkin* skin, const Balloon* balloon);

    /// Most lines and balls that `fill` adds for a balloon; NULL: none.
    int (*lines)(const Balloon* balloon);
    int (*balls)(const Balloon* balloon);
} Mode;

extern const Mode mode_skin, mode_quads, mode_springs, mode_forces, mode_pressure, mode_stretch,
    mode_thickness, mode_volume_ratio, mode_normals;

/// In the order in which the key walks them.
extern const Mode* const mode_table[];
extern const int mode_count;

/// Row by name, or NULL.
const Mode* mode_find(const char* name);

/// Whether a balloon, or any balloon of the world, has what a mode shows.
bool mode_fits(const Mode* mode, const Balloon* balloon);
bool mode_fits_any(const Mode* mode, const World* world);

/// The next row that fits any balloon of the world, the first after the last.
const Mode* mode_after(const Mode* mode, const World* world);

/// Names of all modes, "skin, quads, …", for sentences.
const char* mode_names(void);

#endif
