#include "solve/joints/joints.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/hash.h"
#include "base/memory.h"

void joints_open(Joints* joints, Body* const* body, int body_count, double gravity) {
    *joints = (Joints){.body = body,
                       .body_count = body_count,
                       .joined = new_array(int, body_count),
                       .gravity = gravity};
    for (int b = 0; b < body_count; b++)
        joints->joined[b] = b;
}

void joints_close(Joints* joints) {
    free(joints->joint);
    free(joints->knot);
    free(joints->joined);
    *joints = (Joints){0};
}

void joints_add_knot(Joints* joints, const double position[3], double mass, const PathPoint* path,
                     int path_count) {
    const double rest[3] = {0};
    array_reserve(joints->knot, joints->knot_count, joints->knot_capacity);
    Knot* knot = &joints->knot[joints->knot_count++];
    *knot = (Knot){.point = sphere_of(position, rest, 1, mass, 0, 0),
                   .held = !(mass > 0),
                   .start = {position[0], position[1], position[2], 0},
                   .path = path,
                   .path_count = path_count,
                   .body = NONE};
    knot->good = knot->point;
}

int joints_add_thing_point(Joints* joints, const Thing* thing, const double point[3]) {
    joints_add_knot(joints, point, 0, NULL, 0);
    joints->knot[joints->knot_count - 1].thing = thing;
    return joints->knot_count - 1;
}

/// Connect two bodies: all that are connected to either have the same first body.
static void connect(Joints* joints, int a, int b) {
    const int first = joints->joined[a], other = joints->joined[b];
    for (int k = 0; k < joints->body_count; k++)
        if (joints->joined[k] == other || joints->joined[k] == first)
            joints->joined[k] = first < other ? first : other;
}

static void couple(Joints* joints, const Joint* joint) {
    const int body = joint->end[0].body;
    if (joint->end[1].body != NONE) {
        connect(joints, body, joint->end[1].body);
        return;
    }
    Knot* knot = &joints->knot[joint->end[1].number];
    if (knot->held)
        return;
    knot->w2 += 2 * (double)joint->stiffness / (double)knot->point.mass;
    if (knot->body == NONE)
        knot->body = body;
    connect(joints, knot->body, body);
}

void joints_add(Joints* joints, JointEnd from, JointEnd to, double stiffness, double slack) {
    array_reserve(joints->joint, joints->count, joints->capacity);
    Joint* joint = &joints->joint[joints->count++];
    const real4 d = joint_position(joints, to, 0) - joint_position(joints, from, 0);
    const real free_length = (real)slack * length(d);
    *joint = (Joint){.end = {from, to},
                     .stiffness = (real)stiffness,
                     .free_length = free_length,
                     .first_stretch = real_max(length(d) - free_length, 0),
                     .tied = true};
    for (int e = 0; e < 2; e++)
        if (joint->end[e].body != NONE) {
            Body* body = joints->body[joint->end[e].body];
            body->joined_w2 += 2 * stiffness * (double)body->inverse_mass[joint->end[e].number];
        }
    couple(joints, joint);
}

real4 joint_position(const Joints* joints, JointEnd end, double h) {
    if (end.body != NONE)
        return joints->body[end.body]->x[end.number];
    const Sphere* point = &joints->knot[end.number].point;
    return point->x + (real)h * point->v;
}

real4 joint_force(const Joints* joints, const Joint* joint, double h) {
    const real4 d =
        joint_position(joints, joint->end[1], h) - joint_position(joints, joint->end[0], h);
    const real size = length(d), over = size - joint->free_length;
    return joint->tied && over > 0 ? (joint->stiffness * over / size) * d : (real4){0, 0, 0, 0};
}

void joint_reach(const Joints* joints, Joint* joint) {
    const real4 d =
        joint_position(joints, joint->end[1], 0) - joint_position(joints, joint->end[0], 0);
    joint->free_length = string_tied_length(joint->free_length, joint->first_stretch, length(d));
}

