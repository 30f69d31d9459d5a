/// Groups: bodies, balls and contacts that one equation couples.
///
/// A method whose step contains the contacts (Method.kick_group) solves each group as one system. A
/// group has the bodies of one island of contacts and joints, the balls and free knots of that island,
/// its contacts and joints; a body that touches nothing and is not joined is a group of its own. An island of balls alone is no group: contacts_finish
/// solves it.
#ifndef BALLOON_SOLVE_GROUP_H
#define BALLOON_SOLVE_GROUP_H

#include "contact/contacts.h"
#include "solve/contact_terms.h"
#include "solve/joints/joint_terms.h"

struct System;

typedef struct Group {
    GroupBody* body; ///< [body_count] in ascending order
    int body_count;
    GroupBall* ball; ///< [ball_count] balls in ascending order, then knots
    int ball_count;
    ContactTerm* term; ///< [term_count]
    int term_count;
    JointTerm* joint; ///< [joint_count]
    int joint_count;
    const Joints* joints; ///< the system's
    bool solved;          ///< by the last kick
} Group;

/// All groups of a system; the arrays grow to what the largest lists need.
typedef struct Groups {
    int count;
    Group* group;      ///< [count] in the order of their first bodies
    GroupBody* body;   ///< group after group
    GroupBall* ball;   ///< group after group
    ContactTerm* term; ///< island after island
    JointTerm* joint;  ///< group after group
    int side_capacity, term_capacity, joint_capacity;
    int* knot_location;   ///< [knots] number among the balls of its group
    int* group_of;        ///< [sides] group of a ball or a body, or NONE
    int* group_of_island; ///< [islands] or NONE
    int* from;            ///< [sides + 1]
    int* item;            ///< [sides] sides sorted by groups
    int* location;        ///< [sides] number among the balls or the bodies of its group
} Groups;

/// Capacity for body_count bodies without balls and contacts.
void groups_open(Groups* groups, int body_count);

/// The groups of the awake bodies for the contacts that contacts_begin listed.
void groups_find(Groups* groups, struct System* system, Contacts* contacts);

/// Take the contacts out of a group's equation; their impulses are 0.
void group_forget_contacts(Group* group);

void groups_close(Groups* groups);

#endif
