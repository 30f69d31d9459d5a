#include "world/outputs.h"

#include "contact/reaction.h"
#include "force/force.h"
#include "force/helium.h"
#include "force/inflation.h"
#include "force/strings.h"
#include "contact/skins/crossings.h"
#include "mesh/measure.h"
#include "world/knots/knots.h"
#include "world/things/thing_load.h"

static double kinetic(const Balloon* balloon) {
    const Body* body = &balloon->body;
    double sum = 0;
    for (int i = 0; i < body->count; i++) {
        const double4 v = to_double4(body->v[i]);
        sum += (double)body->mass[i] * ddot(v, v);
    }
    return sum / 2;
}

static double energy(const Balloon* balloon, const Force* force) {
    const Body* body = &balloon->body;
    return force->energy && force->present(body) ? force->energy(body) : 0;
}

/// Energy stored in the skin and its strings.
static double elastic(const Balloon* balloon) {
    double sum = 0;
    for (int k = 0; k < force_count; k++)
        if (force_table[k]->elastic)
            sum += energy(balloon, force_table[k]);
    return sum;
}

static double total_energy(const Balloon* balloon) {
    double sum = kinetic(balloon);
    for (int k = 0; k < force_count; k++)
        sum += energy(balloon, force_table[k]);
    return sum;
}

static double mass(const Body* body) {
    double sum = 0;
    for (int i = 0; i < body->count; i++)
        sum += (double)body->mass[i];
    return sum;
}

static double4 momentum(const Body* body) {
    double4 sum = {0, 0, 0, 0};
    for (int i = 0; i < body->count; i++)
        sum += (double)body->mass[i] * to_double4(body->v[i]);
    return sum;
}

static double4 angular_momentum(const Body* body) {
    double4 sum = {0, 0, 0, 0};
    for (int i = 0; i < body->count; i++)
        sum += (double)body->mass[i] * dcross(to_double4(body->x[i]), to_double4(body->v[i]));
    return sum;
}

static double4 center(const Body* body) {
    double4 sum = {0, 0, 0, 0};
    for (int i = 0; i < body->count; i++)
        sum += (double)body->mass[i] * to_double4(body->x[i]);
    return sum / mass(body);
}

static double volume(const Balloon* balloon) {
    return measure_volume(&balloon->mesh, balloon->body.x);
}

static double area(const Balloon* balloon) {
    return measure_area(&balloon->mesh, balloon->body.x);
}

static double lift(const Balloon* balloon) {
    const Body* body = &balloon->body;
    const double helium = mass(body) * helium_acceleration(body);
    if (!body->inflation.weighs)
        return helium;
    return helium + body->gravity * (air_density * measure_volume(body->mesh, body->x) -
                                     gas_mass(&body->inflation));
}

/// Side of the bounding box along an axis.
static double extent(const Balloon* balloon, int axis) {
    const Body* body = &balloon->body;
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < body->count; i++) {
        low = fmin(low, (double)body->x[i][axis]);
        high = fmax(high, (double)body->x[i][axis]);
    }
    return high - low;
}

static double stretch_max(const Balloon* balloon) {
    const Springs* springs = &balloon->body.springs;
    const Membrane* membrane = &balloon->body.membrane;
    double max = 0;
    for (int e = 0; e < membrane->count; e++)
        max = fmax(max, membrane_stretch(membrane, balloon->body.x, e));
    for (int s = 0; s < springs->count; s++) {
        const int* end = springs->end[s];
        const double length_now = (double)length(balloon->body.x[end[0]] - balloon->body.x[end[1]]);
        if (springs->rest[s] > 0)
            max = fmax(max, length_now / (double)springs->rest[s]);
    }
    return max;
}

static double thickness_min(const Balloon* balloon) {
    const Membrane* membrane = &balloon->body.membrane;
    double min = INFINITY;
    for (int e = 0; e < membrane->count; e++)
        min = fmin(min, membrane_thickness(membrane, balloon->body.x, e));
    return min;
}

static double rubber_volume(const Balloon* balloon) {
    return membrane_volume_ratio(&balloon->body.membrane, balloon->body.x).sum;
}

static double rubber_worst(const Balloon* balloon) {
    return membrane_volume_ratio(&balloon->body.membrane, balloon->body.x).worst;
}

