/// Groups: bodies, balls and contacts that one equation couples.
///
/// A method whose step contains the contacts (Method.kick_group) solves each group as one system. A
/// group has the bodies of one island of contacts, the balls of that island and its contacts; a body
/// that touches nothing is a group of its own. An island of balls alone is no group: contacts_finish
/// solves it.
#ifndef BALLOON_SOLVE_GROUP_H
#define BALLOON_SOLVE_GROUP_H

#include "contact/contacts.h"
#include "solve/contact_terms.h"

struct System;

typedef struct Group {
    GroupBody* body; ///< [body_count] in ascending order
    int body_count;
    GroupBall* ball; ///< [ball_count] in ascending order
    int ball_count;
    ContactTerm* term; ///< [term_count]
    int term_count;
    bool solved; ///< by the last kick
} Group;

/// All groups of a system; the arrays grow to what the largest lists need.
typedef struct Groups {
    int count;
    Group* group;      ///< [count] in the order of their first bodies
    GroupBody* body;   ///< group after group
    GroupBall* ball;   ///< group after group
    ContactTerm* term; ///< island after island
    int side_capacity, term_capacity;
    int* group_of;        ///< [sides] group of a ball or a body, or NONE
    int* group_of_island; ///< [islands] or NONE
    int* from;            ///< [sides + 1]
    int* item;            ///< [sides] sides sorted by groups
    int* location;        ///< [sides] number among the balls or the bodies of its group
} Groups;

/// Capacity for body_count bodies without balls and contacts.
void groups_open(Groups* groups, int body_count);

/// The groups of the awake bodies for the contacts that contacts_begin listed.
void groups_find(Groups* groups, const struct System* system, Contacts* contacts);

/// Take the contacts out of a group's equation; their impulses are 0.
void group_forget_contacts(Group* group);

void groups_close(Groups* groups);

#endif