double joint_tension(const Joints* joints, const Joint* joint) {
    return (double)length(joint_force(joints, joint, 0));
}

double joint_energy(const Joints* joints, const Joint* joint, double h) {
    const double tension = (double)length(joint_force(joints, joint, h));
    return tension > 0 ? tension * tension / (2 * (double)joint->stiffness) : 0;
}

double joints_energy(const Joints* joints) {
    double sum = 0;
    for (int k = 0; k < joints->count; k++)
        sum += joint_energy(joints, &joints->joint[k], 0);
    return sum;
}

void joints_begin(Joints* joints, double h) {
    for (int k = 0; k < joints->knot_count; k++) {
        Knot* knot = &joints->knot[k];
        knot->v_before = knot->point.v;
        if (!knot->held) {
            knot->point.v[1] -= (real)(h * joints->gravity);
            continue;
        }
        const double4 to =
            knot->thing
                ? thing_point(knot->thing, knot->start, h)
                : knot->start + path_pose(knot->path, knot->path_count, joints->time + h).shift;
        knot->point.v = to_real4((to - to_double4(knot->point.x)) / h);
    }
}

void joints_undo(Joints* joints) {
    for (int k = 0; k < joints->knot_count; k++)
        joints->knot[k].point.v = joints->knot[k].v_before;
}

static void push_end(Joints* joints, JointEnd end, real4 impulse) {
    if (end.body != NONE) {
        Body* body = joints->body[end.body];
        body->v[end.number] += body->inverse_mass[end.number] * impulse;
    } else if (!joints->knot[end.number].held) {
        joints->knot[end.number].point.v += impulse / joints->knot[end.number].point.mass;
    }
}

void joints_push(Joints* joints, double h) {
    for (int k = 0; k < joints->count; k++) {
        const Joint* joint = &joints->joint[k];
        const real4 impulse = (real)h * joint_force(joints, joint, 0);
        push_end(joints, joint->end[0], impulse);
        push_end(joints, joint->end[1], -impulse);
    }
}

void joints_drift(Joints* joints, double h) {
    for (int k = 0; k < joints->knot_count; k++)
        joints->knot[k].point.x += (real)h * joints->knot[k].point.v;
    joints->time += h;
}

bool joints_are_led(const Joints* joints) {
    for (int k = 0; k < joints->knot_count; k++)
        if (joints->knot[k].path_count > 0 ||
            (joints->knot[k].thing && joints->knot[k].thing->path_count > 0))
            return true;
    return false;
}

void joints_add_forces(const Joints* joints, const Body* body) {
    for (int k = 0; k < joints->count; k++)
        for (int e = 0; e < 2; e++) {
            const JointEnd* end = &joints->joint[k].end[e];
            if (end->body != NONE && joints->body[end->body] == body)
                body->f[end->number] +=
                    (e ? -1 : (real)1) * joint_force(joints, &joints->joint[k], 0);
        }
}

void joints_swap(Joints* joints) {
    for (int k = 0; k < joints->knot_count; k++) {
        const Sphere point = joints->knot[k].point;
        joints->knot[k].point = joints->knot[k].good;
        joints->knot[k].good = point;
    }
}

void joints_keep(Joints* joints) {
    for (int k = 0; k < joints->knot_count; k++)
        joints->knot[k].good = joints->knot[k].point;
    joints->good_time = joints->time;
}

void joints_put_back(Joints* joints) {
    for (int k = 0; k < joints->knot_count; k++)
        joints->knot[k].point = joints->knot[k].good;
    joints->time = joints->good_time;
}

uint64_t joints_hash(const Joints* joints, uint64_t hash) {
    for (int k = 0; k < joints->knot_count; k++) {
        const Sphere* point = &joints->knot[k].point;
        hash = hash_bytes(hash, &point->x, 3 * sizeof(real));
        hash = hash_bytes(hash, &point->v, 3 * sizeof(real));
    }
    return hash;
}