/// An untied string has no tension.
static double tension(const OutputSubject* s) {
    const Body* body = &s->balloon->body;
    const Joint* joint = knots_joint(s->world, (int)(s->balloon - s->world->balloon), s->number);
    if (joint)
        return joint_tension(&s->world->system.joints, joint);
    int number = 0; // among the strings to fixed points
    for (int k = 0; k < s->number; k++)
        number += !string_joins(&s->balloon->def->strings[k]);
    return number < body->string_count ? string_tension(body, number) : 0;
}

/// A component of a ball's position or velocity; NAN for a ball that was removed.
static double sphere_component(const OutputSubject* s, bool is_velocity, int axis) {
    const Contacts* contacts = &s->world->contacts;
    if (s->number >= contacts->sphere_count)
        return (double)NAN;
    const Sphere* sphere = &contacts->sphere[s->number];
    return (double)(is_velocity ? sphere->v : sphere->x)[axis];
}

/// A component of the force of all contacts on a ball; NAN for a ball that was removed.
static double sphere_force(const OutputSubject* s, int axis) {
    const Contacts* contacts = &s->world->contacts;
    if (s->number >= contacts->sphere_count)
        return (double)NAN;
    return (double)contacts->sphere[s->number].impulse[axis] / s->world->step;
}

/// Normal force on a plane, the floor before the walls.
static double plane_force(const OutputSubject* s) {
    return reaction_of_plane(&s->world->contacts, s->number) / s->world->step;
}

/// A component of the force on a thing or, with 3 to 5, of its moment.
static double thing_force(const OutputSubject* s, int component) {
    const ThingLoad load = thing_load(s->world, s->number);
    return component < 3 ? load.force[component] : load.moment[component - 3];
}

/// A component of a knot's position, with 3 to 5 of its velocity, with 6 to 8 of its strings' force.
static double knot_component(const OutputSubject* s, int component) {
    const Joints* joints = &s->world->system.joints;
    const Sphere* point = &joints->knot[s->number].point;
    if (component < 6)
        return (double)(component < 3 ? point->x : point->v)[component % 3];
    double sum = 0;
    for (int k = 0; k < joints->count; k++)
        if (joints->joint[k].end[1].body == NONE && joints->joint[k].end[1].number == s->number)
            sum -= (double)joint_force(joints, &joints->joint[k], 0)[component - 6];
    return sum;
}

// clang-format off
#define SUBJECT const OutputSubject* s
static double seconds(SUBJECT) { return world_time(s->world); }
static double taken_back(SUBJECT) { return (double)s->world->guard.taken_back; }
static double pass_throughs(SUBJECT) { return (double)s->world->contacts.pass_throughs; }
static double crossings(SUBJECT) { return crossings_find(&s->world->contacts, false).count; }
static double x(SUBJECT) { return sphere_component(s, false, 0); }
static double y(SUBJECT) { return sphere_component(s, false, 1); }
static double z(SUBJECT) { return sphere_component(s, false, 2); }
static double vx(SUBJECT) { return sphere_component(s, true, 0); }
static double vy(SUBJECT) { return sphere_component(s, true, 1); }
static double vz(SUBJECT) { return sphere_component(s, true, 2); }
static double fx(SUBJECT) { return sphere_force(s, 0); }
static double fy(SUBJECT) { return sphere_force(s, 1); }
static double fz(SUBJECT) { return sphere_force(s, 2); }
static double thing_fx(SUBJECT) { return thing_force(s, 0); }
static double thing_fy(SUBJECT) { return thing_force(s, 1); }
static double thing_fz(SUBJECT) { return thing_force(s, 2); }
static double thing_mx(SUBJECT) { return thing_force(s, 3); }
static double thing_my(SUBJECT) { return thing_force(s, 4); }
static double thing_mz(SUBJECT) { return thing_force(s, 5); }
static double knot_x(SUBJECT) { return knot_component(s, 0); }
static double knot_y(SUBJECT) { return knot_component(s, 1); }
static double knot_z(SUBJECT) { return knot_component(s, 2); }
static double knot_vx(SUBJECT) { return knot_component(s, 3); }
static double knot_vy(SUBJECT) { return knot_component(s, 4); }
static double knot_vz(SUBJECT) { return knot_component(s, 5); }
static double knot_fx(SUBJECT) { return knot_component(s, 6); }
static double knot_fy(SUBJECT) { return knot_component(s, 7); }
static double knot_fz(SUBJECT) { return knot_component(s, 8); }
#undef SUBJECT

