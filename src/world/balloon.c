#include "world/balloon.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/table.h"
#include "force/inflation.h"
#include "force/material.h"
#include "force/strings.h"
#include "mesh/load.h"
#include "world/balloon_check.h"
#include "world/guard/guard.h"

static const double vent_pressure = 1000; ///< [Pa] gauge pressure at which a valve vents at `rate`
static const double default_threshold = 0.1; ///< [1] the mass-spring paper's

/// Colors of balloons whose scene names none: easy to tell apart, also with most color blindness.
static const float palette[][3] = {
    {0.90f, 0.16f, 0.17f}, {0.10f, 0.45f, 0.85f}, {0.98f, 0.72f, 0.10f}, {0.16f, 0.62f, 0.30f},
    {0.62f, 0.25f, 0.72f}, {0.98f, 0.45f, 0.12f}, {0.10f, 0.68f, 0.70f}, {0.93f, 0.35f, 0.60f}};

static void set_color(Balloon* balloon, int number) {
    const int colors = sizeof palette / sizeof *palette;
    const BalloonDef* def = balloon->def;
    for (int k = 0; k < 3; k++)
        balloon->color[k] = def->color ? (float)def->color[k] : palette[number % colors][k];
}

/// Where the def has a size, fit the model to it and center it; then scale it.
static void place_body(Balloon* balloon) {
    const BalloonDef* def = balloon->def;
    Placement placement = {.scale = def->scale, .rotation = def->rotation};
    if (def->size > 0) {
        double4 low = {INFINITY, INFINITY, INFINITY, 0}, high = -low;
        for (int i = 0; i < balloon->mesh.point_count; i++)
            for (int k = 0; k < 3; k++) {
                low[k] = fmin(low[k], balloon->mesh.point[i][k]);
                high[k] = fmax(high[k], balloon->mesh.point[i][k]);
            }
        const double4 side = high - low;
        placement.scale *= def->size / fmax(side[0], fmax(side[1], side[2]));
        for (int k = 0; k < 3; k++)
            placement.center[k] = (low[k] + high[k]) / 2;
    }
    for (int k = 0; def->position && k < 3; k++)
        placement.position[k] = def->position[k];
    body_make(&balloon->body, &balloon->mesh, &placement, def->mass ? def->mass->per_particle : 1);
}

/// The lowest particle, or with sign -1 the highest.
static int lowest(const Body* body, int sign) {
    int best = 0;
    for (int i = 1; i < body->count; i++)
        if ((real)sign * body->x[i][1] < (real)sign * body->x[best][1])
            best = i;
    return best;
}

static int nearest(const Body* body, const double to[3]) {
    const double4 end = {to[0], to[1], to[2], 0};
    int best = 0;
    double min = INFINITY;
    for (int i = 0; i < body->count; i++) {
        const double distance = dlength(to_double4(body->x[i]) - end);
        if (distance < min) {
            min = distance;
            best = i;
        }
    }
    return best;
}

/// scene_load has checked the word, and balloon_check_mesh the number.
int balloon_particle_at(const Body* body, const char* at, const double to[3]) {
    if (!at || strcmp(at, "nearest") == 0)
        return to ? nearest(body, to) : lowest(body, 1);
    if (strcmp(at, "lowest") == 0)
        return lowest(body, 1);
    if (strcmp(at, "highest") == 0)
        return lowest(body, -1);
    const long loaded = strtol(at, NULL, 10);
    return loaded < body->count ? body->mesh->inside[loaded] : NONE;
}

void balloon_center(const Body* body, double center[3]) {
    double4 sum = {0};
    double mass = 0;
    for (int i = 0; i < body->count; i++) {
        sum += (double)body->mass[i] * to_double4(body->x[i]);
        mass += (double)body->mass[i];
    }
    for (int k = 0; k < 3; k++)
        center[k] = sum[k] / mass;
}

/// The point straight below a particle: on the floor, or below it by the balloon's size.
static void below(const Body* body, const WorldDef* world, int particle, double to[3]) {
    const double4 x = to_double4(body->x[particle]);
    to[0] = x[0];
    to[1] = world->floor ? *world->floor : x[1] - body->size;
    to[2] = x[2];
}

static void tie(Body* body, const WorldDef* world, const StringDef* def, int particle) {
    double to[3];
    below(body, world, particle, to);
    body_tie(body, particle, def->to ? def->to : to, def->stiffness, def->slack);
}

