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

/// Stencils: groups of particles whose forces depend on each other's positions, such as elements,
/// springs, faces.
typedef struct Stencils {
    int count;
    int corners;         ///< particles of a stencil, at most 4
    const int* particle; ///< [count][corners], NONE for a missing corner
} Stencils;

typedef struct Force {
    const char* name;
    const char* about; ///< one line with the equation, for `balloon list` and the README

    /// Numbers that a scene sets as balloons.N.NAME.PARAMETER; their values are in
    /// body->force_parameter of the row. Defaults are 0, the value without effect.
    const Parameter* parameters;
    int parameter_count; ///< FORCE_PARAMETERS_MAX at most
    bool exclusive;      ///< a scene sets exactly one of them; the others are 0

    /// Whether this body has this force now.
    bool (*present)(const Body* body);

    /// A row computes its force in up to three ways, whose results are added. First, by the shared
    /// pass over the particles' neighbors: returns the flags of the sums that it needs (sweep.h).
    unsigned (*sweep)(const Body* body);

    /// Second, after that pass, by its terms of the uniform forces (uniform.h).
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

    /// Stencils of K; they never change. NULL: K couples no two particles.
    Stencils (*stencils)(const Body* body);

    /// Add factor K to the matrix: block_at[s][i][j] is the index of the block of corners i and j
    /// of stencil s. `project` replaces each stencil's matrix by its positive semidefinite part.
    /// NULL: K is in `product` alone.
    void (*assemble)(const Body* body, double factor, bool project, const int* block_at,
                     BlockMatrix* matrix);

    /// out += factor K d, for the dense part of K. NULL: there is none.
    void (*product)(const Body* body, double factor, const real4* d, real4* out);

    /// Prepare `assemble` and `product` for the present positions; NULL where they read the
    /// positions themselves.
    void (*update_tangent)(Body* body, bool project);

    /// Its energy is stored in the skin or its strings, and counts in the output `elastic`.
    bool elastic;

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
