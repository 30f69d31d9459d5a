/// Vector operations over all bodies and balls of a group; one body alone gives the bits of the loops
/// of base/vectors.h.
#ifndef BALLOON_SOLVE_GROUP_VECTOR_H
#define BALLOON_SOLVE_GROUP_VECTOR_H

#include "solve/group.h"

/// a . b
double group_dot(const Group* group, GroupVector a, GroupVector b);

/// |r|_(1/M)
double group_inverse_mass_norm(const Group* group, GroupVector r);

/// a += s b
void group_add(Group* group, GroupVector a, double s, GroupVector b);

/// a = b + s a
void group_scale_add(Group* group, GroupVector a, double s, GroupVector b);

/// a = 0
void group_clear(Group* group, GroupVector a);

/// a = s b
void group_set(Group* group, GroupVector a, double s, GroupVector b);

#endif