static void add_strings(Balloon* balloon, const WorldDef* world) {
    for (unsigned k = 0; k < balloon->def->strings_count; k++) {
        const StringDef* string = &balloon->def->strings[k];
        if (!string_joins(string))
            tie(&balloon->body, world, string,
                balloon_particle_at(&balloon->body, string->at, string->to));
    }
    balloon->strings = balloon->body.string_count;
}

static void add_inflation(Balloon* balloon, const WorldDef* world) {
    const InflationDef* def = balloon->def->inflation;
    if (!def)
        return;
    balloon->scene_amount = def->amount;
    balloon->min_amount = def->min;
    balloon->max_amount = def->max != 0 ? def->max : def->amount > 0 ? 10 * def->amount : 100;
    balloon->rate = def->rate > 0 ? def->rate : (balloon->max_amount - balloon->min_amount) / 10;
    balloon->vent = def->vent > 0 ? def->vent : balloon->rate / vent_pressure;
    const Filling* filling =
        def->filling ? table_find(filling_table, filling_count, def->filling) : NULL;
    const double ambient = def->ambient ? *def->ambient : standard_pressure;
    body_inflate(&balloon->body,
                 &(Inflation){
                     .law = def->law,
                     .amount = def->amount,
                     .unit = def->unit     ? *def->unit
                             : ambient > 0 ? ambient
                                           : standard_pressure,
                     .ambient = ambient,
                     .temperature = def->temperature ? *def->temperature / standard_temperature : 1,
                     .adiabatic = def->adiabatic,
                     .weighs = filling != NULL,
                     .filling = filling ? filling : filling_table[0],
                     .paper_tangent = world->solver.paper_tangent,
                 });
}

/// Thickness at every particle, patches included.
static void compute_thickness(const Body* body, const MembraneDef* def, double* thickness) {
    for (int i = 0; i < body->count; i++) {
        thickness[i] = def->thickness;
        for (unsigned k = 0; k < def->patches_count; k++) {
            const PatchDef* patch = &def->patches[k];
            const double4 center = {patch->at[0], patch->at[1], patch->at[2], 0};
            const double closeness =
                fmax(1 - dlength(to_double4(body->x[i]) - center) / patch->radius, 0);
            const double smooth = closeness * closeness * (3 - 2 * closeness);
            thickness[i] += smooth * (patch->thickness - thickness[i]);
        }
    }
}

static void add_membrane(Body* body, const MembraneDef* def) {
    Rubber rubber = {
        .material = material_find(def->material),
        .young = def->young,
        .density = def->density,
        .rule = def->volume,
    };
    memcpy(rubber.parameter, def->parameter, sizeof rubber.parameter);
    double* thickness = new_array(double, body->count);
    compute_thickness(body, def, thickness);
    material_add(body, thickness, &rubber);
    free(thickness);
}

static void set_strain_limit(Balloon* balloon) {
    const StrainLimitDef* def = balloon->def->strain_limit;
    StrainLimit* limit = &balloon->strain_limit;
    if (def) {
        limit->threshold[STRUCTURAL] = def->structural;
        limit->threshold[SHEAR] = def->shear;
        limit->threshold[FLEXION] = def->flexion;
        limit->tarantino = def->tarantino;
        limit->phantom = def->phantom;
    } else {
        for (int kind = 0; kind < SPRING_KINDS; kind++)
            limit->threshold[kind] = default_threshold;
    }
    strain_limit_switch(limit, &balloon->body, def != NULL);
}

/// Make all parts of a balloon except its mesh from its def.
static void make(Balloon* balloon, const WorldDef* world) {
    const BalloonDef* def = balloon->def;
    Body* body = &balloon->body;
    place_body(balloon);
    body->gravity = scene_gravity(world);
    if (def->hold_rim)
        body_hold_rim(body);
    for (unsigned k = 0; k < def->pins_count; k++)
        body_hold(body, def->pins[k].at, def->pins[k].radius);

    const SpringsDef* springs = def->skin.springs;
    if (springs) {
        const double stiffness[SPRING_KINDS] = {springs->structural, springs->shear,
                                                springs->flexion};
        body_add_springs(body, stiffness, springs->law);
        if (springs->torsion > 0)
            body_add_torsion(body, springs->torsion);
    }
    if (def->skin.membrane)
        add_membrane(body, def->skin.membrane);
    add_inflation(balloon, world);
    for (int k = 0; k < force_count; k++)
        if (def->force[k])
            memcpy(body->force_parameter[k], def->force[k], sizeof *body->force_parameter);
    add_strings(balloon, world);
    set_strain_limit(balloon);
    volume_constraint_open(&balloon->volume_constraint, body);
    if (balloon->method->open) {
        const SolverDef* solver = &world->solver;
        balloon->workspace = balloon->method->open(
            body, &(Solver){.iterations = (int)solver->iterations,
                            .tolerance = solver->fixed ? -1 : solver->tolerance,
                            .linear_tolerance = solver->linear_tolerance,
                            .residual_max = world->guard == GUARD_SPLIT ? RESIDUAL_MAX : 0,
                            .start = solver->start,
                            .in_place = solver->in_place});
    }
    balloon_fill(balloon, 0);
}

