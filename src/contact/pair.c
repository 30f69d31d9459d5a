#include "contact/pair.h"

#include "base/array.h"

const PairRow* const pair_table[PAIR_ROWS] = {
    &pair_ball_ball, &pair_ball_plane, &pair_ball_skin, &pair_skin_skin, &pair_skin_plane,
};

Contact* pair_next(Contacts* contacts) {
    array_reserve(contacts->contact, contacts->near_count, contacts->contact_capacity);
    return &contacts->contact[contacts->near_count];
}

void pair_keep(Contacts* contacts, bool may_touch, double h) {
    Contact* end = &contacts->contact[contacts->near_count++];
    if (!may_touch)
        return;
    if (!end->first)
        warm_start_load(&contacts->warm, end, h);
    Contact* behind = &contacts->contact[contacts->contact_count++]; // the first that stays behind
    if (behind != end) {
        const Contact moved = *behind;
        *behind = *end;
        *end = moved;
    }
}
