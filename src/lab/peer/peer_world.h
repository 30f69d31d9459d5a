/// The peer of a world: its first balloon, balls and planes as Bullet's own soft body and rigid bodies.
#ifndef BALLOON_LAB_PEER_PEER_WORLD_H
#define BALLOON_LAB_PEER_PEER_WORLD_H

#include "lab/peer/peer.h"
#include "world/world.h"

/// Triangles, mass, held points, gravity, helium's lift, drag, strings (as rods) and pressure force
/// are those of the world's present state. The other parameters favor the peer: links of Bullet's
/// maximum stiffness, and a margin that leaves no gap between the points of a triangle for a ball.
Peer* peer_of_world(const World* world, int position_rounds);

/// Stiffness and rounds of the links.
typedef struct PeerLinks {
    double stiffness; ///< kLST, 0 … 1 [1]
    int rounds;       ///< over all links in a step
} PeerLinks;

/// The same with other links.
Peer* peer_with_links(const World* world, const PeerLinks* links);

/// Bullet's kPR for which its force on the points is p dV/dx: Bullet multiplies by the mean area of
/// the faces around a point, not by a third of their sum, and by that of the first step.
/// area, first: present and first area of the skin [m^2]
double peer_pressure(const Mesh* mesh, double pressure, double volume, double area, double first);

#endif
