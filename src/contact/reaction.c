#include "contact/reaction.h"

void reaction_clear(Contacts* contacts) {
    const int planes = contacts->plane_count;
    for (int b = 0; b <= contacts->skin_count; b++)
        for (int k = 0; k < planes; k++)
            if (b == contacts->skin_count || !contacts->skin[b].body->asleep)
                *reaction_on(contacts, b, k) = 0;
    for (int s = 0; s < contacts->sphere_count; s++)
        contacts->sphere[s].impulse = (real4){0, 0, 0, 0};
}

void reaction_begin(Contacts* contacts) {
    for (int s = 0; s < contacts->sphere_count; s++)
        contacts->sphere[s].impulse -= contacts->sphere[s].mass * contacts->sphere[s].v;
}

void reaction_add_planes(Contacts* contacts) {
    for (int k = 0; k < contacts->contact_count; k++) {
        const Contact* c = &contacts->contact[k];
        if (c->side[1] != NONE)
            continue;
        const bool is_ball = c->side[0] < contacts->sphere_count;
        const int skin = is_ball ? contacts->skin_count : c->side[0] - contacts->sphere_count;
        *reaction_on(contacts, skin, c->feature % contacts->plane_count) +=
            (double)c->normal_impulse;
    }
}

void reaction_end(Contacts* contacts) {
    for (int s = 0; s < contacts->sphere_count; s++)
        contacts->sphere[s].impulse += contacts->sphere[s].mass * contacts->sphere[s].v;
    reaction_add_planes(contacts);
}

double reaction_of_plane(const Contacts* contacts, int plane) {
    double sum = 0;
    for (int b = 0; b <= contacts->skin_count; b++)
        sum += contacts->plane_impulse[b * contacts->plane_count + plane];
    return sum;
}
