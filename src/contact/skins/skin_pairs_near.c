/// Measuring the pairs of the lists that are near, and what of a drift is safe for them.
#include "contact/contacts.h"

static const double keep_share = 0.1; ///< [1] of its distance that a pair keeps in a drift

/// [REAL_EPSILON of the largest coordinate] that a pair keeps, or half of its distance if that is
/// less: what rounding does to a rigid motion is then less than the distance.
static const double keep_roundings = 8;

/// Measure a pair where it is now.
static void measure(const Contacts* contacts, PairList* list, int k) {
    FeaturePair* pair = &list->pair[k];
    double4 x[FEATURE_NODES], away = {0};
    for (int n = 0; n < FEATURE_NODES; n++)
        x[n] = to_double4(contacts->skin[feature_pair_skin(pair, n)].body->x[pair->node[n]]);
    pair->distance = feature_distance(pair->kind, x, pair->weight);
    for (int n = 1; n < FEATURE_NODES; n++) // the weights sum to 0
        away += pair->weight[n] * (x[n] - x[0]);
    pair->normal = away / dlength(away);
    pair->clearance = feature_clearance(pair->kind, x, pair->normal);
    pair->measured = contacts->skin_pairs.drifts;
    list->near_from[k] = list->moved + pair->distance - pair->rest_gap;
}

void skin_pairs_each_near(Contacts* contacts, double h, double share, PairVisit* visit,
                          void* self) {
    if (contacts->skin_pairs.count == 0)
        return;
    skin_motion_measure_velocities(contacts);
    for (int a = 0; a < contacts->skin_count; a++)
        for (int b = a; b < contacts->skin_count; b++) {
            PairList* list = &contacts->skin_pairs.list[a * contacts->skin_count + b];
            if (contacts->skin[a].body->asleep && contacts->skin[b].body->asleep)
                continue;
            const double until = list->moved + skin_motion_relative(contacts, a, b, h) +
                                 share * skin_pairs_rest_gap(contacts, a, b);
            for (int k = 0; k < list->count; k++) {
                if (list->near_from[k] > until)
                    continue;
                if (list->pair[k].measured != contacts->skin_pairs.drifts)
                    measure(contacts, list, k);
                visit(contacts, &list->pair[k], self);
            }
        }
}

/// What the pair must keep of its distance [m].
static double kept_distance(const FeaturePair* pair, const double4 x[FEATURE_NODES]) {
    double coordinate = 0;
    for (int k = 0; k < FEATURE_NODES; k++)
        for (int c = 0; c < 3; c++)
            coordinate = fmax(coordinate, fabs(x[k][c]));
    const double rounded = keep_roundings * (double)REAL_EPSILON * coordinate;
    return fmax(keep_share * fmin(pair->clearance, pair->rest_gap),
                fmin(rounded, pair->clearance / 2));
}

double skin_pairs_safe_part(const Contacts* contacts, const FeaturePair* pair, double h) {
    double4 x[FEATURE_NODES], dx[FEATURE_NODES], end[FEATURE_NODES];
    for (int k = 0; k < FEATURE_NODES; k++) {
        const int b = feature_pair_skin(pair, k);
        end[k] = to_double4(skin_motion_end(contacts, b, pair->node[k], h));
        x[k] = to_double4(contacts->skin[b].body->x[pair->node[k]]);
        dx[k] = end[k] - x[k];
    }
    const double kept = kept_distance(pair, x);
    // where a plane separates the two at both ends, it does between them: paths are straight
    if (pair->clearance > 0 && feature_clearance(pair->kind, end, pair->normal) >= kept)
        return 1;
    return feature_safe_part(pair->kind, x, dx, pair->clearance > 0 ? kept / pair->clearance : 1);
}
