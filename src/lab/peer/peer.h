/// Bullet's own soft body, as a peer to measure ours against: points joined by links, a pressure,
/// rigid balls. A C face on flat arrays; peer.cpp alone sees btSoftBody.
///
/// Bullet steps by semi-implicit Euler, v' = v + h f/m and x' = x + h v'; then rounds over the
/// links move points (position-based dynamics), and the velocity is what the points moved:
///
///     link       each round moves both ends along it by `stiffness` of what its length is off
///     pressure   f_i = (pressure / V) a_i n_i, a_i the mean (not the third of the sum) of the
///     areas
///                that the faces around i had at the first step: about half of p dV/dx
///     damping    v' = (1 - damping) (x' - x) / h, whatever h is
///     contact    a point within `margin` of a ball, found once a step: triangles are not looked at
///
/// Links are the triangles' edges, each once. Bullet's own mesh set-up (btSoftBodyHelpers) and its
/// generateBendingConstraints keep a table of V x V and overflow its 32-bit size above 46,340
/// points; neither is used here, so a peer has no bending links and any number of points.
#ifndef BALLOON_LAB_PEER_PEER_H
#define BALLOON_LAB_PEER_PEER_H

#include <stdbool.h>

#include "contact/sphere.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct Peer Peer;

/// A link from a point to a fixed place. Bullet's links also push: it is a rod, no string.
typedef struct PeerRod {
    int point;
    double4 to;    ///< [m]
    double length; ///< at rest [m]
} PeerRod;

typedef struct PeerDef {
    int point_count;
    const double4* point; ///< [point_count] where the points are at rest [m]; copied
    int triangle_count;
    const int (*triangle)[3]; ///< [triangle_count] counter-clockwise seen from outside; copied
    double mass;              ///< of all points together, shared equally [kg]
    const bool* held;         ///< [point_count] points that stay where they are; NULL: none
    int rod_count;
    const PeerRod* rod;  ///< [rod_count] copied
    double stiffness;    ///< kLST, 0 … 1 [1]
    double pressure;     ///< kPR, pressure times volume [J]
    double damping;      ///< kDP, 0 … 1 [1]
    double friction;     ///< kDF, times the ball's own [1]
    int position_rounds; ///< piterations
    int velocity_rounds; ///< viterations: links also change velocities, before the positions
    double margin;       ///< of points against balls [m]
    double gravity;      ///< [m/s^2] downward
    double lift;         ///< of the skin alone [m/s^2] upward
} PeerDef;

/// Bullet's own values, but for the margin, which there is 0.25 m whatever the size.
PeerDef peer_def_default(void);

Peer* peer_open(const PeerDef* def);

/// A rigid ball; of its restitution Bullet's contacts with soft bodies know nothing.
void peer_add_sphere(Peer* peer, const Sphere* sphere);

/// kPR from now on, pressure times volume [J].
void peer_set_pressure(Peer* peer, double pressure);

void peer_step(Peer* peer, double h);

/// x [point_count] positions and v [point_count] velocities; either may be NULL.
void peer_read(const Peer* peer, double4* x, double4* v);

/// Position and velocity of ball number `sphere`.
void peer_read_sphere(const Peer* peer, int sphere, double4* x, double4* v);

/// Points that touched a ball in the last step.
int peer_contacts(const Peer* peer, int sphere);

/// Enclosed volume [m^3].
double peer_volume(const Peer* peer);

void peer_close(Peer* peer);

#ifdef __cplusplus
}
#endif

#endif
