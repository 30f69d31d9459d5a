#include "world/things/thing_load.h"

#include "contact/reaction.h"
#include "force/force.h"

static void add(ThingLoad* load, double4 force, double4 arm) {
    load->force += force;
    load->moment += dcross(arm, force);
}

static void add_strings(const World* world, const Thing* thing, double4 origin, ThingLoad* load) {
    const Joints* joints = &world->system.joints;
    for (int k = 0; k < joints->count; k++) {
        const JointEnd end = joints->joint[k].end[1];
        if (end.body == NONE && joints->knot[end.number].thing == thing)
            add(load, -to_double4(joint_force(joints, &joints->joint[k], 0)),
                to_double4(joints->knot[end.number].point.x) - origin);
    }
}

static void add_pins(const World* world, const Thing* thing, double4 origin, ThingLoad* load) {
    const Pins* pins = &world->contacts.pins;
    const Body* summed = NULL;
    for (int k = 0; k < pins->count; k++) {
        const Pin* pin = &pins->pin[k];
        if (pin->thing != thing)
            continue;
        if (summed != pin->body) { // pins come balloon by balloon
            force_sum(pin->body);
            joints_add_forces(&world->system.joints, pin->body);
            summed = pin->body;
        }
        add(load, to_double4(pin->body->f[pin->particle]),
            to_double4(pin->body->x[pin->particle]) - origin);
    }
}

ThingLoad thing_load(const World* world, int number) {
    const Thing* thing = &world->thing[number];
    const ThingImpulse impulse = reaction_of_thing(&world->contacts, number);
    const double4 origin = thing->origin + thing->pose.shift;
    ThingLoad load = {impulse.linear / world->step, impulse.angular / world->step};
    add_strings(world, thing, origin, &load);
    add_pins(world, thing, origin, &load);
    return load;
}
