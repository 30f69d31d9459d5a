/// A contact and the solver of all contacts together.
///
/// A contact is a stencil of nodes with signed weights w_k: a ball's centre with +1; against it the
/// corners of a triangle with minus the barycentric weights of the point p of the triangle nearest
/// the centre, another ball's centre with -1, or nothing, where a plane stands still. Only a rigid
/// node has a spin and a lever arm r_k = sign(w_k) (p - c_k) from its centre c_k to the contact
/// point p. n is the unit normal toward node 0, and
///
///     u = sum_k w_k v_k + sum_k spin_k x r_k
///
/// is the velocity of the first side at p relative to the second. An impulse P at p changes v_k by
/// w_k / m_k P and spin_k by r_k x P / I_k. The solver finds impulses such that in the coming drift
/// of length h
///
///     n.u' >= -gap / h             the two do not overlap at the end of the drift
///     n.u' >= -restitution (n.u + a) - a   at a first hit faster than min_bounce_speed
///     |P_t| <= friction P_n        Coulomb's law; P_t acts against the tangential part of u
///
/// u is the velocity in the middle of the drift, n.u + a that at its start, a the fall_speed.
/// P and -P act along one line through p, so linear and angular momentum are kept to rounding. Two
/// skins are a gap d apart when they touch, so P_t at both nearest points has the moment d n x P_t: a
/// couple takes it back by the least change of the nodes' velocities, a rigid rotation w about their
/// centre of mass c,
///
///     v_k += w x (x_k - c),   w = B P_t,   B = -I^-1 [d n]x,   I the nodes' inertia tensor
///     u = sum_k w_k v_k + B^T L,   L = sum_k m_k (x_k - c) x v_k
///
/// and u, its adjoint, is the same for any rigid motion of the nodes: two skins that roll over each
/// other together do not rub. B n = 0, so normal impulses and n.u are as without it. The
/// normal impulses without restitution minimize the kinetic energy under the first condition, so
/// the energy does not rise; where restitution or the separation of an overlap would raise it, the
/// solver scales both down. Only rigid pairs, which cannot give way, undo an overlap even so.
/// Method: projected Gauss-Seidel on the impulses (Jean and Moreau's contact dynamics).
#ifndef BALLOON_CONTACT_CONTACT_H
#define BALLOON_CONTACT_CONTACT_H

#include <stdbool.h>
#include <stdint.h>

#include "base/vec.h"

enum { CONTACT_NODES = 4, CONTACT_LEVERS = 2 };

/// A point that an impulse at the contact moves.
typedef struct ContactNode {
    real4* velocity;       ///< v_k, the owner's
    const real4* position; ///< the owner's
    real weight;           ///< w_k
    real response;         ///< w_k / m_k: velocity change per impulse [1/kg]
    real mass;             ///< m_k; INFINITY where it is held [kg]
} ContactNode;

/// Rotation of a rigid node.
typedef struct ContactLever {
    real4 arm;            ///< r_k [m]
    real4* spin;          ///< angular velocity, the owner's [rad/s]
    real inverse_inertia; ///< 1 / I_k [1/(kg m^2)]
} ContactLever;

/// The couple of a contact's tangent impulse.
typedef struct ContactCouple {
    real4 center;    ///< c [m]
    real4 column[3]; ///< of B [rad/s per N s]
} ContactCouple;

/// Five cache lines in float: a list of contacts is longer than the first cache.
typedef struct Contact {
    // the stencil: all that the solver knows of the two sides
    ContactNode node[CONTACT_NODES];
    union {
        ContactLever lever[CONTACT_LEVERS];
        ContactCouple couple; ///< where has_couple; then no node is rigid
    };
    int node_count;
    int lever_count; ///< of the first nodes, which are rigid
    bool has_couple;
    real4 normal;          ///< n
    real gap;              ///< [m] less than 0 where they overlap
    real size;             ///< [m] radius of the smaller ball
    real friction;         ///< Coulomb's coefficient
    real restitution;      ///< Newton's coefficient, of a first hit
    real min_bounce_speed; ///< a first hit with a slower approach does not bounce [m/s]
    real fall_speed;       ///< of the approach, by gravity in half of the drift [m/s]
    bool first;            ///< the pair did not touch before: restitution applies
    bool rigid;            ///< neither side gives way: an overlap is undone at any energy
    // state of the solver
    bool inactive;             ///< its impulse was 0 when last visited
    real normal_mass;          ///< effective mass along n [kg]
    real tangent_mass;         ///< effective mass across n [kg]
    real normal_impulse;       ///< accumulated P_n; at the start the warm start [N s]
    real4 tangent_impulse;     ///< accumulated P_t [N s]
    real4 initial_velocity;    ///< u before the solve [m/s]
    real bounce_speed;         ///< n.u' that a bounce asks for, before scaling [m/s]
    real overlap_speed;        ///< n.u' that undoes an overlap, before scaling [m/s]
    real min_separation_speed; ///< lower bound of n.u' in this solve [m/s]
    // where it came from: for islands and the warm start
    int side
        [2];  ///< numbers of ball and ball or skin, the skins behind the balls, then the things, of
              ///< which none is the first; NONE: a plane
    int row;  ///< of the table of pairs
    int pair; ///< of the row, in rising order
    int64_t feature; ///< of the pair, in rising order: a triangle, a plane, the second ball
} Contact;

/// Result of a solve, for tests and the overlay.
typedef struct ContactReport {
    int iterations; ///< passes over the contacts
    double kinetic; ///< change of kinetic energy, at most `allowed` [J]
    double allowed; ///< rounding error of `kinetic`, and what undoing a rigid overlap costs [J]
} ContactReport;

/// Effective masses along and across the normal, of the nodes and levers.
void contact_set_masses(Contact* contact);

/// Set the couple of a contact without levers whose sides are nearest at points `arm` apart, from the
/// second side's to the first's. None where a node is held: it takes any moment.
void contact_set_couple(Contact* contact, double4 arm);

/// What an impulse changes node k's velocity by, besides its response.
static inline real4 contact_couple_velocity(const Contact* contact, real4 impulse, int k) {
    const ContactCouple* couple = &contact->couple;
    const real4 spin = impulse[0] * couple->column[0] + impulse[1] * couple->column[1] +
                       impulse[2] * couple->column[2];
    return cross(spin, *contact->node[k].position - couple->center);
}

/// Set initial_velocity and min_separation_speed for a method that solves the contacts within its own
/// equation. Only rigid pairs bounce: a skin that gives way bounces a ball by its own elasticity.
void contact_set_bounds(Contact* contact, double h);

/// Change velocities and spins so that the drift of length h meets the conditions above, for the
/// contacts of one island.
ContactReport contact_solve(Contact* const* contact, int count, double h);

/// Speed at which an overlap of -gap is undone in a drift of length h: 0 where there is none, at most
/// 0.3 m/s, and in proportion to the overlap, so that little is left of it at the end. size: of the
/// smaller ball, INFINITY without one [m/s].
real contact_overlap_speed(real gap, real size, real h);

/// u, the relative velocity at the contact point.
real4 contact_relative_velocity(const Contact* contact);

#endif
