#include "world/knots/knots.h"

#include <stdlib.h>

#include "base/memory.h"
#include "base/table.h"
#include "world/things/path_points.h"
#include "world/things/thing_point.h"

static bool has_joints(const WorldDef* def) {
    for (unsigned b = 0; b < def->balloons_count; b++)
        for (unsigned k = 0; k < def->balloons[b].strings_count; k++)
            if (string_joins(&def->balloons[b].strings[k]))
                return true;
    return false;
}

/// Names of the methods that step joined bodies.
static void methods_that_join(char* names, size_t size) {
    names[0] = '\0';
    for (int k = 0; k < method_count; k++)
        if (method_table[k]->joins)
            table_add_name(names, size, method_table[k]->name);
}

/// Whether every `to_at` that is a number is that of a particle, or of a thing's point.
static bool check_particles(const World* world, Fault* fault) {
    for (int b = 0; b < world->balloon_count; b++)
        for (unsigned k = 0; k < world->balloon[b].def->strings_count; k++) {
            const StringDef* string = &world->balloon[b].def->strings[k];
            if ((!string->to_balloon && !string->to_thing) || !string->to_at ||
                string->to_at[0] > '9')
                continue;
            const int other = (int)*(string->to_thing ? string->to_thing : string->to_balloon);
            const char* model = string->to_thing ? world->def.things[other].model
                                                 : world->balloon[other].def->model;
            const int count = string->to_thing ? world->thing[other].body.count
                                               : world->balloon[other].body.count;
            if (strtol(string->to_at, NULL, 10) >= count)
                return fault_set(fault, world->def.file,
                                 "balloons.%d.strings.%u.to_at: %s has %s 0 to %d, not %s", b, k,
                                 model, string->to_thing ? "points" : "particles", count - 1,
                                 string->to_at);
        }
    return true;
}

bool knots_open(World* world, Fault* fault) {
    const WorldDef* def = &world->def;
    if (has_joints(def) && !world->method->joins) {
        char names[128];
        methods_that_join(names, sizeof names);
        return fault_set(fault, def->file,
                         "method '%s' takes no string to a balloon, a knot or a thing; take %s",
                         world->method->name, names);
    }
    if (!check_particles(world, fault))
        return false;
    world->knot_path = new_array(PathPoint*, def->knots_count);
    for (unsigned k = 0; k < def->knots_count; k++)
        world->knot_path[k] = path_points(def->knots[k].path, def->knots[k].path_count);
    return true;
}

/// A string to the thing's point that its `to_at` names, or the nearest one to its particle.
static void add_thing_joint(World* world, int b, const StringDef* def) {
    const Thing* thing = &world->thing[(int)*def->to_thing];
    const Body* body = &world->balloon[b].body;
    double point[3];
    thing_point_at(thing, def->to_at, NULL, point);
    const int particle = balloon_particle_at(body, def->at, point);
    const double4 x = to_double4(body->x[particle]);
    thing_point_at(thing, def->to_at, &x, point);
    Joints* joints = &world->system.joints;
    const JointEnd to = {NONE, joints_add_thing_point(joints, thing, point)};
    joints_add(joints, (JointEnd){b, particle}, to, def->stiffness, def->slack);
}

/// The particle of balloon b that a string begins at, and its other end.
static void add_joint(World* world, int b, const StringDef* def) {
    Joints* joints = &world->system.joints;
    const Body* body = &world->balloon[b].body;
    JointEnd from = {b, NONE}, to = {NONE, NONE};
    double point[3];
    if (def->to_knot) {
        to.number = (int)*def->to_knot;
        for (int k = 0; k < 3; k++)
            point[k] = (double)joints->knot[to.number].point.x[k];
    } else {
        to.body = (int)*def->to_balloon;
        balloon_center(&world->balloon[to.body].body, point);
    }
    from.number = balloon_particle_at(body, def->at, point);
    if (def->to_balloon) {
        for (int k = 0; k < 3; k++)
            point[k] = (double)body->x[from.number][k];
        to.number = balloon_particle_at(&world->balloon[to.body].body, def->to_at, point);
    }
    joints_add(joints, from, to, def->stiffness, def->slack);
}

void knots_begin(World* world) {
    Joints* joints = &world->system.joints;
    joints->gravity = scene_gravity(&world->def);
    for (unsigned k = 0; k < world->def.knots_count; k++) {
        const KnotDef* def = &world->def.knots[k];
        joints_add_knot(joints, def->path_count > 0 ? def->path[0].position : def->position,
                        def->mass, world->knot_path[k], (int)def->path_count);
    }
    for (int b = 0; b < world->balloon_count; b++) {
        const BalloonDef* def = world->balloon[b].def;
        for (unsigned k = 0; k < def->strings_count; k++)
            if (def->strings[k].to_thing)
                add_thing_joint(world, b, &def->strings[k]);
            else if (string_joins(&def->strings[k]))
                add_joint(world, b, &def->strings[k]);
    }
}

bool knots_tie(World* world, int balloon) {
    Joints* joints = &world->system.joints;
    bool any = false;
    for (int k = 0; k < joints->count; k++) {
        Joint* joint = &joints->joint[k];
        if (joint->end[0].body != balloon)
            continue;
        joint->tied = !joint->tied;
        if (joint->tied)
            joint_reach(joints, joint);
        any = true;
    }
    return any;
}

const Joint* knots_joint(const World* world, int balloon, int string) {
    const Joints* joints = &world->system.joints;
    const BalloonDef* def = world->balloon[balloon].def;
    if (!string_joins(&def->strings[string]))
        return NULL;
    int before = 0; // joints of this balloon's earlier strings
    for (int k = 0; k < string; k++)
        before += string_joins(&def->strings[k]);
    for (int k = 0; k < joints->count; k++)
        if (joints->joint[k].end[0].body == balloon && before-- == 0)
            return &joints->joint[k];
    return NULL;
}

void knots_close(World* world) {
    for (unsigned k = 0; world->knot_path && k < world->def.knots_count; k++)
        free(world->knot_path[k]);
    free(world->knot_path);
}
