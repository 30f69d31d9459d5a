/// Islands of contacts: sets that share no ball and no skin with each other.
///
/// Each island is solved by itself, so that its tolerance, its iterations and its share of bounces
/// do not depend on contacts elsewhere. Planes and things are held and join nothing.
#ifndef BALLOON_CONTACT_ISLANDS_H
#define BALLOON_CONTACT_ISLANDS_H

#include "contact/contact.h"

typedef struct Islands {
    int count;
    int* start;        ///< [count + 1] of the contacts of island i, start[i] … start[i + 1] - 1
    Contact** contact; ///< island after island, in the order of the list within each
    // workspace; capacities follow the largest list and the largest number of sides so far
    int contact_capacity, side_capacity;
    int* key;    ///< [contacts] number of a contact's island
    int* order;  ///< [contacts] numbers of the contacts, island after island
    int* parent; ///< [sides] a forest over the sides; a root is its own parent
    int* island; ///< [sides] number of a root's island
} Islands;

/// Sort contacts into islands, numbered in the order of their first contacts. side_count: of the
/// numbers that contacts have for their sides; a second side from there on is held.
void islands_find(Islands* islands, Contact* contact, int count, int side_count);

/// The same where the last joined_count sides are united without contacts: the k-th of them with the
/// joined[k]-th, for joined[k] != k. Islands without contacts come last.
void islands_find_joined(Islands* islands, Contact* contact, int count, int side_count,
                         const int* joined, int joined_count);

/// Number of a side's island, or NONE if it has no contact and is not united.
int islands_of_side(const Islands* islands, int side);

/// Root of an element's tree in a forest where a root is its own parent; halves the path on the way.
int islands_root(int* parent, int element);

void islands_close(Islands* islands);

#endif
