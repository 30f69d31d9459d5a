#include "lab/peer/peer_world.h"

#include <stdlib.h>

#include "base/memory.h"
#include "force/damping.h"
#include "force/helium.h"
#include "world/probe.h"

double peer_pressure(const Mesh* mesh, double pressure, double volume, double area, double first) {
    const double faces = 3.0 * mesh->triangle_count / mesh->point_count; // at a point
    return pressure * volume * faces / 3 * area / first;
}

static double pressure_of(const World* world) {
    double pressure = 0, volume = 0;
    if (!probe_value(world, "balloon0.gauge_pressure", &pressure) ||
        !probe_value(world, "balloon0.volume", &volume))
        return 0;
    return peer_pressure(&world->balloon[0].mesh, pressure, volume, 1, 1);
}

/// Radius of the largest circle between the points of a right triangle, over all triangles: half
/// the longest edge.
static double widest_gap(const Body* body) {
    double longest = 0;
    for (int t = 0; t < body->mesh->triangle_count; t++) {
        const int* corner = body->mesh->triangle[t];
        for (int k = 0; k < 3; k++)
            longest =
                fmax(longest, (double)length(body->x[corner[k]] - body->x[corner[(k + 1) % 3]]));
    }
    return longest / 2;
}

static const double plate_sizes = 100; ///< [of the skin's] of a plane that Bullet has as a box

Peer* peer_of_world(const World* world, int position_rounds) {
    const PeerDef usual = peer_def_default();
    return peer_with_links(world, &(PeerLinks){usual.stiffness, position_rounds});
}

Peer* peer_with_links(const World* world, const PeerLinks* links) {
    const Body* body = &world->balloon[0].body;
    double4* point = new_array(double4, body->count);
    bool* held = new_array(bool, body->count);
    PeerRod* rod = new_array(PeerRod, body->string_count);
    PeerDef def = peer_def_default();
    def.mass = 0;
    for (int i = 0; i < body->count; i++) {
        point[i] = to_double4(body->x[i]);
        held[i] = body->inverse_mass[i] == 0;
        def.mass += (double)body->mass[i];
    }
    for (int k = 0; k < body->string_count; k++)
        rod[k] = (PeerRod){body->string[k].particle, to_double4(body->string[k].anchor),
                           (double)body->string[k].free_length};
    def.held = held;
    def.rod_count = body->string_count;
    def.rod = rod;
    def.point_count = body->count;
    def.point = point;
    def.triangle_count = body->mesh->triangle_count;
    def.triangle = (const int(*)[3])body->mesh->triangle;
    def.pressure = pressure_of(world);
    def.damping = fmin(1, damping_drag(body, 0) / (double)body->mass[0] * world->step);
    def.stiffness = links->stiffness;
    def.position_rounds = links->rounds;
    def.margin = world->contacts.sphere_count > 0 ? widest_gap(body) : 0;
    def.gravity = world->contacts.gravity;
    def.lift = helium_acceleration(body);
    Peer* peer = peer_open(&def);
    for (int s = 0; s < world->contacts.sphere_count; s++)
        peer_add_sphere(peer, &world->contacts.sphere[s]);
    for (int k = 0; k < world->contacts.plane_count; k++)
        peer_add_plate(peer, world->contacts.plane[k].point, world->contacts.plane[k].normal,
                       plate_sizes * body->size);
    free(point);
    free(held);
    free(rod);
    return peer;
}