#define BALLOON const Balloon* b
static double amount(BALLOON) { return b->body.inflation.amount; }
static double iterations(BALLOON) { return b->stats.iterations; }
static double products(BALLOON) { return b->stats.products; }
static double residual(BALLOON) { return b->stats.residual; }
static double px(BALLOON) { return momentum(&b->body)[0]; }
static double py(BALLOON) { return momentum(&b->body)[1]; }
static double pz(BALLOON) { return momentum(&b->body)[2]; }
static double lx(BALLOON) { return angular_momentum(&b->body)[0]; }
static double ly(BALLOON) { return angular_momentum(&b->body)[1]; }
static double lz(BALLOON) { return angular_momentum(&b->body)[2]; }
static double width(BALLOON) { return extent(b, 0); }
static double height(BALLOON) { return extent(b, 1); }
static double depth(BALLOON) { return extent(b, 2); }
static double cx(BALLOON) { return center(&b->body)[0]; }
static double cy(BALLOON) { return center(&b->body)[1]; }
static double cz(BALLOON) { return center(&b->body)[2]; }

static bool closed(BALLOON) { return b->mesh.closed; }
static bool inflated(BALLOON) { return b->body.inflation.law != INFLATE_NONE; }
static bool lifted(BALLOON) { return b->def->force[FORCE_HELIUM] || b->body.inflation.weighs; }
static bool elastic_skin(BALLOON) { return b->def->skin.springs || b->def->skin.membrane; }
static bool thick(BALLOON) { return b->def->skin.membrane != NULL; }
static bool gassy(BALLOON) { return b->body.inflation.law == INFLATE_GAS; }
static bool iterated(BALLOON) { return b->method->iterates; }
static bool multiplied(BALLOON) { return b->method->multiplies; }
#undef BALLOON

const char* const output_prefix[OUTPUT_KINDS] = {
    [OF_TIME] = "",
    [OF_BALLOON] = "balloonN.",
    [OF_STRING] = "balloonN.stringK.",
    [OF_SPHERE] = "sphereN.",
    [OF_SPHERES] = "",
    [OF_FLOOR] = "floor.",
    [OF_WALL] = "wallN.",
    [OF_THING] = "thingN.",
    [OF_KNOT] = "knotN.",
    [OF_SKINS] = "",
    [OF_GUARD] = "guard.",
};

