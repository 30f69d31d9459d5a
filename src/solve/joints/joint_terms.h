/// Joints as terms of an implicit step's equation, at the positions x + h v' of its end.
///
///     M (v' - v) - h f(x + h v', v') - h F = 0,   F the forces of solve/joints/joints.h
///
/// With n the direction of a taut joint and T its tension, its tangent for velocities is
///
///     H = h^2 (k n n^T + T / |d| (1 - n n^T))                                              [kg]
///
/// positive at each end, and -H between them. The blocks at the ends join the bodies' matrices and
/// the free knots' blocks of the preconditioner; those between are products of their own.
#ifndef BALLOON_SOLVE_JOINTS_JOINT_TERMS_H
#define BALLOON_SOLVE_JOINTS_JOINT_TERMS_H

#include "solve/contact_terms.h"
#include "solve/joints/joints.h"

typedef struct JointTerm {
    const Joint* joint;
    TermNode node[2]; ///< NONE: it does not move
    Block tangent;    ///< H [kg]; zero while slack
} JointTerm;

struct Group;
struct Groups;

/// Capacity for these joints and knots, which do not change while a world is open.
void joint_terms_reserve(struct Groups* groups, const Joints* joints);

/// Write the free knots of group g to `ball`, as balls without contacts. Returns their number.
/// spheres: number of sides before the bodies'.
int joint_terms_add_knots(struct Groups* groups, Joints* joints, int spheres, int g,
                          GroupBall* ball);

/// Find the joints of each group, after its bodies and balls.
void joint_terms_find(struct Groups* groups, const Joints* joints, int spheres);

/// Subtract h F from the residual, and compute H.
void joint_terms_add_impulses(struct Group* group, double h);

/// Add H to the bodies' matrices.
void joint_terms_assemble(struct Group* group);

/// Add H of the joints at ball `number` of the group to the columns of its block.
void joint_terms_add_block(const struct Group* group, int number, double4 column[3]);

/// image += the part of A p that is not in the bodies' matrices.
void joint_terms_multiply(struct Group* group);

/// Energy of the group's joints at x + h v [J].
double joint_terms_potential(const struct Group* group, double h);

#endif