bool balloon_open(Balloon* balloon, const WorldDef* def, const Method* method, int number,
                  Fault* fault) {
    *balloon = (Balloon){.def = &def->balloons[number], .method = method};
    char path[512];
    MeshReport report = {0};
    if (!scene_model_path(def, balloon->def->model, path, fault) ||
        !mesh_load(path, &balloon->mesh, &report, fault) ||
        !balloon_check_mesh(balloon, def->file, number, fault))
        return false;

    set_color(balloon, number);
    make(balloon, def);
    char name[40];
    snprintf(name, sizeof name, "balloons.%d", number);
    if (!balloon_check_position(&balloon->body, def->file, name, fault))
        return false;
    balloon->good_x = new_array(real4, balloon->body.count);
    balloon->good_v = new_array(real4, balloon->body.count);
    balloon->v_start = new_array(real4, balloon->body.count);
    balloon->good_thickness = new_array(real, balloon->body.membrane.count);

    const char* why = method_refuses(method, &balloon->body);
    if (why)
        return fault_set(fault, def->file, "balloons.%d: method '%s' %s", number, method->name,
                         why);
    return true;
}

/// Free what make() made.
static void unmake(Balloon* balloon) {
    if (balloon->method->close)
        balloon->method->close(balloon->workspace);
    balloon->workspace = NULL;
    volume_constraint_close(&balloon->volume_constraint);
    strain_limit_free(&balloon->strain_limit);
    body_free(&balloon->body);
}

void balloon_reset(Balloon* balloon, const WorldDef* def) {
    unmake(balloon);
    balloon->added_amount = 0;
    make(balloon, def);
}

void balloon_fill(Balloon* balloon, double t) {
    if (!balloon->def->inflation)
        return;
    double amount = balloon->scene_amount;
    const FillDef* fill = balloon->def->inflation->fill;
    if (fill) {
        const double part = fmin(fmax((t - fill->start) / fill->seconds, 0), 1);
        amount += part * (fill->to - balloon->scene_amount);
    }
    balloon->body.inflation.amount = amount + balloon->added_amount;
}

double balloon_pressure(const Balloon* balloon) {
    return inflation_pressure(&balloon->body);
}

/// Amount of gas that escapes in that time: proportional to the gauge pressure, none below 0.
static double vented_amount(const Balloon* balloon, double conductance, double seconds) {
    return conductance * seconds * fmax(balloon_pressure(balloon), 0);
}

void balloon_blow(Balloon* balloon, double seconds) {
    Inflation* inflation = &balloon->body.inflation;
    if (inflation->law == INFLATE_NONE)
        return;
    // a scene may start outside the keys' limits; keys never move it further out
    const double now = inflation->amount;
    const double max = fmax(balloon->max_amount, now), min = fmin(balloon->min_amount, now);
    const double change = seconds < 0 && inflation->law == INFLATE_GAS
                              ? vented_amount(balloon, balloon->vent, seconds)
                              : seconds * balloon->rate;
    const double next = fmin(fmax(now + change, min), max);
    balloon->added_amount += next - now;
    inflation->amount = next;
}

void balloon_leak(Balloon* balloon, double seconds) {
    const double lost = fmin(vented_amount(balloon, balloon->def->inflation->leak, seconds),
                             balloon->body.inflation.amount);
    balloon->added_amount -= lost;
    balloon->body.inflation.amount -= lost;
}

void balloon_tie(Balloon* balloon, const WorldDef* def, bool tied) {
    Body* body = &balloon->body;
    if (tied && balloon->strings == 0) {
        const StringDef string = {.stiffness = 50, .slack = 1}; // the authors' stiffness
        tie(body, def, &string, lowest(body, 1));
        balloon->strings = 1;
    }
    body->string_count = tied ? balloon->strings : 0;
    for (int k = 0; k < body->string_count; k++)
        string_reach(body, &body->string[k]);
}

void balloon_close(Balloon* balloon) {
    unmake(balloon);
    mesh_free(&balloon->mesh);
    free(balloon->good_x);
    free(balloon->good_v);
    free(balloon->v_start);
    free(balloon->good_thickness);
    *balloon = (Balloon){0};
}
