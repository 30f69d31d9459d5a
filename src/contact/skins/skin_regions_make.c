/// Dividing a skin into patches and regions.
#include "contact/skins/skin_regions.h"

#include "base/array.h"
#include "mesh/counting_sort.h"
#include "mesh/point_corners.h"

enum { ROUND_OFF_MAX = 30 }; ///< passes

static const double turn_min = 0.3; ///< [1] sine of a rim's edge and the radius, in the rest shape

// ---- patches and regions ----

/// A triangulation, while regions are made.
typedef struct Making {
    SkinRegions* regions;
    const Mesh* mesh;
    int seeds_apart; ///< [triangles] between the middles of patches
    PointCorners corners;
    int* distance; ///< [triangles] to the middle of its patch
    int* queue;    ///< [triangles]
    int* mark;     ///< [patches] the last region that it was added to
    // the region that is being made
    int number, count; ///< of triangles in queue
    int* inside;       ///< [triangles] number of the last region that has it
    int rim_capacity, part_capacity;
} Making;

/// Give patch p the triangles that are nearer to triangle `seed` than to the middles of other patches.
static void grow(const Making* making, int seed, int p) {
    const Mesh* mesh = making->mesh;
    int first = 0, count = 0;
    making->queue[count++] = seed;
    making->distance[seed] = 0;
    making->regions->patch[seed] = p;
    while (first < count) {
        const int t = making->queue[first++], next = making->distance[t] + 1;
        for (int k = 0; k < 3; k++) {
            const int i = mesh->triangle[t][k];
            for (int c = making->corners.from[i]; c < making->corners.from[i + 1]; c++) {
                const int other = making->corners.corner[c] / 3;
                if (making->distance[other] <= next)
                    continue;
                making->distance[other] = next;
                making->regions->patch[other] = p;
                making->queue[count++] = other;
            }
        }
    }
}

static void make_patches(const Making* making) {
    SkinRegions* regions = making->regions;
    const int triangles = making->mesh->triangle_count;
    for (int t = 0; t < triangles; t++)
        making->distance[t] = triangles;
    for (int t = 0; t < triangles; t++)
        if (making->distance[t] >= making->seeds_apart)
            grow(making, t, regions->count++);
    regions->from = new_array(int, regions->count + 1);
    regions->triangle = new_array(int, triangles);
    counting_sort(regions->patch, triangles, regions->count, regions->from, regions->triangle);
}

static int compare(const void* a, const void* b) {
    return *(const int*)a - *(const int*)b;
}

/// The patches that share a point with each.
static void make_near(Making* making) {
    SkinRegions* regions = making->regions;
    int count = 0, capacity = 0;
    regions->near_from = new_array(int, regions->count + 1);
    making->mark = new_array(int, regions->count);
    for (int p = 0; p < regions->count; p++) {
        for (int j = regions->from[p]; j < regions->from[p + 1]; j++)
            for (int k = 0; k < 3; k++) {
                const int i = making->mesh->triangle[regions->triangle[j]][k];
                for (int c = making->corners.from[i]; c < making->corners.from[i + 1]; c++) {
                    const int q = regions->patch[making->corners.corner[c] / 3];
                    if (making->mark[q] == p + 1)
                        continue;
                    making->mark[q] = p + 1;
                    array_reserve(regions->near, count, capacity);
                    regions->near[count++] = q;
                }
            }
        regions->near_from[p + 1] = count;
        qsort(regions->near + regions->near_from[p], (size_t)(count - regions->near_from[p]),
              sizeof(int), compare);
    }
}

/// The other triangle at the edge from corner k, or NONE.
static int across(const Making* making, int t, int k) {
    const Mesh* mesh = making->mesh;
    const int a = mesh->triangle[t][k], b = mesh->triangle[t][(k + 1) % 3];
    for (int c = making->corners.from[a]; c < making->corners.from[a + 1]; c++) {
        const int other = making->corners.corner[c] / 3;
        if (other != t && triangle_has(mesh->triangle[other], b))
            return other;
    }
    return NONE;
}

/// Whether triangle `other`, or NONE, is in the region that is being made.
static bool is_inside(const Making* making, int other) {
    return other != NONE && making->inside[other] == making->number;
}

static void add_triangle(Making* making, int t) {
    making->inside[t] = making->number;
    making->queue[making->count++] = t;
}

/// An edge of the rim: from corner k of triangle t.
typedef void RimVisit(Making* making, int t, int k, void* self);

static void each_rim_edge(Making* making, RimVisit* visit, void* self) {
    const int count = making->count; // `visit` may add triangles
    for (int j = 0; j < count; j++)
        for (int k = 0; k < 3; k++)
            if (!is_inside(making, across(making, making->queue[j], k)))
                visit(making, making->queue[j], k, self);
}

/// How the region lies in the rest shape.
typedef struct Lie {
    double4 axis, middle;
    int rim; ///< edges
} Lie;

static void add_middle(Making* making, int t, int k, void* self) {
    Lie* lie = self;
    lie->middle += making->mesh->point[making->mesh->triangle[t][k]];
    lie->rim++;
}