#define Q(has, of) OF_BALLOON, .present = has, .of_balloon = of
const Output output_table[] = {
    {"t", "s", "simulated time", OF_TIME, .value = seconds},
    {"volume", "m^3", "volume that the skin encloses", Q(closed, volume)},
    {"area", "m^2", "area of the skin", Q(NULL, area)},
    {"gauge_pressure", "Pa", "pressure on the skin, above the air's", Q(inflated, balloon_pressure)},
    {"lift", "N", "upward force of helium, or of the air less the weight of the filling", Q(lifted, lift)},
    {"kinetic", "J", "kinetic energy", Q(NULL, kinetic)},
    {"elastic", "J", "energy stored in skin and strings", Q(elastic_skin, elastic)},
    {"total_energy", "J", "kinetic energy and the energies of all forces", Q(NULL, total_energy)},
    {"px", "kg m/s", "linear momentum along x", Q(NULL, px)},
    {"py", "kg m/s", "linear momentum along y, upward", Q(NULL, py)},
    {"pz", "kg m/s", "linear momentum along z", Q(NULL, pz)},
    {"lx", "kg m^2/s", "angular momentum about the x axis", Q(NULL, lx)},
    {"ly", "kg m^2/s", "angular momentum about the y axis", Q(NULL, ly)},
    {"lz", "kg m^2/s", "angular momentum about the z axis", Q(NULL, lz)},
    {"cx", "m", "center of mass, x", Q(NULL, cx)},
    {"cy", "m", "center of mass, y", Q(NULL, cy)},
    {"cz", "m", "center of mass, z", Q(NULL, cz)},
    {"width", "m", "extent along x", Q(NULL, width)},
    {"height", "m", "extent along y", Q(NULL, height)},
    {"depth", "m", "extent along z", Q(NULL, depth)},
    {"stretch_max", "1", "largest stretch of a spring or an element", Q(elastic_skin, stretch_max)},
    {"thickness_min", "m", "smallest thickness of the rubber", Q(thick, thickness_min)},
    {"rubber_volume", "1", "volume of the rubber over its first", Q(thick, rubber_volume)},
    {"rubber_worst", "1", "that ratio of the element which is farthest from 1", Q(thick, rubber_worst)},
    {"amount", "1", "amount of gas, in units of the scene's", Q(gassy, amount)},
    {"iterations", "1", "iterations of the last solve", Q(iterated, iterations)},
    {"products", "1", "Hessian-vector products of the last solve", Q(multiplied, products)},
    {"residual", "1", "relative residual of the last solve; xpbd: as last measured, 0 unless the guard splits", Q(iterated, residual)},
    {"tension", "N", "tension of a string", OF_STRING, .value = tension},
    {"x", "m", "position of a ball's center, x", OF_SPHERE, .value = x},
    {"y", "m", "position of a ball's center, y", OF_SPHERE, .value = y},
    {"z", "m", "position of a ball's center, z", OF_SPHERE, .value = z},
    {"vx", "m/s", "velocity of a ball, x", OF_SPHERE, .value = vx},
    {"vy", "m/s", "velocity of a ball, y", OF_SPHERE, .value = vy},
    {"vz", "m/s", "velocity of a ball, z", OF_SPHERE, .value = vz},
    {"fx", "N", "force of all contacts on a ball, mean of the last step, x", OF_SPHERE, .value = fx},
    {"fy", "N", "that force, y; its weight does not count", OF_SPHERE, .value = fy},
    {"fz", "N", "that force, z", OF_SPHERE, .value = fz},
    {"pass_throughs", "1", "times that a ball has passed through a skin", OF_SPHERES, .value = pass_throughs},
    {"force", "N", "normal force of skins and balls on the floor, mean of the last step", OF_FLOOR, .value = plane_force},
    {"force", "N", "normal force on a wall, mean of the last step", OF_WALL, .value = plane_force},
    {"fx", "N", "force of skins and balls on a thing, mean of the last step, and of its pins and strings, x", OF_THING, .value = thing_fx},
    {"fy", "N", "that force, y", OF_THING, .value = thing_fy},
    {"fz", "N", "that force, z", OF_THING, .value = thing_fz},
    {"mx", "N m", "moment of that force about the thing's position, x", OF_THING, .value = thing_mx},
    {"my", "N m", "that moment, y", OF_THING, .value = thing_my},
    {"mz", "N m", "that moment, z", OF_THING, .value = thing_mz},
    {"x", "m", "position of a knot, x", OF_KNOT, .value = knot_x},
    {"y", "m", "position of a knot, y", OF_KNOT, .value = knot_y},
    {"z", "m", "position of a knot, z", OF_KNOT, .value = knot_z},
    {"vx", "m/s", "velocity of a knot, x", OF_KNOT, .value = knot_vx},
    {"vy", "m/s", "velocity of a knot, y", OF_KNOT, .value = knot_vy},
    {"vz", "m/s", "velocity of a knot, z", OF_KNOT, .value = knot_vz},
    {"fx", "N", "force of all strings on a knot, x", OF_KNOT, .value = knot_fx},
    {"fy", "N", "that force, y; its weight does not count", OF_KNOT, .value = knot_fy},
    {"fz", "N", "that force, z", OF_KNOT, .value = knot_fz},
    {"crossings", "1", "pairs of triangles that cross, of one skin or of two, or of a skin and a thing", OF_SKINS, .value = crossings},
    {"taken_back", "1", "steps that gained energy, and were made again in shorter substeps", OF_GUARD, .value = taken_back},
};
#undef Q
// clang-format on
const int output_count = sizeof output_table / sizeof *output_table;

double output_value(const Output* output, const OutputSubject* subject) {
    return output->of_balloon ? output->of_balloon(subject->balloon) : output->value(subject);
}

void outputs_reference(FILE* out) {
    fputs(
        "\n### Outputs: the columns of `--csv`\n\n"
        "N is the number of a balloon, ball, wall, thing or knot, K that of a string, from 0. A "
        "column is there\n"
        "where the scene models it: a volume of closed skins, iterations of methods that iterate,\n"
        "the guard's where it may split a step.\n"
        "\n| column | unit | meaning |\n|---|---|---|\n",
        out);
    for (int k = 0; k < output_count; k++)
        fprintf(out, "| `%s%s` | %s | %s |\n", output_prefix[output_table[k].kind],
                output_table[k].column, output_table[k].unit, output_table[k].about);
}
