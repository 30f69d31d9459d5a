#include "contact/reaction.h"

void reaction_clear(Contacts* contacts) {
    for (int b = 0; b <= contacts->first_thing; b++) {
        if (b < contacts->first_thing && contacts->skin[b].body->asleep)
            continue;
        for (int k = 0; k < contacts->plane_count; k++)
            *reaction_on(contacts, b, k) = 0;
        for (int k = 0; k < contacts->thing_count; k++)
            contacts->thing_impulse[b * contacts->thing_count + k] = (double4){0};
    }
    for (int s = 0; s < contacts->sphere_count; s++)
        contacts->sphere[s].impulse = (real4){0, 0, 0, 0};
}

void reaction_begin(Contacts* contacts) {
    for (int s = 0; s < contacts->sphere_count; s++)
        contacts->sphere[s].impulse -= contacts->sphere[s].mass * contacts->sphere[s].v;
}

void reaction_add(Contacts* contacts, int skin, int thing, double4 impulse) {
    contacts->thing_impulse[skin * contacts->thing_count + thing] += impulse;
    contacts->separation_work -= ddot(impulse, contacts->thing[thing].velocity);
}

/// Whether the nodes of a contact's first side, which have positive weights, are the thing's.
static bool begins_with(const Contact* c, const Body* body) {
    return c->node[0].position >= body->x && c->node[0].position < body->x + body->count;
}

void reaction_add_contacts(Contacts* contacts) {
    const int first_thing = contacts->sphere_count + contacts->first_thing;
    for (int k = 0; k < contacts->contact_count; k++) {
        const Contact* c = &contacts->contact[k];
        const bool is_ball = c->side[0] < contacts->sphere_count;
        const int skin = is_ball ? contacts->first_thing : c->side[0] - contacts->sphere_count;
        if (c->side[1] == NONE)
            *reaction_on(contacts, skin, c->feature % contacts->plane_count) +=
                (double)c->normal_impulse;
        if (c->side[1] < first_thing || c->normal_impulse <= 0)
            continue;
        const int thing = c->side[1] - first_thing;
        const double4 impulse = to_double4(c->normal_impulse * c->normal + c->tangent_impulse);
        reaction_add(contacts, skin, thing,
                     begins_with(c, &contacts->thing[thing].body) ? impulse : -impulse);
    }
}

void reaction_end(Contacts* contacts) {
    for (int s = 0; s < contacts->sphere_count; s++)
        contacts->sphere[s].impulse += contacts->sphere[s].mass * contacts->sphere[s].v;
    reaction_add_contacts(contacts);
}

double reaction_of_plane(const Contacts* contacts, int plane) {
    double sum = 0;
    for (int b = 0; b <= contacts->first_thing; b++)
        sum += contacts->plane_impulse[b * contacts->plane_count + plane];
    return sum;
}

double4 reaction_of_thing(const Contacts* contacts, int thing) {
    double4 sum = {0};
    for (int b = 0; b <= contacts->first_thing; b++)
        sum += contacts->thing_impulse[b * contacts->thing_count + thing];
    return sum;
}