/// Add the triangle beyond an edge that turns too little to the left.
static void round_off(Making* making, int t, int k, void* self) {
    const Lie* lie = self;
    const int* corner = making->mesh->triangle[t];
    const double4 a = making->mesh->point[corner[k]] - lie->middle,
                  e = making->mesh->point[corner[(k + 1) % 3]] - lie->middle - a;
    const int other = across(making, t, k);
    if (other != NONE && !is_inside(making, other) &&
        ddot(dcross(a, e), lie->axis) < turn_min * dlength(a) * dlength(e))
        add_triangle(making, other);
}

static Lie lie_of(Making* making) {
    Lie lie = {{0}, {0}, 0};
    for (int j = 0; j < making->count; j++) {
        const int* corner = making->mesh->triangle[making->queue[j]];
        const double4* x = making->mesh->point;
        lie.axis += dcross(x[corner[1]] - x[corner[0]], x[corner[2]] - x[corner[0]]);
    }
    lie.axis /= fmax(dlength(lie.axis), 1e-300);
    each_rim_edge(making, add_middle, &lie);
    lie.middle /= fmax(lie.rim, 1);
    return lie;
}

static void add_rim_edge(Making* making, int t, int k, void* self) {
    SkinRegions* regions = making->regions;
    int* count = self;
    array_reserve(regions->rim, *count, making->rim_capacity);
    regions->rim[*count][0] = making->mesh->triangle[t][k];
    regions->rim[(*count)++][1] = making->mesh->triangle[t][(k + 1) % 3];
}

/// The region of a patch: those near it, rounded off.
static void make_region(Making* making, int p) {
    SkinRegions* regions = making->regions;
    making->number = p + 1;
    making->count = 0;
    for (int n = regions->near_from[p]; n < regions->near_from[p + 1]; n++)
        for (int j = regions->from[regions->near[n]]; j < regions->from[regions->near[n] + 1]; j++)
            add_triangle(making, regions->triangle[j]);
    for (int pass = 0, before = 0; pass < ROUND_OFF_MAX && making->count > before; pass++) {
        before = making->count;
        Lie lie = lie_of(making);
        each_rim_edge(making, round_off, &lie);
    }
    regions->rim_from[p + 1] = regions->rim_from[p];
    each_rim_edge(making, add_rim_edge, &regions->rim_from[p + 1]);
    int count = regions->part_from[p];
    for (int j = 0; j < making->count; j++) {
        const int q = regions->patch[making->queue[j]];
        if (making->mark[q] == -p - 1)
            continue;
        making->mark[q] = -p - 1;
        array_reserve(regions->part, count, making->part_capacity);
        regions->part[count++] = q;
    }
    regions->part_from[p + 1] = count;
}

static void make_regions(Making* making) {
    SkinRegions* regions = making->regions;
    regions->rim_from = new_array(int, regions->count + 1);
    regions->part_from = new_array(int, regions->count + 1);
    making->inside = new_array(int, making->mesh->triangle_count);
    for (int p = 0; p < regions->count; p++)
        make_region(making, p);
}

/// A point or edge belongs to the first triangle that has it (contact/shared_feature.h).
static void number_features(const Making* making) {
    const Mesh* mesh = making->mesh;
    for (int t = mesh->triangle_count - 1; t >= 0; t--)
        for (int k = 0; k < 3; k++) {
            making->regions->point_owner[mesh->triangle[t][k]] = t;
            const int other = across(making, t, k);
            int number = 3 * t + k;
            for (int j = 0; other != NONE && other < t && j < 3; j++)
                if (mesh->triangle[other][(j + 1) % 3] == mesh->triangle[t][k] &&
                    mesh->triangle[other][j] == mesh->triangle[t][(k + 1) % 3])
                    number = 3 * other + j;
            making->regions->edge_number[3 * t + k] = number;
        }
}

void skin_regions_make(SkinRegions* regions, const Mesh* mesh, int seeds_apart) {
    const int triangles = mesh->triangle_count;
    *regions = (SkinRegions){.patch = new_array(int, triangles),
                             .edge_number = new_array(int, 3 * triangles),
                             .point_owner = new_array(int, mesh->point_count),
                             .x = new_array(real4, mesh->point_count),
                             .triangle_box = new_array(Extent, triangles)};
    Making making = {.regions = regions,
                     .mesh = mesh,
                     .seeds_apart = seeds_apart,
                     .corners = point_corners_open(mesh),
                     .distance = new_array(int, triangles),
                     .queue = new_array(int, triangles)};
    make_patches(&making);
    make_near(&making);
    make_regions(&making);
    number_features(&making);
    regions->normal = new_array(PatchNormal, regions->count);
    regions->box = new_array(Extent, regions->count);
    regions->left_out = new_array(bool, regions->count);
    regions->failed = new_array(bool, regions->count);
    point_corners_close(&making.corners);
    free(making.distance);
    free(making.queue);
    free(making.mark);
    free(making.inside);
}
