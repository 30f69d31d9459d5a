/// How far the points of skins have moved: bounds by which lists and pairs stay known.
///
/// Two bounds, a cheap and a tight one. The cheap one is of the boxes of the particles' velocities
/// and summed over drifts: one pass over the velocities a drift. The tight one is of the positions now
/// beside those when a list was made.
#ifndef BALLOON_CONTACT_SKINS_SKIN_MOTION_H
#define BALLOON_CONTACT_SKINS_SKIN_MOTION_H

#include "body/body.h"

struct Contacts;

/// Motion of a skin since the start, as bounds that grow. Lists remember where they began.
///
/// From x to x' = x + shift + d with |d| <= path; and also x' = c + A (x - c) + shift + d with
/// |d| <= residual, where A stretches each axis by `stretch` or more, at most 1. Two points of one
/// skin that were r apart are thus at least stretch r - 2 residual apart.
typedef struct SkinMotion {
    double4 shift;   ///< [m]
    double path;     ///< [m]
    double stretch;  ///< [1]
    double residual; ///< [m]
} SkinMotion;

/// What contacts between skins need of one skin.
typedef struct TouchingSkin {
    double rest_gap; ///< from a skin like itself; 0: a thing [m]
    double scale;    ///< mean length of an edge at the start [m]
    bool squeezed;   ///< its features are far nearer to others than they should be
    bool fitted;     ///< its boxes and its reference are of now
    double ahead;    ///< `motion` is that up to x + ahead v; NaN: of no use any more [s]
    SkinMotion motion;
    real4* reference;            ///< [count] positions when a list of it was last made [m]
    SkinMotion reference_motion; ///< the motion up to then
    double4 velocity;            ///< of the middle of the box of the particles' velocities [m/s]
    double spread;               ///< no velocity differs more from it [m/s]
    double coordinate_max;       ///< bound on the coordinates of its particles [m]
    bool has_ends; ///< impact zones have decided where its particles are after the coming drift
    real4* end;    ///< [count] there; NULL until that is so for the first time [m]
} TouchingSkin;

/// The motion of skin b up to the positions x + ahead v.
const SkinMotion* skin_motion_measure(struct Contacts* contacts, int b, double ahead);

/// Measure the boxes of the velocities.
void skin_motion_measure_velocities(struct Contacts* contacts);

/// Bound on the relative motion of any two points of skins a and b, or of one, in a drift of length h
/// at the velocities last measured, as the state's precision stores it [m].
double skin_motion_relative(const struct Contacts* contacts, int a, int b, double h);

/// Where particle i of skin b is after a drift of length h, as the state's precision stores it.
real4 skin_motion_end(const struct Contacts* contacts, int b, int i, double h);

/// Skin b has drifted by h at the velocities last measured.
void skin_motion_drifted(struct Contacts* contacts, int b, double h);

#endif
