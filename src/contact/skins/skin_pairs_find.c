/// Finding the pairs of features for a list, and the triangles that cross.
#include <stdlib.h>

#include "base/array.h"
#include "contact/contacts.h"
#include "contact/skins/crossings.h"
#include "mesh/point_corners.h"

static const double local_share = 0.5; ///< [rest distances] rest gap of two of one skin

// ---- triangles that cross ----

bool skin_pairs_cross(Contacts* contacts, int a, int b) {
    const int(*near)[2];
    const int count =
        bullet_skin_near_triangles(contacts->skin[a].patches, contacts->skin[b].patches, 0, &near);
    for (int k = 0; k < count; k++)
        if (crossing_of(contacts->skin[a].body, near[k][0], contacts->skin[b].body, near[k][1]))
            return true;
    return false;
}

// ---- features ----

/// A search under way.
typedef struct Search {
    Contacts* contacts;
    PairList* list;
    double gap;         ///< rest gap of the two skins [m]
    double reach;       ///< [m]
    real rounded_reach; ///< a little more, so that differences of coordinates may be rounded [m]
} Search;

/// Distance that the two have in the skin's rest shape: neighbours may be nearer than a rest gap.
static double rest_distance(const Body* body, const FeaturePair* pair) {
    double4 x[FEATURE_NODES];
    double weight[FEATURE_NODES];
    for (int k = 0; k < FEATURE_NODES; k++)
        x[k] = body->scale * body->mesh->point[pair->node[k]];
    return feature_distance(pair->kind, x, weight);
}

/// Positions of the nodes, as they are stored.
static void positions(const Contacts* contacts, const FeaturePair* pair, real4 x[FEATURE_NODES]) {
    for (int k = 0; k < FEATURE_NODES; k++)
        x[k] = contacts->skin[feature_pair_skin(pair, k)].body->x[pair->node[k]];
}

/// Whether the boxes of the two sides are farther apart than the reach along an axis.
static bool boxes_apart(FeatureKind kind, const real4 x[FEATURE_NODES], real reach) {
    const bool vertex = kind == VERTEX_TRIANGLE;
    for (int axis = 0; axis < 3; axis++) {
        const real p = x[0][axis], q = x[1][axis], r = x[2][axis], s = x[3][axis];
        const real first = vertex ? p : q, second = vertex ? q : r; // a corner of each side
        if (real_max(p, first) < real_min(real_min(second, r), s) - reach ||
            real_min(p, first) > real_max(real_max(second, r), s) + reach)
            return true;
    }
    return false;
}

static void add(Search* search, FeaturePair* candidate) {
    Contacts* contacts = search->contacts;
    real4 stored[FEATURE_NODES];
    positions(contacts, candidate, stored);
    if (boxes_apart(candidate->kind, stored, search->rounded_reach))
        return;
    double4 x[FEATURE_NODES];
    for (int k = 0; k < FEATURE_NODES; k++)
        x[k] = to_double4(stored[k]);
    candidate->distance = feature_distance(candidate->kind, x, candidate->weight);
    if (!(candidate->distance <= search->reach))
        return;
    candidate->measured = NONE;
    candidate->rest_gap = search->gap;
    if (candidate->skin[0] == candidate->skin[1])
        candidate->rest_gap =
            fmin(search->gap,
                 local_share * rest_distance(contacts->skin[candidate->skin[0]].body, candidate));
    PairList* list = search->list;
    array_reserve(list->pair, list->count, list->capacity);
    list->pair[list->count++] = *candidate;
}

// ---- features of two skins, or of one without regions ----

/// Each vertex that belongs to the first triangle, and the second triangle.
static void add_vertices(Search* search, int a, int t, int b, int u) {
    const ContactSkin* skin = search->contacts->skin;
    const int *vertex = skin[a].body->mesh->triangle[t], *corner = skin[b].body->mesh->triangle[u];
    for (int k = 0; k < 3; k++)
        if ((skin[a].owners[t] >> k & 1) && !(a == b && triangle_has(corner, vertex[k])))
            add(search, &(FeaturePair){.kind = VERTEX_TRIANGLE,
                                       .skin = {a, b},
                                       .node = {vertex[k], corner[0], corner[1], corner[2]},
                                       .feature = (int64_t)vertex[k] << 32 | u});
}

/// Each edge that belongs to the first triangle and each one of the second.
static void add_edges(Search* search, int a, int t, int b, int u) {
    const ContactSkin* skin = search->contacts->skin;
    const int *first = skin[a].body->mesh->triangle[t], *second = skin[b].body->mesh->triangle[u];
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++) {
            const int p = first[j], q = first[(j + 1) % 3], r = second[k], s = second[(k + 1) % 3];
            if (!(skin[a].owners[t] >> (3 + j) & 1) || !(skin[b].owners[u] >> (3 + k) & 1) ||
                (a == b && (p == r || p == s || q == r || q == s)))
                continue;
            add(search, &(FeaturePair){.kind = EDGE_EDGE,
                                       .skin = {a, b},
                                       .node = {p, q, r, s},
                                       .feature = (int64_t)(3 * t + j) << 32 | (3 * u + k)});
        }
}

// ---- features of one skin with regions ----

