#include "contact/skins/skin_pairs.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "contact/broad_phase.h"
#include "contact/contacts.h"

static const double gap_share = 0.1;     ///< [shortest edges] rest gap of a skin without thickness
static const double gap_min = 1e-4;      ///< [mean edges] least rest gap
static const double gap_max = 0.5;       ///< [mean edges] greatest: a mesh resolves no thicker skin
static const double margin_self = 0.4;   ///< [mean edges] of the list of a skin with itself
static const double margin_others = 0.4; ///< [mean edges] of a list of two skins
static const double forecast = 2;        ///< [drifts] that a list should hold
enum {
    HALVINGS_MAX = 60,
    CROSSED_INTERVAL = 16 ///< updates between looks at skins that cross
};

// ---- skins ----

static double edge_length(const Body* body, int e) {
    const int* end = body->mesh->edge[e];
    return dlength(to_double4(body->x[end[0]]) - to_double4(body->x[end[1]]));
}

/// Longest mean edge of the balloons' skins, which are opened before the things.
static double scale_max(const Contacts* contacts) {
    double longest = 0;
    for (int b = 0; b < contacts->first_thing; b++)
        longest = fmax(longest, contacts->skin_pairs.skin[b].scale);
    return longest;
}

static void open_skin(Contacts* contacts, int b) {
    TouchingSkin* skin = &contacts->skin_pairs.skin[b];
    const Body* body = contacts->skin[b].body;
    double shortest = INFINITY, sum = 0;
    for (int e = 0; e < body->mesh->edge_count; e++) {
        const double length = edge_length(body, e);
        shortest = fmin(shortest, length);
        sum += length;
    }
    skin->scale = sum / fmax(body->mesh->edge_count, 1);
    double gap = gap_share * shortest;
    if (body->membrane.count > 0) {
        gap = INFINITY;
        for (int e = 0; e < body->membrane.count; e++)
            gap = fmin(gap, (double)body->membrane.first[e]);
    }
    skin->rest_gap = fmin(fmax(gap, gap_min * skin->scale), gap_max * skin->scale);
    if (contacts_thing(contacts, b)) { // no thickness; its faces may be far larger than a skin's
        skin->rest_gap = 0;
        skin->scale = fmin(skin->scale, scale_max(contacts));
    }
    skin->reference = new_array(real4, body->count);
    memcpy(skin->reference, body->x, (size_t)body->count * sizeof(real4));
    skin->motion.stretch = skin->reference_motion.stretch = 1;
    broad_phase_open(&contacts->skin[b]);
}

static void open_pairs(Contacts* contacts) {
    SkinPairs* pairs = &contacts->skin_pairs;
    pairs->skin = new_array(TouchingSkin, contacts->skin_count);
    pairs->made = new_array(bool, contacts->skin_count * contacts->skin_count);
    pairs->list = new_array(PairList, contacts->skin_count * contacts->skin_count);
    for (int b = 0; b < contacts->skin_count; b++)
        open_skin(contacts, b);
}

bool skin_pairs_may_touch(const Contacts* contacts, int a, int b) {
    if (contacts_thing(contacts, a) || contacts_thing(contacts, b))
        return !contacts_thing(contacts, a) || !contacts_thing(contacts, b);
    return a == b ? contacts->skins.self : contacts->skins.others;
}

static bool any_touch(const Contacts* contacts) {
    return contacts->law != CONTACT_PAPER && contacts->skin_count > 0 &&
           (contacts->skins.self || (contacts->skins.others && contacts->first_thing > 1) ||
            contacts->thing_count > 0);
}

double skin_pairs_rest_gap(const Contacts* contacts, int a, int b) {
    const TouchingSkin* skin = contacts->skin_pairs.skin;
    return (skin[a].rest_gap + skin[b].rest_gap) / 2;
}

static PairList* list_of(const Contacts* contacts, int a, int b) {
    return &contacts->skin_pairs.list[a * contacts->skin_count + b];
}

// ---- how long lists hold ----

/// How much more relative motion the list allows after a drift of length `ahead` [m]: while that is
/// not negative, all pairs that are not in it are farther apart than their rest gap. A path is
/// straight, so what holds at both ends of a drift holds between them.
static double slack_of(Contacts* contacts, int a, int b, double ahead) {
    const PairList* list = list_of(contacts, a, b);
    const SkinMotion *p = skin_motion_measure(contacts, a, ahead),
                     *q = skin_motion_measure(contacts, b, ahead);
    const double gap = skin_pairs_rest_gap(contacts, a, b);
    if (a == b)
        return p->stretch / list->from[0].stretch * (gap + list->clearance) -
               2 * (p->residual - list->from[0].residual) - gap;
    return list->clearance -
           (p->path - list->from[0].path + q->path - list->from[1].path +
            dlength(p->shift - list->from[0].shift - (q->shift - list->from[1].shift)));
}

