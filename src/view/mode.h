/// Display modes: a table, one file and one row each. A mode defines how skins are painted and
/// which lines and balls are drawn on them. A balloon that lacks what a mode displays is painted
/// as plain rubber.
#ifndef BALLOON_VIEW_MODE_H
#define BALLOON_VIEW_MODE_H

#include "view/picture.h"
#include "world/world.h"

typedef struct Mode {
    const char* name;
    const char* about;
    SkinPaint paint;

    /// Whether a balloon has the quantity that the mode displays; NULL: every balloon has.
    bool (*fits)(const Balloon* balloon);

    /// Measure skin->field, which is drawn as colors on a scale; NULL: the mode has no scale.
    /// `range` rounds the minimum and maximum of the field over all balloons to the ends of the
    /// scale, coarsely enough that these change seldom.
    void (*measure)(PictureSkin* skin, const Balloon* balloon);
    void (*range)(double* low, double* high);
    const char* unit; ///< of the field, for the legend

    /// Add lines and balls for one balloon, whose surface the picture has already; NULL: none.
    void (*fill)(Picture* picture, PictureSkin* skin, const Balloon* balloon);

    /// The maximum number of lines and balls that `fill` adds for a balloon; NULL: none.
    int (*lines)(const Balloon* balloon);
    int (*balls)(const Balloon* balloon);
} Mode;

extern const Mode mode_skin, mode_quads, mode_springs, mode_forces, mode_pressure, mode_stretch,
    mode_thickness, mode_volume_ratio, mode_normals;

/// In the order of the mode key.
extern const Mode* const mode_table[];
extern const int mode_count;

/// Row by name, or NULL.
const Mode* mode_find(const char* name);

/// Whether a balloon, or any balloon of the world, has what a mode displays.
bool mode_fits(const Mode* mode, const Balloon* balloon);
bool mode_fits_any(const Mode* mode, const World* world);

/// The next row that fits any balloon of the world; after the last row comes the first.
const Mode* mode_after(const Mode* mode, const World* world);

/// Names of all modes, "skin, quads, …", for sentences.
const char* mode_names(void);

#endif
