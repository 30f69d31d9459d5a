/// A contact and the solver of all contacts together.
///
/// A contact is a stencil of nodes with signed weights w_k: the ball's centre with +1, the corners
/// of a triangle with minus the barycentric weights of the point p of the triangle nearest the
/// centre c. n is the unit normal from p to c, the gap is |c - p| - radius, and
///
///     u = sum_k w_k v_k + spin x (p - c)
///
/// is the velocity of the ball at p relative to the skin. An impulse P at p changes v_k by
/// w_k / m_k P and the spin by (p - c) x P / I. The solver finds impulses such that in the coming
/// drift of length h
///
///     n.u' >= -gap / h             the two do not overlap at the end of the drift
///     n.u' >= -restitution n.u     at a first hit faster than min_bounce_speed
///     |P_t| <= friction P_n        Coulomb's law; P_t acts against the tangential part of u
///
/// P and -P act along one line through p, so linear and angular momentum are kept to rounding. The
/// normal impulses without restitution minimize the kinetic energy under the first condition, so
/// the energy does not rise; where restitution or the separation of an overlap would raise it, the
/// solver scales both down.
/// Method: projected Gauss-Seidel on the impulses (Jean and Moreau's contact dynamics).
#ifndef BALLOON_CONTACT_CONTACT_H
#define BALLOON_CONTACT_CONTACT_H

#include "body/body.h"
#include "contact/sphere.h"

enum { CONTACT_NODES = 4 };

typedef struct Contact {
    // the stencil: all that the solver knows of the two sides
    real4* velocity[CONTACT_NODES];   ///< of the ball's centre and of the triangle's corners
    real weight[CONTACT_NODES];       ///< w: 1, and three of sum -1
    real inverse_mass[CONTACT_NODES]; ///< w_k / m_k: velocity change per impulse [1/kg]
    real4* spin;                      ///< angular velocity of the ball
    real4 lever_arm;                  ///< p - c [m]
    real inverse_inertia;             ///< 1 / the ball's moment of inertia [1/(kg m^2)]
    real4 normal;                     ///< n
    real gap;                         ///< [m] less than 0 where they overlap
    real friction;                    ///< Coulomb's coefficient
    real restitution;                 ///< Newton's coefficient, of a first hit
    bool first;                       ///< the pair did not touch before: restitution applies
    real min_bounce_speed;            ///< a first hit with a slower approach does not bounce [m/s]
    // state of the solver
    real normal_mass;          ///< effective mass along n [kg]
    real tangent_mass;         ///< effective mass across n [kg]
    real normal_impulse;       ///< accumulated P_n; at the start the warm start [N s]
    real4 tangent_impulse;     ///< accumulated P_t [N s]
    real4 initial_velocity;    ///< u before the solve [m/s]
    real separation_speed;     ///< n.u' asked for beyond -gap / h, before scaling [m/s]
    real min_separation_speed; ///< lower bound of n.u' in this solve [m/s]
    bool inactive;             ///< its impulse was 0 when last visited
    // where it came from: for collision detection and the warm start
    Sphere* sphere;
    Body* body;
    int particle[3]; ///< corners of the triangle
    int triangle;    ///< of the body's mesh
    int pair;        ///< the caller's number of ball and skin
} Contact;

/// Result of a solve, for tests and the overlay.
typedef struct ContactReport {
    int iterations; ///< passes over the contacts
    double kinetic; ///< change of kinetic energy, at most 0 but for rounding [J]
    double moved;   ///< kinetic energy exchanged between the sides, in either direction [J]
    double rounded; ///< bound on the rounding error of `kinetic` [J]
} ContactReport;

/// The contact of a ball with a triangle at the present positions. Where the centre lies in the
/// triangle's plane, the normal is the triangle's times `side`.
Contact contact_make(Sphere* sphere, Body* body, int triangle, real side);

/// Change velocities and spins so that the drift of length h meets the conditions above.
ContactReport contact_solve(Contact* contact, int count, double h);

/// u, the relative velocity at the contact point.
real4 contact_relative_velocity(const Contact* contact);

#endif