/// Whether the list holds after a drift: by the cheap bound, or by the tight one.
static bool holds(Contacts* contacts, int a, int b, double ahead) {
    const PairList* list = list_of(contacts, a, b);
    if (list->crossed)
        return true;
    return list->valid &&
           (list->moved + skin_motion_relative(contacts, a, b, ahead) <= list->holds_until ||
            slack_of(contacts, a, b, ahead) >= 0);
}

/// The motions that were measured are no longer of the present positions and velocities.
static void forget_motions(const Contacts* contacts) {
    for (int b = 0; b < contacts->skin_count; b++)
        contacts->skin_pairs.skin[b].ahead = NAN;
}

/// The same; where the cheap bound has run out, the tight one sets it anew.
static bool holds_longer(Contacts* contacts, int a, int b, double ahead) {
    PairList* list = list_of(contacts, a, b);
    if (list->crossed)
        return true;
    if (!list->valid)
        return false;
    if (list->moved + skin_motion_relative(contacts, a, b, ahead) <= list->holds_until)
        return true;
    list->holds_until = fmax(list->holds_until, list->moved + slack_of(contacts, a, b, 0));
    return holds(contacts, a, b, ahead);
}

static bool all_hold(Contacts* contacts, double ahead) {
    for (int a = 0; a < contacts->skin_count; a++)
        for (int b = a; b < contacts->skin_count; b++)
            if (skin_pairs_may_touch(contacts, a, b) && !holds(contacts, a, b, ahead))
                return false;
    return true;
}

double skin_pairs_limit(Contacts* contacts, double h) {
    if (!any_touch(contacts))
        return h;
    forget_motions(contacts);
    skin_motion_measure_velocities(contacts);
    for (int halving = 0; halving < HALVINGS_MAX; halving++) {
        if (all_hold(contacts, h))
            return h;
        h /= 2;
    }
    return h;
}

void skin_pairs_moved(Contacts* contacts, double h) {
    if (!contacts->skin_pairs.skin)
        return;
    contacts->skin_pairs.drifts++;
    for (int a = 0; a < contacts->skin_count; a++)
        for (int b = a; b < contacts->skin_count; b++)
            if (list_of(contacts, a, b)->valid)
                list_of(contacts, a, b)->moved += skin_motion_relative(contacts, a, b, h);
    for (int b = 0; b < contacts->skin_count; b++) {
        skin_motion_drifted(contacts, b, h);
        contacts->skin_pairs.skin[b].fitted = false;
    }
}

// ---- lists ----

/// Boxes of a skin where it is now, for searches up to the longest reach.
static void fit(Contacts* contacts, int b, double reach_max) {
    TouchingSkin* touching = &contacts->skin_pairs.skin[b];
    ContactSkin* skin = &contacts->skin[b];
    if (touching->fitted)
        return;
    bullet_skin_refit(skin->patches, 0.51 * reach_max);
    bullet_skin_box(skin->patches, skin->low, skin->high);
    skin->path_max = 0;
    touching->coordinate_max = 0;
    for (int k = 0; k < 3; k++)
        touching->coordinate_max =
            fmax(touching->coordinate_max, fmax(fabs(skin->low[k]), fabs(skin->high[k])));
    touching->fitted = true;
    skin_motion_measure(contacts, b, 0);
    touching->reference_motion = touching->motion;
    memcpy(touching->reference, skin->body->x, (size_t)skin->body->count * sizeof(real4));
}

static double box_distance(const ContactSkin* a, const ContactSkin* b) {
    double4 away = {0};
    for (int k = 0; k < 3; k++)
        away[k] = fmax(fmax(a->low[k] - b->high[k], b->low[k] - a->high[k]), 0);
    return dlength(away);
}

/// Longest reach of any search.
static double reach_max(const Contacts* contacts) {
    double reach = 0;
    for (int b = 0; b < contacts->skin_count; b++) {
        const TouchingSkin* skin = &contacts->skin_pairs.skin[b];
        reach = fmax(reach, skin->rest_gap + margin_others * skin->scale);
    }
    return reach;
}

static void reserve_near(PairList* list) {
    if (list->count <= list->near_capacity)
        return;
    free(list->near_from);
    list->near_capacity = list->capacity;
    list->near_from = new_array(double, list->capacity);
}

static void clear_list(Contacts* contacts, int a, int b) {
    PairList* list = list_of(contacts, a, b);
    contacts->skin_pairs.count -= list->count;
    list->count = 0;
    list->valid = false;
}

