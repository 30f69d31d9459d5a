/// Parts of a skin that cannot cross themselves, because they face one way.
///
/// The triangles of a skin are divided into patches. The region of a patch is the patch and all that
/// share a point with it, and the triangles that round off its rim in the rest shape. It is *unfolded* along an axis where all its triangles, projected along that
/// axis, keep their orientation and its rim, seen from a point, always turns to the left, and once
/// around. Such a rim is simple. The number of triangles over a point, each counted by its orientation,
/// is the winding number of the rim around the point, which is 0 or 1: the projection is one-to-one.
/// No two triangles of an unfolded region cross, and a list of a skin with itself need not have their
/// features.
#ifndef BALLOON_CONTACT_SKINS_SKIN_REGIONS_H
#define BALLOON_CONTACT_SKINS_SKIN_REGIONS_H

#include <stdbool.h>

#include "body/body.h"
#include "body/extent.h"

/// How a patch faces.
typedef struct PatchNormal {
    real4 sum;  ///< of the normals of its triangles, twice their areas long [m^2]
    real4 unit; ///< of the same direction
    real
        spread; ///< sine of the largest angle of a triangle's normal with it; 2: 90 degrees or more
} PatchNormal;

typedef struct SkinRegions {
    int count;             ///< patches, and regions; 0: none, the skin is too curved
    int* patch;            ///< [triangles] patch of a triangle
    int *from, *triangle;  ///< those of patch p are triangle[from[p]] … triangle[from[p + 1] - 1]
    int *near_from, *near; ///< patches that patch p shares a point with, in rising order
    int *part_from, *part; ///< patches that region p has triangles of
    int *rim_from, (*rim)[2]; ///< edges of region p's rim, with the region to their left
    int* edge_number;    ///< [3 * triangles] that of an edge at its owner t, 3 t + its first corner
    int* point_owner;    ///< [points] first triangle that has a point
    real4* x;            ///< [points] positions looked at [m]
    PatchNormal* normal; ///< [count] there
    Extent *box, *triangle_box; ///< [count], [triangles] now
    bool* left_out;             ///< [count] region p has been unfolded since the list was made
    bool* failed;    ///< [count] after some drift region p would not have been, since then
    bool any_failed; ///< the list must be made anew
} SkinRegions;

/// None where few regions of the skin would be unfolded as it is now.
void skin_regions_open(SkinRegions* regions, const Body* body);
void skin_regions_close(SkinRegions* regions);

/// Leave out all regions that are unfolded now, except those that failed since the last time.
/// Returns how many those are.
int skin_regions_leave_out(SkinRegions* regions, const Body* body);

/// Whether all regions that are left out are unfolded at the positions regions->x.
bool skin_regions_hold(SkinRegions* regions, const Mesh* mesh);

/// Whether patches p and q are of one region that is left out.
bool skin_regions_cover(const SkinRegions* regions, int p, int q);

/// Boxes of the triangles and patches now.
void skin_regions_fit(SkinRegions* regions, const Body* body);

/// The patches and regions, with the middles of patches so many triangles apart
/// (contact/skins/skin_regions_make.c).
void skin_regions_make(SkinRegions* regions, const Mesh* mesh, int seeds_apart);

#endif
