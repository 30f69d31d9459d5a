#include "contact/pair.h"

#include "base/array.h"

const PairRow* const pair_table[PAIR_ROWS] = {
    &pair_ball_ball, &pair_ball_plane, &pair_ball_skin, &pair_skin_skin, &pair_skin_plane,
};

Contact* pair_next(Contacts* contacts) {
    array_reserve(contacts->contact, contacts->contact_count, contacts->contact_capacity);
    return &contacts->contact[contacts->contact_count];
}

void pair_keep(Contacts* contacts, bool may_touch, double h) {
    Contact* contact = &contacts->contact[contacts->contact_count];
    if (!may_touch) {
        array_reserve(contacts->near, contacts->near_count, contacts->near_capacity);
        contacts->near[contacts->near_count++] = *contact;
        return;
    }
    if (!contact->first)
        warm_start_load(&contacts->warm, contact, h);
    contacts->contact_count++;
}
