#include "solve/joints/joint_terms.h"

#include <stdlib.h>

#include "base/memory.h"
#include "solve/group.h"

void joint_terms_reserve(Groups* groups, const Joints* joints) {
    const int count = joints->count + joints->knot_count;
    if (count <= groups->joint_capacity)
        return;
    free(groups->joint);
    free(groups->knot_location);
    groups->joint_capacity = count;
    groups->joint = new_array(JointTerm, count);
    groups->knot_location = new_array(int, count);
}

int joint_terms_add_knots(Groups* groups, Joints* joints, int spheres, int g, GroupBall* ball) {
    Group* group = &groups->group[g];
    int count = 0;
    for (int k = 0; k < joints->knot_count; k++) {
        Knot* knot = &joints->knot[k];
        if (knot->held || knot->body == NONE || groups->group_of[spheres + knot->body] != g)
            continue;
        groups->knot_location[k] = group->ball_count++;
        ball[count++] = (GroupBall){.sphere = &knot->point, .v_start = knot->point.v};
    }
    return count;
}

static TermNode node_of_end(const Groups* groups, const Joints* joints, int spheres, JointEnd end) {
    if (end.body == NONE)
        return (TermNode){
            NONE, joints->knot[end.number].held ? NONE : groups->knot_location[end.number], 0, 0};
    const bool moves = joints->body[end.body]->inverse_mass[end.number] > 0;
    return (TermNode){moves ? groups->location[spheres + end.body] : NONE, NONE, end.number, 0};
}

void joint_terms_find(Groups* groups, const Joints* joints, int spheres) {
    JointTerm* term = groups->joint;
    for (int g = 0; g < groups->count; g++) {
        Group* group = &groups->group[g];
        group->joints = joints;
        group->joint = term;
        for (int k = 0; k < joints->count; k++) {
            const Joint* joint = &joints->joint[k];
            if (groups->group_of[spheres + joint->end[0].body] == g)
                *term++ =
                    (JointTerm){.joint = joint,
                                .node = {node_of_end(groups, joints, spheres, joint->end[0]),
                                         node_of_end(groups, joints, spheres, joint->end[1])}};
        }
        group->joint_count = (int)(term - group->joint);
    }
}

static real4* entry(const Group* group, const TermNode* node, GroupVector vector) {
    if (node->body != NONE)
        return &group->body[node->body].vector[vector][node->row];
    return node->ball != NONE ? &group->ball[node->ball].vector[vector][0] : NULL;
}

static void add(const Group* group, const TermNode* node, GroupVector vector, real4 value) {
    real4* const to = entry(group, node, vector);
    if (to)
        *to += value;
}

/// H of a joint with the force F on its end 0.
static void set_tangent(JointTerm* term, const Joints* joints, real4 force, double h) {
    const Joint* joint = term->joint;
    term->tangent = (Block){0};
    const real tension = length(force);
    if (!(tension > 0))
        return;
    const real4 n = force / tension;
    const real size =
        length(joint_position(joints, joint->end[1], h) - joint_position(joints, joint->end[0], h));
    const real along = (real)(h * h) * joint->stiffness, across = (real)(h * h) * tension / size;
    for (int c = 0; c < 3; c++) {
        term->tangent.column[c] = ((along - across) * n[c]) * n;
        term->tangent.column[c][c] += across;
    }
}

void joint_terms_add_impulses(Group* group, double h) {
    for (int k = 0; k < group->joint_count; k++) {
        JointTerm* term = &group->joint[k];
        const real4 force = joint_force(group->joints, term->joint, h);
        const real4 impulse = (real)h * force;
        add(group, &term->node[0], GROUP_RESIDUAL, -impulse);
        add(group, &term->node[1], GROUP_RESIDUAL, impulse);
        set_tangent(term, group->joints, force, h);
    }
}

void joint_terms_assemble(Group* group) {
    for (int k = 0; k < group->joint_count; k++)
        for (int e = 0; e < 2; e++) {
            const JointTerm* term = &group->joint[k];
            const TermNode* node = &term->node[e];
            if (node->body == NONE)
                continue;
            Block* block = block_matrix_diagonal(group->body[node->body].matrix, node->row);
            for (int c = 0; c < 3; c++)
                block->column[c] += term->tangent.column[c];
        }
}

void joint_terms_add_block(const Group* group, int number, double4 column[3]) {
    for (int k = 0; k < group->joint_count; k++)
        if (group->joint[k].node[1].ball == number)
            for (int c = 0; c < 3; c++)
                column[c] += to_double4(group->joint[k].tangent.column[c]);
}

void joint_terms_multiply(Group* group) {
    for (int k = 0; k < group->joint_count; k++) {
        const JointTerm* term = &group->joint[k];
        for (int e = 0; e < 2; e++) {
            const real4* p = entry(group, &term->node[e], GROUP_DIRECTION);
            if (!p)
                continue;
            const real4 product = block_times(&term->tangent, *p);
            add(group, &term->node[1 - e], GROUP_IMAGE, -product);
            if (term->node[e].ball != NONE) // a body's matrix has it
                add(group, &term->node[e], GROUP_IMAGE, product);
        }
    }
}

double joint_terms_potential(const Group* group, double h) {
    double sum = 0;
    for (int k = 0; k < group->joint_count; k++)
        sum += joint_energy(group->joints, group->joint[k].joint, h);
    return sum;
}
