/// Contacts between balls and skins, and the impulses that keep them apart, many solved together.
///
/// A contact is a ball, a triangle, the point p = sum w_k x_k of the triangle nearest the ball's
/// centre c, the unit normal n from p to c and the gap |c - p| - radius. With u the ball's velocity
/// at p less the skin's, the impulse P on the ball and -w_k P on the triangle's particles is such
/// that in the coming drift of length h
///
///     n.u' >= -gap / h             the ball comes no nearer than touching
///     n.u' >= -restitution n.u     where it first hits, faster than a contact at rest is kicked
///     |P_t| <= friction P_n        Coulomb, against the sliding u_t
///
/// Equal and opposite at one point, for c lies on the normal through p: linear and angular momentum
/// are kept to rounding. The normal part without restitution is the least of a quadratic function
/// whose value is the change of kinetic energy, so it never rises; where restitution or the way out
/// of an overlap would raise it, they are scaled back.
/// Method: projected Gauss-Seidel on the impulses (Jean and Moreau's contact dynamics).
#ifndef BALLOON_CONTACT_CONTACT_H
#define BALLOON_CONTACT_CONTACT_H

#include "body/body.h"
#include "contact/sphere.h"

typedef struct Contact {
    // what every round reads
    Sphere* sphere;
    Body* body;
    int particle[3]; ///< corners of the triangle
    real weight[3];  ///< w, sum 1
    real share[3];   ///< w_k / m_k: what an impulse changes a particle's velocity by [1/kg]
    real give;       ///< mass that a normal impulse meets [kg]
    real floor;      ///< least n.u' that is asked for [m/s]
    real push;       ///< normal impulse so far [N s]
    real4 normal;    ///< n, from the skin to the ball's centre
    // and what those that push need
    real4 arm;     ///< p - c [m]
    real4 rub;     ///< tangential impulse so far [N s]
    real grip;     ///< mass that a tangential impulse meets [kg]
    real free;     ///< 1 / the ball's mass [1/kg]
    real turn;     ///< 1 / its moment of inertia [1/(kg m^2)]
    bool resting;  ///< it did not push in the last round that looked at it
    bool first;    ///< the ball did not touch this skin before: restitution applies
    real least;    ///< approach below which it does not bounce [m/s]
    int triangle;  ///< of the body's mesh
    int pair;      ///< the caller's number of ball and skin
    real gap;      ///< [m] less than 0 where they overlap
    real wanted;   ///< least n.u' that is asked for beyond -gap/h [m/s]
    real4 arrival; ///< u before the solve [m/s]
} Contact;

/// What a solve did, for tests and the overlay.
typedef struct ContactReport {
    int rounds;     ///< sweeps over all contacts
    double kinetic; ///< change of kinetic energy, never above 0 but for rounding [J]
    double moved;   ///< kinetic energy that went either way between balls and skins [J]
    double rounded; ///< what roundings may have added to the change [J]
} ContactReport;

/// The contact of a ball with a triangle as they are now. Where the centre lies in the triangle's
/// plane the normal is the triangle's, times `side`.
Contact contact_make(Sphere* sphere, Body* body, int triangle, real side);

/// Change velocities and spins so that the drift of length h meets the conditions above.
ContactReport contact_solve(Contact* contact, int count, double h);

/// u: the ball's velocity at the contact's point less the skin's.
real4 contact_approach(const Contact* contact);

#endif
