/// The kinds of pairs that can touch: one file and one row each.
///
/// A row states the time until the pair must be tested again (conservative advancement), adds its
/// contacts to the list that contact_solve solves, and shortens the drift if the solve raised speeds. A
/// function that a pair does not need is NULL: balls among themselves and on planes are found and
/// solved by Bullet, and particles on planes have a closed form. A further pair of a ball needs a
/// file, a row here and contacts in the list; without a ball nothing but `stop` is called.
#ifndef BALLOON_CONTACT_PAIR_H
#define BALLOON_CONTACT_PAIR_H

#include "contact/contacts.h"

typedef struct PairRow {
    const char* name;
    const char* about;

    /// How long a ball may go until the pair must be looked at again [s]: at most `safe`, the
    /// minimum over the rows and balls before; h is the whole step that was asked for.
    double (*safe_step)(Contacts* contacts, int ball, double h, double safe);

    /// Add the contacts that may touch in a drift of length h to the list.
    void (*gather)(Contacts* contacts, double h);

    /// Closed form, without the list: change velocities for a drift of length h. Returns whether any
    /// changed.
    bool (*stop)(Contacts* contacts, double h);

    /// How much of h may be drifted after the solve.
    double (*limit_drift)(Contacts* contacts, double h);
} PairRow;

extern const PairRow pair_ball_plane, pair_ball_ball, pair_ball_skin, pair_skin_plane;

enum { PAIR_ROWS = 4 };
extern const PairRow* const pair_table[PAIR_ROWS];

/// [radii] by which the two may come nearer than touching in a substep.
static const double pair_max_overlap = 0.5;

/// At most `safe`, and so long that two, `gap` apart, come no nearer than touching by more than that
/// share of `radius` [s].
static inline double pair_safe_time(double safe, double gap, double radius, double speed) {
    return speed > 0 ? fmin(safe, fmax(pair_max_overlap * radius, gap) / speed) : safe;
}

#endif