/// Whether a search for a skin's own features is to add one of triangles t and u, which belong to
/// triangles `first` and `second`: there it is found, unless that is in a region left out.
static bool is_found_here(const SkinRegions* regions, int t, int u, int first, int second) {
    return (t == first && u == second) ||
           skin_regions_cover(regions, regions->patch[first], regions->patch[second]);
}

static void add_own_vertices(Search* search, const SkinRegions* regions, int b, int t, int u) {
    const Mesh* mesh = search->contacts->skin[b].body->mesh;
    const int *vertex = mesh->triangle[t], *corner = mesh->triangle[u];
    for (int k = 0; k < 3; k++)
        if (!triangle_has(corner, vertex[k]) &&
            is_found_here(regions, t, u, regions->point_owner[vertex[k]], u))
            add(search, &(FeaturePair){.kind = VERTEX_TRIANGLE,
                                       .skin = {b, b},
                                       .node = {vertex[k], corner[0], corner[1], corner[2]},
                                       .feature = (int64_t)vertex[k] << 32 | u});
}

static void add_own_edges(Search* search, const SkinRegions* regions, int b, int t, int u) {
    const int(*triangle)[3] = (const int(*)[3])search->contacts->skin[b].body->mesh->triangle;
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++) {
            const int e = regions->edge_number[3 * t + j], f = regions->edge_number[3 * u + k];
            const int first = e < f ? e : f, second = e < f ? f : e;
            const int *one = triangle[first / 3], *two = triangle[second / 3];
            const int p = one[first % 3], q = one[(first + 1) % 3], r = two[second % 3],
                      s = two[(second + 1) % 3];
            if (p != r && p != s && q != r && q != s && is_found_here(regions, t, u, e / 3, f / 3))
                add(search, &(FeaturePair){.kind = EDGE_EDGE,
                                           .skin = {b, b},
                                           .node = {p, q, r, s},
                                           .feature = (int64_t)first << 32 | second});
        }
}

static bool within(const Extent* a, const Extent* b, real reach) {
    for (int k = 0; k < 3; k++)
        if (a->low[k] - b->high[k] > reach || b->low[k] - a->high[k] > reach)
            return false;
    return true;
}

/// The features of two patches.
static void search_patches(Search* search, const SkinRegions* regions, int b, int p, int q) {
    const real reach = search->rounded_reach;
    for (int j = regions->from[p]; j < regions->from[p + 1]; j++) {
        const int t = regions->triangle[j];
        if (!within(&regions->triangle_box[t], &regions->box[q], reach))
            continue;
        for (int k = p == q ? j + 1 : regions->from[q]; k < regions->from[q + 1]; k++) {
            const int u = regions->triangle[k];
            if (!within(&regions->triangle_box[t], &regions->triangle_box[u], reach))
                continue;
            add_own_vertices(search, regions, b, t, u);
            add_own_vertices(search, regions, b, u, t);
            add_own_edges(search, regions, b, t, u);
        }
    }
}

/// The features of a skin that are not of a region left out.
static void find_own(Search* search, int b) {
    SkinRegions* regions = &search->contacts->skin_pairs.skin[b].regions;
    skin_regions_fit(regions, search->contacts->skin[b].body);
    for (int p = 0; p < regions->count; p++)
        for (int q = p; q < regions->count; q++)
            if (within(&regions->box[p], &regions->box[q], search->rounded_reach) &&
                !skin_regions_cover(regions, p, q))
                search_patches(search, regions, b, p, q);
}

// ---- lists ----

static int compare(const void* p, const void* q) {
    const FeaturePair *a = p, *b = q;
    if (a->skin[0] != b->skin[0]) // the first side is a vertex of either skin
        return a->skin[0] - b->skin[0];
    if (a->kind != b->kind)
        return (int)a->kind - (int)b->kind;
    return (a->feature > b->feature) - (a->feature < b->feature);
}

static void find_all(Search* search, int a, int b) {
    ContactSkin* skin = search->contacts->skin;
    const int(*near)[2];
    const int count =
        bullet_skin_near_triangles(skin[a].patches, skin[b].patches, search->reach, &near);
    for (int k = 0; k < count; k++) {
        const bool swapped = a == b && near[k][0] > near[k][1];
        const int t = near[k][swapped], u = near[k][!swapped];
        add_vertices(search, a, t, b, u);
        add_vertices(search, b, u, a, t);
        add_edges(search, a, t, b, u);
    }
}

/// Features of a skin were perhaps found at several triangles.
static void keep_each_once(PairList* list) {
    int count = 0;
    for (int k = 0; k < list->count; k++)
        if (k == 0 || compare(&list->pair[count - 1], &list->pair[k]) != 0)
            list->pair[count++] = list->pair[k];
    list->count = count;
}

void skin_pairs_find(Contacts* contacts, int a, int b, double reach) {
    PairList* list = &contacts->skin_pairs.list[a * contacts->skin_count + b];
    Search search = {contacts, list, skin_pairs_rest_gap(contacts, a, b), reach,
                     (real)(1.01 * reach)};
    if (a == b && contacts->skin_pairs.skin[a].regions.count > 0)
        find_own(&search, a);
    else
        find_all(&search, a, b);
    if (list->count > 0)
        qsort(list->pair, (size_t)list->count, sizeof *list->pair, compare);
    keep_each_once(list);
}
