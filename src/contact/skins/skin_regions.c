#include "contact/skins/skin_regions.h"

#include <stdlib.h>
#include <string.h>

enum { SEEDS_APART = 3 }; ///< [triangles] between the middles of patches

/// [1] of all regions that are unfolded at the start. Where a skin is more curved, a list of all its
/// features costs less than looking at smaller regions in each drift.
static const double unfolded_share = 0.9;

/// [1] a region is left out while normals keep this sine of an angle from 90 degrees, and begins to be
/// where they keep more
static const real tilt_min = (real)0.02, tilt_min_first = (real)0.2;

static const real sliver =
    (real)1e-6; ///< [1] sine squared of the angles of a sure normal, at least
static const real sure_area = (real)1e-4; ///< [squared radii] area that is surely greater than 0

// ---- whether regions are unfolded ----

/// Unit normals of the triangles of a patch, their sum's direction, and how far they are from it.
static PatchNormal patch_normal(const SkinRegions* regions, const Mesh* mesh, int p) {
    PatchNormal normal = {{0, 0, 0, 0}, {0, 0, 0, 0}, 2};
    for (int j = regions->from[p]; j < regions->from[p + 1]; j++) {
        const int* corner = mesh->triangle[regions->triangle[j]];
        const real4 a = regions->x[corner[0]];
        normal.sum += cross(regions->x[corner[1]] - a, regions->x[corner[2]] - a);
    }
    const real size = length(normal.sum);
    if (!(size > 0))
        return normal;
    normal.unit = normal.sum / size;
    real least = 1;
    for (int j = regions->from[p]; j < regions->from[p + 1]; j++) {
        const int* corner = mesh->triangle[regions->triangle[j]];
        const real4 a = regions->x[corner[0]], ab = regions->x[corner[1]] - a,
                    ac = regions->x[corner[2]] - a, n = cross(ab, ac);
        const real n2 = dot(n, n);
        if (!(n2 > sliver * dot(ab, ab) * dot(ac, ac)))
            return normal;
        least = real_min(least, dot(n, normal.unit) / real_sqrt(n2));
    }
    if (least > 0)
        normal.spread = real_sqrt(real_max(0, 1 - least * least));
    return normal;
}

/// Whether the rim, seen along the axis from its middle, turns to the left, once around.
static bool rim_is_simple(const SkinRegions* regions, int p, real4 axis) {
    const int from = regions->rim_from[p], to = regions->rim_from[p + 1];
    real4 middle = {0, 0, 0, 0};
    for (int j = from; j < to; j++)
        middle += regions->x[regions->rim[j][0]];
    middle /= (real)(to - from);
    const int small = axis[0] * axis[0] < axis[1] * axis[1] ? 0 : 1;
    real4 side = {0, 0, 0, 0};
    side[small] = 1;
    side = cross(axis, side); // across the axis: each turn comes once from its negative side
    int turns = 0;
    for (int j = from; j < to; j++) {
        const real4 a = regions->x[regions->rim[j][0]] - middle,
                    b = regions->x[regions->rim[j][1]] - middle;
        if (!(dot(cross(a, b), axis) > sure_area * (dot(a, a) + dot(b, b))))
            return false;
        turns += dot(a, side) < 0 && dot(b, side) >= 0;
    }
    return turns == 1;
}

static bool is_unfolded(const SkinRegions* regions, int p, real tilt) {
    real4 axis = {0, 0, 0, 0};
    for (int n = regions->part_from[p]; n < regions->part_from[p + 1]; n++)
        axis += regions->normal[regions->part[n]].sum;
    const real size = length(axis);
    if (!(size > 0))
        return false;
    axis /= size;
    for (int n = regions->part_from[p]; n < regions->part_from[p + 1]; n++) {
        const PatchNormal* normal = &regions->normal[regions->part[n]];
        if (!(dot(normal->unit, axis) > normal->spread + tilt))
            return false;
    }
    return rim_is_simple(regions, p, axis);
}

/// The patches' normals at regions->x.
static void measure(SkinRegions* regions, const Mesh* mesh) {
    for (int p = 0; p < regions->count; p++)
        regions->normal[p] = patch_normal(regions, mesh, p);
}

int skin_regions_leave_out(SkinRegions* regions, const Body* body) {
    int count = 0;
    memcpy(regions->x, body->x, (size_t)body->count * sizeof *body->x);
    measure(regions, body->mesh);
    for (int p = 0; p < regions->count; p++) {
        regions->left_out[p] = !regions->failed[p] && is_unfolded(regions, p, tilt_min_first);
        regions->failed[p] = false;
        count += regions->left_out[p];
    }
    regions->any_failed = false;
    return count;
}

bool skin_regions_hold(SkinRegions* regions, const Mesh* mesh) {
    bool hold = true;
    measure(regions, mesh);
    for (int p = 0; p < regions->count; p++)
        if (regions->left_out[p] && !is_unfolded(regions, p, tilt_min)) {
            regions->failed[p] = regions->any_failed = true;
            hold = false;
        }
    return hold;
}

// ---- the start ----

void skin_regions_open(SkinRegions* regions, const Body* body) {
    skin_regions_make(regions, body->mesh, SEEDS_APART);
    if (skin_regions_leave_out(regions, body) < unfolded_share * regions->count)
        skin_regions_close(regions);
}

// ---- what a search needs ----

/// Whether patches p and q share a point.
static bool in_region(const SkinRegions* regions, int p, int q) {
    for (int j = regions->near_from[p]; j < regions->near_from[p + 1]; j++)
        if (regions->near[j] == q)
            return true;
    return false;
}

bool skin_regions_cover(const SkinRegions* regions, int p, int q) {
    for (int n = regions->near_from[p]; n < regions->near_from[p + 1]; n++)
        if (regions->left_out[regions->near[n]] && in_region(regions, regions->near[n], q))
            return true;
    return false;
}

static void widen(Extent* extent, real4 a) {
    for (int k = 0; k < 3; k++) {
        extent->low[k] = a[k] < extent->low[k] ? a[k] : extent->low[k];
        extent->high[k] = a[k] > extent->high[k] ? a[k] : extent->high[k];
    }
}

void skin_regions_fit(SkinRegions* regions, const Body* body) {
    for (int p = 0; p < regions->count; p++)
        for (int j = regions->from[p]; j < regions->from[p + 1]; j++) {
            const int t = regions->triangle[j], *corner = body->mesh->triangle[t];
            Extent* box = &regions->triangle_box[t];
            *box = (Extent){body->x[corner[0]], body->x[corner[0]]};
            widen(box, body->x[corner[1]]);
            widen(box, body->x[corner[2]]);
            if (j == regions->from[p])
                regions->box[p] = *box;
            widen(&regions->box[p], box->low);
            widen(&regions->box[p], box->high);
        }
}

void skin_regions_close(SkinRegions* regions) {
    free(regions->patch);
    free(regions->from);
    free(regions->triangle);
    free(regions->near_from);
    free(regions->near);
    free(regions->part_from);
    free(regions->part);
    free(regions->rim_from);
    free(regions->rim);
    free(regions->edge_number);
    free(regions->point_owner);
    free(regions->x);
    free(regions->normal);
    free(regions->box);
    free(regions->triangle_box);
    free(regions->left_out);
    free(regions->failed);
    *regions = (SkinRegions){0};
}
