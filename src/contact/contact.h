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
/// P and -P act along one line through p, so linear and angular momentum are kept to rounding. The
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

/// Five cache lines in float: a list of contacts is longer than the first cache.
typedef struct Contact {
    // the stencil: all that the solver knows of the two sides
    ContactNode node[CONTACT_NODES];
    ContactLever lever[CONTACT_LEVERS];
    int node_count;
    int lever_count;       ///< of the first nodes, which are rigid
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
