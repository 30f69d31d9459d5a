/// Corners and edges that triangles share: each belongs to the first triangle that has it.
///
/// A ball over a corner has the same nearest point on all triangles around it. One contact is
/// enough: that of the owner, whose nearest point is the corner or a nearer point.
#ifndef BALLOON_CONTACT_SHARED_FEATURE_H
#define BALLOON_CONTACT_SHARED_FEATURE_H

#include "contact/contact.h"
#include "mesh/mesh.h"

/// What a triangle owns: bit k for corner k, bit 3 + k for the edge from corner k to the next.
/// [triangle_count], allocated.
unsigned char* shared_feature_owners(const Mesh* mesh);

/// Whether the contact's triangle owns the corner, edge or inside where the contact is.
bool shared_feature_owned(const Contact* contact, const unsigned char* owners);

#endif
