#include "solve/group_vector.h"

#include <string.h>

#include "base/vectors.h"

double group_dot(const Group* group, GroupVector a, GroupVector b) {
    double sum = 0;
    for (int k = 0; k < group->body_count; k++) {
        const GroupBody* part = &group->body[k];
        sum += vectors()->dot(part->vector[a], part->vector[b], part->body->count);
    }
    for (int s = 0; s < group->ball_count; s++)
        for (int row = 0; row < 2; row++)
            sum += (double)dot(group->ball[s].vector[a][row], group->ball[s].vector[b][row]);
    return sum;
}

double group_inverse_mass_norm(const Group* group, GroupVector r) {
    double sum = 0;
    for (int k = 0; k < group->body_count; k++) {
        const GroupBody* part = &group->body[k];
        sum += vectors()->weighted_squares(part->body->inverse_mass, part->vector[r],
                                           part->body->count);
    }
    for (int s = 0; s < group->ball_count; s++) {
        const GroupBall* ball = &group->ball[s];
        const real4 *v = &ball->vector[r][0], *spin = &ball->vector[r][1];
        sum += (double)(dot(*v, *v) / ball->sphere->mass) +
               (double)(dot(*spin, *spin) / sphere_inertia(ball->sphere));
    }
    return sqrt(sum);
}

void group_add(Group* group, GroupVector a, double s, GroupVector b) {
    for (int k = 0; k < group->body_count; k++) {
        const GroupBody* part = &group->body[k];
        vectors()->add(part->vector[a], (real)s, part->vector[b], part->body->count);
    }
    for (int k = 0; k < group->ball_count; k++)
        for (int row = 0; row < 2; row++)
            group->ball[k].vector[a][row] += (real)s * group->ball[k].vector[b][row];
}

void group_scale_add(Group* group, GroupVector a, double s, GroupVector b) {
    for (int k = 0; k < group->body_count; k++) {
        const GroupBody* part = &group->body[k];
        vectors()->scale_add(part->vector[a], (real)s, part->vector[b], part->body->count);
    }
    for (int k = 0; k < group->ball_count; k++)
        for (int row = 0; row < 2; row++)
            group->ball[k].vector[a][row] =
                group->ball[k].vector[b][row] + (real)s * group->ball[k].vector[a][row];
}

void group_clear(Group* group, GroupVector a) {
    for (int k = 0; k < group->body_count; k++)
        memset(group->body[k].vector[a], 0,
               (size_t)group->body[k].body->count * sizeof *group->body[k].vector[a]);
    for (int k = 0; k < group->ball_count; k++)
        memset(group->ball[k].vector[a], 0, sizeof group->ball[k].vector[a]);
}

void group_set(Group* group, GroupVector a, double s, GroupVector b) {
    for (int k = 0; k < group->body_count; k++) {
        const GroupBody* part = &group->body[k];
        for (int i = 0; i < part->body->count; i++)
            part->vector[a][i] = (real)s * part->vector[b][i];
    }
    for (int k = 0; k < group->ball_count; k++)
        for (int row = 0; row < 2; row++)
            group->ball[k].vector[a][row] = (real)s * group->ball[k].vector[b][row];
}
