/// The peer of a world: its first balloon and its balls as Bullet's own soft body has them.
#ifndef BALLOON_LAB_PEER_WORLD_H
#define BALLOON_LAB_PEER_WORLD_H

#include "lab/peer.h"
#include "world/world.h"

/// The same triangles, mass, gravity, drag and pressure force as in the world's present state.
/// What the two do not share is taken in the peer's favour: links as stiff as Bullet has them, and
/// a margin that leaves no gap between the points of a triangle for a ball to slip through.
Peer* peer_of_world(const World* world, int position_rounds);

#endif
