#include "contact/reaction.h"

void reaction_clear(Contacts* contacts) {
    for (int b = 0; b <= contacts->first_thing; b++) {
        if (b < contacts->first_thing && contacts->skin[b].body->asleep)
            continue;
        for (int k = 0; k < contacts->plane_count; k++)
            *reaction_on(contacts, b, k) = 0;
        for (int k = 0; k < contacts->thing_count; k++)
            contacts->thing_impulse[b * contacts->thing_count + k] = (ThingImpulse){{0}, {0}};
    }
    for (int s = 0; s < contacts->sphere_count; s++)
        contacts->sphere[s].impulse = (real4){0, 0, 0, 0};
}

void reaction_begin(Contacts* contacts) {
    for (int s = 0; s < contacts->sphere_count; s++)
        contacts->sphere[s].impulse -= contacts->sphere[s].mass * contacts->sphere[s].v;
}

void reaction_add(Contacts* contacts, int skin, int thing, double4 impulse, double4 x) {
    ThingImpulse* sum = &contacts->thing_impulse[skin * contacts->thing_count + thing];
    sum->linear += impulse;
    sum->angular += dcross(x, impulse);
    contacts->separation_work -= ddot(impulse, thing_velocity(&contacts->thing[thing], x));
}

/// Whether the nodes of a contact's first side, which have positive weights, are the thing's.
static bool begins_with(const Contact* c, const Body* body) {
    return c->node[0].position >= body->x && c->node[0].position < body->x + body->count;
}

/// Where a contact's impulse acts on its first side, or on its second one.
static double4 point_of(const Contact* c, bool first) {
    double4 x = {0};
    for (int k = 0; k < c->node_count; k++)
        if ((c->node[k].weight > 0) == first)
            x += fabs((double)c->node[k].weight) * to_double4(*c->node[k].position);
    return first && c->lever_count > 0 ? x + to_double4(c->lever[0].arm) : x;
}

/// What a contact gives to particles that things hold.
static void add_to_pins(Contacts* contacts, const Contact* c, int skin, double4 impulse) {
    for (int k = 0; contacts->pins.count > 0 && k < c->node_count; k++) {
        const Thing* thing =
            c->node[k].mass < INFINITY ? NULL : pins_thing(&contacts->pins, c->node[k].position);
        if (thing)
            reaction_add(contacts, skin, (int)(thing - contacts->thing),
                         (double)c->node[k].weight * impulse, to_double4(*c->node[k].position));
    }
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
        if (c->normal_impulse <= 0)
            continue;
        const double4 impulse = to_double4(c->normal_impulse * c->normal + c->tangent_impulse);
        add_to_pins(contacts, c, skin, impulse);
        if (c->side[1] < first_thing)
            continue;
        const int thing = c->side[1] - first_thing;
        const bool first = begins_with(c, &contacts->thing[thing].body);
        // on the thing where it acts on what touches it: a gap apart, and no angular momentum is lost
        reaction_add(contacts, skin, thing, first ? impulse : -impulse, point_of(c, !first));
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

ThingImpulse reaction_of_thing(const Contacts* contacts, int thing) {
    const Thing* about = &contacts->thing[thing];
    ThingImpulse sum = {{0}, {0}};
    for (int b = 0; b <= contacts->first_thing; b++) {
        const ThingImpulse* one = &contacts->thing_impulse[b * contacts->thing_count + thing];
        sum.linear += one->linear;
        sum.angular += one->angular;
    }
    sum.angular -= dcross(about->origin + about->pose.shift, sum.linear);
    return sum;
}
