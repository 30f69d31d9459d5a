/// A system: all bodies that one method steps, and the data of each that a kick needs.
///
/// A method's kick ends with velocities that respect strain limits and contacts. A method that
/// steps each body by itself uses `system_kick`; a method with contacts inside its solve supplies
/// its own. Bodies that are asleep are skipped.
#ifndef BALLOON_SOLVE_SYSTEM_H
#define BALLOON_SOLVE_SYSTEM_H

#include "constraint/strain_limit.h"
#include "contact/contacts.h"
#include "solve/group.h"
#include "solve/joints/joints.h"

/// Cost and result of the last solve.
typedef struct SolveStats {
    int iterations;
    int products;    ///< Hessian-vector products
    double residual; ///< of the step's equation, relative [1]
    int factored;    ///< matrices factored; a kick allocates memory for nothing else
} SolveStats;

/// An equation that is not solved for so many lengths of the step and one more, each half the last, is
/// solved without its contacts, which then change the velocities after the kick. So are the other kicks
/// of the step: they would fail for the same reason.
enum { UNSOLVED_MAX = 1 };

/// The system owns the arrays; the caller owns the objects behind their pointers.
typedef struct System {
    int body_count;
    Body** body;                ///< [body_count]
    StrainLimit** strain_limit; ///< [body_count] NULL: none
    void** workspace;           ///< [body_count] the method's, for that body
    SolveStats** stats;         ///< [body_count] of the last kick
    real4** v_start;            ///< [body_count][count] velocities before the last kick [m/s]
    double whole;               ///< length of the substep that kicks divide [s]; 0: they do not
    bool* solved;               ///< [body_count] by the last kick
    int unsolved;               ///< first body whose step the last kick did not solve, or NONE
    int unsolved_in_row; ///< kicks since the last that was solved with contacts, in this step
    Groups groups;       ///< of a method whose equation contains the contacts
    Joints joints;       ///< strings between the bodies, and to knots
} System;

/// For body_count bodies, whose pointers the caller fills in.
void system_open(System* system, int body_count);

/// Call task(self, 0) … task(self, body_count - 1). Threads share the bodies where there are enough
/// of them; else the bodies come one after the other, and threads share each one's loops.
void system_for_each(const System* system, void (*task)(void* self, int body), void* self);

struct Method;

/// Kick each body by itself with method->kick_body, limit strains, then apply contacts; or each group
/// with method->kick_group, limit strains, then apply what contacts are left. See Method.kick.
bool system_kick(const struct Method* method, System* system, Contacts* contacts, double h,
                 double* drift);

void system_close(System* system);

#endif
