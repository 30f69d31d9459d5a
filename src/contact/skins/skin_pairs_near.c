/// Measuring the pairs of the lists that are near, and what of a drift is safe for them.
#include "contact/contacts.h"

static const double keep_share = 0.1; ///< [1] of its distance that a pair keeps in a drift

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

double skin_pairs_safe_part(const Contacts* contacts, const FeaturePair* pair, double h) {
    double4 x[FEATURE_NODES], dx[FEATURE_NODES], end[FEATURE_NODES];
    for (int k = 0; k < FEATURE_NODES; k++) {
        const Body* body = contacts->skin[feature_pair_skin(pair, k)].body;
        const real4 at = body->x[pair->node[k]];
        end[k] = to_double4(body->asleep ? at : at + (real)h * body->v[pair->node[k]]);
        x[k] = to_double4(at);
        dx[k] = end[k] - x[k];
    }
    // where a plane separates the two at both ends, it does between them: paths are straight
    const double kept = keep_share * fmin(pair->distance, pair->rest_gap);
    if (feature_separation(pair->kind, end, pair->normal) >= kept)
        return 1;
    return feature_safe_part(pair->kind, x, dx, keep_share);
}
