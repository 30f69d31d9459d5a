/// The peer of a world: its first balloon and its balls as Bullet's own soft body has them.
#ifndef BALLOON_LAB_PEER_PEER_WORLD_H
#define BALLOON_LAB_PEER_PEER_WORLD_H

#include "lab/peer/peer.h"
#include "world/world.h"

/// The same triangles, mass, held points, gravity, helium's lift, drag, strings as rods and
/// pressure force as in the world's present state. What the two do not share is taken in the peer's
/// favour: links as stiff as Bullet has them, and a margin that leaves no gap between the points of
/// a triangle for a ball to slip through.
Peer* peer_of_world(const World* world, int position_rounds);

/// The same with links that are softer than that.
typedef struct PeerLinks {
    double stiffness; ///< kLST, 0 … 1 [1]
    int rounds;       ///< over all links in a step
} PeerLinks;

Peer* peer_with_links(const World* world, const PeerLinks* links);

/// What Bullet's pressure must be for its force on the skin's points to be p dV/dx: it takes the
/// mean area of the faces around a point, not a third of their sum, and takes it at the first step.
/// area, first: of the skin now and then [m^2]
double peer_pressure(const Mesh* mesh, double pressure, double volume, double area, double first);

#endif
