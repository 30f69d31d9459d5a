/// Forces: a table, one file and one row each. A balloon has those that its scene lists.
///
/// Every conservative force is the exact gradient of its energy, f_i = -dE/dx_i, which
/// tests/unit/test_force.c holds for every row; methods know forces only through this table.
#ifndef BALLOON_FORCE_FORCE_H
#define BALLOON_FORCE_FORCE_H

#include "base/parameter.h"
#include "body/body.h"
#include "force/block_matrix.h"
#include "force/uniform.h"

/// Groups of particles whose forces depend on each other's positions: elements, springs, faces.
typedef struct Stencils {
    int count;
    int corners;         ///< particles in a group, 4 at most
    const int* particle; ///< [count][corners], NONE for a corner that is not there
} Stencils;

typedef struct Force {
    const char* name;
    const char* about; ///< one line with the equation, for `balloon list` and the README

    /// Numbers that a scene gives as balloons.N.NAME.PARAMETER; their values are in
    /// body->force_parameter of the row. A default is 0, with which the parameter does nothing.
    const Parameter* parameters;
    int parameter_count; ///< FORCE_PARAMETERS_MAX at most
    bool exclusive;      ///< a scene gives exactly one of them; the others are 0

    /// Whether this body has this force now.
    bool (*present)(const Body* body);

    /// A row computes its force in up to three ways, whose results add up. First, sums that the
    /// shared pass over the particles' neighbors computes for it (sweep.h):
    unsigned (*sweep)(const Body* body);

    /// Second, after that pass, its share of the force that acts on all particles by one law
    /// (uniform.h).
    void (*uniform)(const Body* body, Uniform* uniform);

    /// Third, a loop of its own that adds to body->f [N].
    void (*add)(Body* body);

    /// Energy at the present positions [J], NULL for a force that has none. For `area` inflation
    /// the energy at the present, frozen pressure.
    double (*energy)(const Body* body);

    /// Upper bound on the largest squared frequency that this force adds [1/s^2], NULL where it
    /// adds no stiffness. Bounds of several forces add up (Weyl's inequality).
    double (*bound)(const Body* body);

    /// The tangent, for implicit methods, is K = -df/dx at the present positions [N/m]; tangent.h
    /// assembles it. A force that does not depend on positions has none of these.

    /// Groups of particles that K couples; they never change. NULL: K is diagonal in particles.
    Stencils (*stencils)(const Body* body);

    /// Add factor K to the matrix, block by block: slot[s][i][j] is where the block of corners i
    /// and j of stencil s is. `project` replaces each stencil's matrix by its positive semidefinite
    /// part. NULL: K is in `product` alone.
    void (*assemble)(const Body* body, double factor, bool project, const int* slot,
                     BlockMatrix* matrix);

    /// out += factor K d, for the dense part of K. NULL: there is none.
    void (*product)(const Body* body, double factor, const real4* d, real4* out);

    /// Prepare `assemble` and `product` for the present positions; NULL where they read the
    /// positions themselves.
    void (*update_tangent)(Body* body, bool project);

    /// Its energy is stored in the skin or its tethers, and counts in the output `elastic`.
    bool elastic;

    /// Its stiffness grows without limit as an element is compressed: a bound on the step may fall by
    /// any factor between two looks at it.
    bool stiffens;

    /// It acts from outside. Total force and torque of every other row vanish on a free balloon,
    /// which tests/unit/test_force.c holds.
    bool external;
} Force;

extern const Force force_gravity, force_helium, force_springs, force_torsion, force_membrane,
    force_inflation, force_lift, force_strings, force_damping;

/// Rows, in the order in which they are added.
typedef enum ForceRow {
    FORCE_GRAVITY,
    FORCE_HELIUM,
    FORCE_SPRINGS,
    FORCE_TORSION,
    FORCE_MEMBRANE,
    FORCE_INFLATION,
    FORCE_LIFT,
    FORCE_STRINGS,
    FORCE_DAMPING,
    FORCES
} ForceRow;
extern const Force* const force_table[FORCES];
extern const int force_count;

/// body->f = the sum of all present forces. [N]
void force_sum(Body* body);

/// The same, and v' = v + h f / m in the same pass.
void force_push(Body* body, double h);

/// Add one force to body->f.
void force_add(const Force* force, Body* body);

#endif
