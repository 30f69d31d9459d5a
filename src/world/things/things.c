#include "world/things/things.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "contact/skins/crossings.h"
#include "mesh/load.h"
#include "world/balloon_check.h"
#include "world/things/path_points.h"

/// Bounding box of a mesh: its middle, and its sides.
static void box_of(const Mesh* mesh, double4* middle, double4* side) {
    double4 low = mesh->point[0], high = low;
    for (int i = 1; i < mesh->point_count; i++)
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], mesh->point[i][k]);
            high[k] = fmax(high[k], mesh->point[i][k]);
        }
    *middle = 0.5 * (low + high);
    *side = high - low;
}

/// Height of a point of the shape `capsule` (radius 1, length 4) when it is stretched to `size` with
/// ends that stay round.
static double capsule_height(double y, const double size[3]) {
    const double diameter = fmin(size[1], fmax(size[0], size[2]));
    const double straight = (size[1] - diameter) / 2, cap = fabs(y) - 1;
    return cap < 0 ? y * straight : copysign(straight + cap * diameter / 2, y);
}

/// Stretch the mesh to its size, about the middle of its box.
static void stretch(const ThingDef* def, const Mesh* mesh) {
    double4 middle, side;
    box_of(mesh, &middle, &side);
    const bool capsule =
        strncmp(def->model, "capsule", strlen("capsule")) == 0 && !mesh_format_of(def->model);
    for (int i = 0; i < mesh->point_count; i++) {
        double4* p = &mesh->point[i];
        *p -= middle;
        const double height = capsule_height((*p)[1], def->size);
        for (int k = 0; k < 3; k++)
            (*p)[k] *= side[k] > 0 ? def->size[k] / side[k] : 1; // a flat sheet stays flat
        if (capsule)
            (*p)[1] = height;
    }
}

static const double speed_max = 50; ///< [m/s] of any point: what contacts stop without a crossing

/// NULL: the origin.
static const double* position_of(const ThingDef* def) {
    return def->path_count > 0 ? def->path[0].position : def->position;
}

/// Move the mesh's points to where the thing begins.
static void place(const ThingDef* def, const Mesh* mesh) {
    if (def->size)
        stretch(def, mesh);
    const double* to = position_of(def);
    double4 own = {0}, first = {0}; // rotations: the thing's, and then its path's at the start
    for (int k = 0; k < 3; k++) {
        own[k] = def->rotation ? def->rotation[k] * PI / 180 : 0;
        first[k] =
            def->path_count > 0 && def->path[0].rotation ? def->path[0].rotation[k] * PI / 180 : 0;
    }
    for (int i = 0; i < mesh->point_count; i++) {
        double4 p = path_rotate(first, path_rotate(own, def->scale * mesh->point[i]));
        for (int k = 0; to && k < 3; k++)
            p[k] += to[k];
        mesh->point[i] = p;
    }
}

static bool open_thing(World* world, unsigned number, Fault* fault) {
    const ThingDef* def = &world->def.things[number];
    char path[512], name[40];
    snprintf(name, sizeof name, "things.%u", number);
    Mesh mesh;
    MeshReport report = {0};
    if (!scene_model_path(&world->def, def->model, path, fault) ||
        !mesh_load(path, &mesh, &report, fault))
        return false;
    place(def, &mesh);
    PathPoint* point = path_points(def->path, def->path_count);
    Thing* thing = &world->thing[number];
    const double* to = position_of(def);
    const double4 origin = to ? (double4){to[0], to[1], to[2], 0} : (double4){0};
    thing_make(thing, &mesh, (real)def->friction, origin, point, (int)def->path_count);
    world->thing_count++;
    free(point);
    if (!balloon_check_position(&thing->body, world->def.file, name, fault))
        return false;
    const double fastest = path_fastest(thing->path, thing->path_count, thing->radius);
    if (!(fastest <= speed_max))
        return fault_set(fault, world->def.file,
                         "%s.path: a point %.3g m from its middle would move at up to %.3g m/s; "
                         "a path is followed at %g m/s at most; give it more time",
                         name, thing->radius, fastest, speed_max);
    for (int b = 0; b < world->balloon_count; b++)
        if (crossings_any(&world->balloon[b].body, &thing->body))
            return fault_set(fault, world->def.file,
                             "%s (%s) crosses the skin of balloons.%d (%s) at the start; move one "
                             "of them",
                             name, def->model, b, world->balloon[b].def->model);
    return true;
}

/// Whether each pin reaches a particle, and not all are held.
static bool check_pins(const Balloon* balloon, const char* location, int number, Fault* fault) {
    const Body* body = &balloon->body;
    bool free_left = balloon->def->pins_count == 0;
    for (int i = 0; i < body->count; i++)
        free_left |= body->inverse_mass[i] > 0;
    if (!free_left)
        return fault_set(fault, location, "balloons.%d.pins: they hold all particles of %s", number,
                         balloon->def->model);
    for (unsigned k = 0; k < balloon->def->pins_count; k++) {
        const PinDef* pin = &balloon->def->pins[k];
        int count = 0;
        for (int i = 0; i < body->count; i++)
            count += body_is_near(body, i, pin->at, pin->radius);
        if (count == 0)
            return fault_set(fault, location,
                             "balloons.%d.pins.%u: no particle of %s is within %g m of %g, %g, %g",
                             number, k, balloon->def->model, pin->radius, pin->at[0], pin->at[1],
                             pin->at[2]);
    }
    return true;
}

bool things_open(World* world, Fault* fault) {
    if (world->def.things_count > 0 && world->def.contact == CONTACT_PAPER)
        return fault_set(
            fault, world->def.file,
            "things: the penalty `contact: paper` knows no things; take `contact: impulse`");
    world->thing = new_array(Thing, world->def.things_count);
    for (unsigned k = 0; k < world->def.things_count; k++)
        if (!open_thing(world, k, fault))
            return false;
    for (int b = 0; b < world->balloon_count; b++)
        if (!check_pins(&world->balloon[b], world->def.file, b, fault))
            return false;
    return true;
}

/// A particle that several pins reach is held by the first.
static void add_pin(World* world, Body* body, const PinDef* def) {
    Pins* pins = &world->contacts.pins;
    for (int i = 0; def->to_thing && i < body->count; i++)
        if (body_is_near(body, i, def->at, def->radius) && !pins_thing(pins, &body->x[i]))
            pins_add(pins, body, i, &world->thing[(int)*def->to_thing]);
}

void things_begin(World* world) {
    for (int k = 0; k < world->thing_count; k++)
        thing_reset(&world->thing[k]);
    if (world->thing_count > 0)
        contacts_add_things(&world->contacts, world->thing, world->thing_count);
    for (int b = 0; b < world->balloon_count; b++)
        for (unsigned k = 0; k < world->balloon[b].def->pins_count; k++)
            add_pin(world, &world->balloon[b].body, &world->balloon[b].def->pins[k]);
}

void things_notice(World* world) {
    for (int k = 0; k < world->thing_count; k++) {
        Thing* thing = &world->thing[k];
        if (thing->delay <= 0 || thing->said)
            continue;
        thing->said = true;
        snprintf(world->notice, sizeof world->notice,
                 "things.%d is held up at %.3g s: it would press a skin to nothing, and moves on "
                 "when that gives way",
                 k, world_time(world));
    }
}

void things_close(World* world) {
    for (int k = 0; k < world->thing_count; k++)
        thing_close(&world->thing[k]);
    free(world->thing);
}
