/// Forces: a table, one file and one row each. A balloon has those that its scene lists.
///
/// Every conservative force is the exact gradient of its energy, f_i = -dE/dx_i, which
/// tests/unit/test_force.c holds for every row; methods know forces only through this table.
#ifndef BALLOON_FORCE_FORCE_H
#define BALLOON_FORCE_FORCE_H

#include "body/body.h"

/// A 3 x 3 block of a matrix, as columns.
typedef struct Block {
    real4 column[3];
} Block;

typedef struct Force {
    const char* name;
    const char* about; ///< one line with the equation, for `balloon list` and the README

    /// Whether this body has this force now.
    bool (*present)(const Body* body);

    /// Add the force on every particle to body->f. [N]
    void (*add)(Body* body);

    /// Energy at the present positions [J], NULL for a force that has none. For `area` inflation
    /// the energy at the present, frozen pressure.
    double (*energy)(const Body* body);

    /// Upper bound on the largest squared frequency that this force adds [1/s^2], NULL where it
    /// adds no stiffness. Bounds of several forces add up (Weyl's inequality).
    double (*bound)(const Body* body);

    /// Ready `product` and `diagonal` for the present positions, for implicit methods; NULL where
    /// they read the positions themselves. `project` takes out what is not positive definite.
    void (*stiffen)(Body* body, bool project);

    /// out += K d, K = -dF/dx at the present positions [N/m]; NULL for a force that does not depend
    /// on positions.
    void (*product)(const Body* body, const real4* d, real4* out);

    /// Add K's diagonal blocks, or what of them is positive definite: a preconditioner's. NULL:
    /// none.
    void (*diagonal)(const Body* body, Block* block);

    /// What it does to free balloons, for tests: total force and torque vanish.
    bool internal;
} Force;

extern const Force force_gravity, force_helium, force_springs, force_torsion, force_membrane,
    force_inflation, force_lift, force_strings, force_damping;

/// In the order in which they are added.
extern const Force* const force_table[];
extern const int force_count;

/// body->f = the sum of all present forces.
void force_sum(Body* body);

#endif
