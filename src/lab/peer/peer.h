/// Bullet's own soft body, a peer for comparison: points joined by links, a pressure, rigid balls.
/// A C interface on flat arrays; only peer.cpp includes btSoftBody.
///
/// Bullet steps by semi-implicit Euler, v' = v + h f/m and x' = x + h v'; then rounds over the
/// links move points (position-based dynamics), and velocities follow from the positions:
///
///     link       each round corrects the fraction `stiffness` of the error of the link's length
///     pressure   f_i = (pressure / V) a_i n_i, a_i the mean (not a third of the sum) of the areas
///                of the faces around i at the first step: about half of p dV/dx
///     damping    v' = (1 - damping) (x' - x) / h, independent of h
///     contact    a point within `margin` of a ball, found once a step; triangles are not tested
///
/// Links are the triangles' edges, each once. Bullet's own mesh setup (btSoftBodyHelpers) and its
/// generateBendingConstraints allocate a table of V x V, whose 32-bit size overflows above 46,340
/// points; neither is used here, so a peer has no bending links and any number of points.
#ifndef BALLOON_LAB_PEER_PEER_H
#define BALLOON_LAB_PEER_PEER_H

#include <stdbool.h>

#include "contact/sphere.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct Peer Peer;

/// A link from a point to a fixed position. Bullet's links also resist compression, so this is a
/// rod and no string.
typedef struct PeerRod {
    int point;
    double4 to;    ///< [m]
    double length; ///< at rest [m]
} PeerRod;

typedef struct PeerDef {
    int point_count;
    const double4* point; ///< [point_count] rest positions [m]; copied
    int triangle_count;
    const int (*triangle)[3]; ///< [triangle_count] counter-clockwise seen from outside; copied
    double mass;              ///< total mass, divided equally among the points [kg]
    const bool* held;         ///< [point_count] fixed points; NULL: none
    int rod_count;
    const PeerRod* rod;  ///< [rod_count] copied
    double stiffness;    ///< kLST, 0 … 1 [1]
    double pressure;     ///< kPR, pressure times volume [J]
    double damping;      ///< kDP, 0 … 1 [1]
    double friction;     ///< kDF, times the ball's own [1]
    int position_rounds; ///< piterations
    int velocity_rounds; ///< viterations: links also change velocities, before the positions
    double margin;       ///< of points against balls and plates [m]
    double gravity;      ///< [m/s^2] downward
    double lift;         ///< acceleration of the skin alone [m/s^2] upward
} PeerDef;

/// Bullet's defaults, except for the margin, which Bullet sets to 0.25 m for every size.
PeerDef peer_def_default(void);

Peer* peer_open(const PeerDef* def);

/// Add a rigid ball; Bullet's contacts with soft bodies ignore its restitution.
void peer_add_sphere(Peer* peer, const Sphere* sphere);

/// Add a fixed plate, a box of this size behind the plane through `point`: Bullet's own planes stop no
/// soft body. normal: of unit length.
void peer_add_plate(Peer* peer, double4 point, double4 normal, double size);

/// Set kPR, pressure times volume [J].
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
