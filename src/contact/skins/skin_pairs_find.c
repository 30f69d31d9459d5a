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

static int compare(const void* p, const void* q) {
    const FeaturePair *a = p, *b = q;
    if (a->skin[0] != b->skin[0]) // the first side is a vertex of either skin
        return a->skin[0] - b->skin[0];
    if (a->kind != b->kind)
        return (int)a->kind - (int)b->kind;
    return (a->feature > b->feature) - (a->feature < b->feature);
}

void skin_pairs_find(Contacts* contacts, int a, int b, double reach) {
    PairList* list = &contacts->skin_pairs.list[a * contacts->skin_count + b];
    Search search = {contacts, list, skin_pairs_rest_gap(contacts, a, b), reach,
                     (real)(1.01 * reach)};
    const int(*near)[2];
    const int count = bullet_skin_near_triangles(contacts->skin[a].patches,
                                                 contacts->skin[b].patches, reach, &near);
    for (int k = 0; k < count; k++) {
        const bool swapped = a == b && near[k][0] > near[k][1];
        const int t = near[k][swapped], u = near[k][!swapped];
        add_vertices(&search, a, t, b, u);
        add_vertices(&search, b, u, a, t);
        add_edges(&search, a, t, b, u);
    }
    if (list->count > 0)
        qsort(list->pair, (size_t)list->count, sizeof *list->pair, compare);
}