static void make_list(Contacts* contacts, int a, int b, double longest) {
    SkinPairs* pairs = &contacts->skin_pairs;
    PairList* list = list_of(contacts, a, b);
    fit(contacts, a, longest);
    fit(contacts, b, longest);
    const double scale = fmin(pairs->skin[a].scale, pairs->skin[b].scale);
    const double margin = (a == b ? margin_self : margin_others) * scale;
    const double gap = skin_pairs_rest_gap(contacts, a, b);
    const double apart = a == b ? 0 : box_distance(&contacts->skin[a], &contacts->skin[b]);
    clear_list(contacts, a, b);
    list->valid = true;
    list->from[0] = *skin_motion_measure(contacts, a, 0);
    list->from[1] = *skin_motion_measure(contacts, b, 0);
    list->clearance = fmax(margin, apart - gap);
    list->moved = 0;
    list->holds_until = list->clearance;
    if (apart <= gap + margin)
        skin_pairs_find(contacts, a, b, gap + margin);
    pairs->count += list->count;
    reserve_near(list);
    for (int k = 0; k < list->count; k++)
        list->near_from[k] = list->pair[k].distance - list->pair[k].rest_gap;
}

/// Whether two features of the two are at one point: which side either is on is not known.
static bool meet(Contacts* contacts, int a, int b, double longest) {
    PairList* list = list_of(contacts, a, b);
    make_list(contacts, a, b, longest);
    bool any = false;
    for (int k = 0; k < list->count; k++)
        any |= !(list->pair[k].distance > 0);
    clear_list(contacts, a, b);
    return any;
}

/// At the start, and now and then of those that did: whether they cross.
static void look_for_crossed(Contacts* contacts, double longest) {
    SkinPairs* pairs = &contacts->skin_pairs;
    const bool first = !pairs->begun;
    pairs->begun = true;
    for (int a = 0; a < contacts->skin_count; a++)
        for (int b = a; b < contacts->skin_count; b++) {
            PairList* list = list_of(contacts, a, b);
            if (!skin_pairs_may_touch(contacts, a, b) || !(first || list->crossed))
                continue;
            fit(contacts, a, longest);
            fit(contacts, b, longest);
            list->crossed = skin_pairs_cross(contacts, a, b) || meet(contacts, a, b, longest);
        }
}

void skin_pairs_begin(Contacts* contacts) {
    if (!any_touch(contacts) || contacts->skin_pairs.begun)
        return;
    if (!contacts->skin_pairs.skin)
        open_pairs(contacts);
    forget_motions(contacts);
    look_for_crossed(contacts, reach_max(contacts));
}

void skin_pairs_update(Contacts* contacts, double h) {
    if (!any_touch(contacts))
        return;
    skin_pairs_begin(contacts);
    SkinPairs* pairs = &contacts->skin_pairs;
    const double longest = reach_max(contacts);
    forget_motions(contacts);
    if (++pairs->updates % CROSSED_INTERVAL == 0)
        look_for_crossed(contacts, longest);
    // by the velocities of the last limit: it is a forecast, which the next limit corrects
    bool* made = pairs->made;
    for (int a = 0; a < contacts->skin_count; a++)
        for (int b = a; b < contacts->skin_count; b++)
            made[a * contacts->skin_count + b] =
                skin_pairs_may_touch(contacts, a, b) && !holds_longer(contacts, a, b, forecast * h);
    for (int a = 0; a < contacts->skin_count; a++)
        for (int b = a; b < contacts->skin_count; b++)
            if (made[a * contacts->skin_count + b])
                make_list(contacts, a, b, longest);
}

void skin_pairs_forget(Contacts* contacts) {
    SkinPairs* pairs = &contacts->skin_pairs;
    pairs->begun = false;
    pairs->count = 0;
    for (int b = 0; pairs->skin && b < contacts->skin_count; b++)
        pairs->skin[b].fitted = pairs->skin[b].has_ends = false;
    for (int l = 0; pairs->list && l < contacts->skin_count * contacts->skin_count; l++) {
        pairs->list[l].valid = false;
        pairs->list[l].count = 0;
    }
}

void skin_pairs_close(Contacts* contacts) {
    SkinPairs* pairs = &contacts->skin_pairs;
    for (int l = 0; pairs->list && l < contacts->skin_count * contacts->skin_count; l++) {
        free(pairs->list[l].pair);
        free(pairs->list[l].near_from);
    }
    for (int b = 0; pairs->skin && b < contacts->skin_count; b++) {
        free(pairs->skin[b].reference);
        free(pairs->skin[b].end);
    }
    free(pairs->list);
    free(pairs->made);
    free(pairs->skin);
    *pairs = (SkinPairs){0};
}
