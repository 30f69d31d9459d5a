#include "lab/advice/needs_part.h"

#include <math.h>
#include <string.h>

#include "force/material.h"
#include "lab/run/refinement.h"
#include "mesh/measure.h"
#include "scene/key.h"

// --- surroundings and skins ----------------------------------------------------------------------

static void gravity(const World* world, Overrides* sets) {
    if (scene_gravity(&world->def) != 0)
        overrides_add(sets, "gravity=0");
}

static void contacts_self(const World* world, Overrides* sets) {
    if (world->def.contacts.self)
        overrides_add(sets, "contacts.self=false");
}

static void contacts_others(const World* world, Overrides* sets) {
    if (world->def.contacts.others && world->balloon_count > 1)
        overrides_add(sets, "contacts.others=false");
}

static void contacts_friction(const World* world, Overrides* sets) {
    const SkinContacts* contacts = &world->def.contacts;
    if ((contacts->self || contacts->others) && contacts->friction > 0)
        overrides_add(sets, "contacts.friction=0");
}

static double mass_of(const Body* body) {
    double sum = 0;
    for (int i = 0; i < body->count; i++)
        sum += (double)body->mass[i];
    return sum;
}

static bool is_of_triangles(const Mesh* mesh) {
    int triangles = 0;
    for (int f = 0; f < mesh->face_count; f++)
        triangles += mesh->face[f][3] == NONE;
    return 2 * triangles > mesh->face_count;
}

/// Springs with the equibiaxial stiffness of the rubber, B = 2 E h: on square cells kd = E h/2 and
/// ks + 4 kf = E h with a third of it in flexion; on equilateral triangles, which have structural
/// springs only, B = sqrt(3) k.
static void membrane(const World* world, Overrides* sets) {
    for (unsigned b = 0; b < world->def.balloons_count; b++) {
        const MembraneDef* rubber = world->def.balloons[b].skin.membrane;
        if (!rubber)
            continue;
        const Balloon* balloon = &world->balloon[b];
        const double sheet = rubber->young * rubber->thickness;
        if (is_of_triangles(&balloon->mesh))
            overrides_add(sets, "balloons.%u.skin={springs: {structural: %.17g, law: rubber}}", b,
                          2 * sheet / sqrt(3));
        else
            overrides_add(
                sets,
                "balloons.%u.skin={springs: {structural: %.17g, shear: %.17g, flexion: %.17g, law: "
                "rubber}}",
                b, sheet * 2 / 3, sheet / 2, sheet / 12);
        overrides_add(sets, "balloons.%u.mass={per_particle: %.17g}", b,
                      mass_of(&balloon->body) / balloon->body.count);
    }
}

// --- the gas -------------------------------------------------------------------------------------

/// A constant pressure: that of the law at the initial size. A gas in air is left as it is, because
/// a constant amount / V0 would include the atmosphere.
static void law(const World* world, Overrides* sets) {
    for (unsigned b = 0; b < world->def.balloons_count; b++) {
        const InflationDef* def = world->def.balloons[b].inflation;
        const Balloon* balloon = &world->balloon[b];
        const Inflation* gas = &balloon->body.inflation;
        if (!def || def->law == INFLATE_PRESSURE || (def->law == INFLATE_GAS && gas->ambient > 0))
            continue;
        const bool area = def->law == INFLATE_AREA;
        const double unit = area ? 100 / measure_area(&balloon->mesh, balloon->body.x) : gas->unit;
        char fill[120] = "";
        if (def->fill)
            snprintf(fill, sizeof fill, ", fill: {to: %.17g, start: %.17g, seconds: %.17g}",
                     unit * def->fill->to, def->fill->start, def->fill->seconds);
        overrides_add(sets, "balloons.%u.inflation={law: pressure, amount: %.17g%s}", b,
                      unit * def->amount, fill);
    }
}

// --- mesh, step, precision -----------------------------------------------------------------------

static void mesh(const World* world, Overrides* sets) {
    refinement_add(world, -1, sets);
}

static void step(const World* world, Overrides* sets) {
    if (2 * world->step <= 1)
        overrides_add(sets, "step=%.17g", 2 * world->step);
}

static void precision(const World* world, Overrides* sets) {
    if (world->def.precision == PRECISION_DOUBLE)
        overrides_add(sets, "precision=float");
}

// clang-format off
static const NeedsPart part_table[] = {
    {"gravity",     "without it",                        .simplify = gravity},
    {"floor",       "without it",                        .key = "floor"},
    {"walls",       "without them",                      .key = "walls"},
    {"things",      "without them",                      .key = "things"},
    {"contacts.self",     "a skin passes through itself",      .simplify = contacts_self},
    {"contacts.others",   "skins pass through each other",     .simplify = contacts_others},
    {"contacts.friction", "skins slide on each other",         .simplify = contacts_friction},
    {"spheres",     "without them",                      .key = "spheres"},
    {"friction",    "without it",                        .key = "spheres.*.friction"},
    {"restitution", "without it",                        .key = "spheres.*.restitution"},
    {"pipes",       "without them",                      .key = "pipes"},
    {"membrane",    "springs with rubber's law",         .simplify = membrane},
    {"structural",  "without these springs",             .key = "balloons.*.skin.springs.structural"},
    {"shear",       "without these springs",             .key = "balloons.*.skin.springs.shear"},
    {"flexion",     "without these springs",             .key = "balloons.*.skin.springs.flexion"},
    {"torsion",     "without these springs",             .key = "balloons.*.skin.springs.torsion"},
    {"patches",     "one thickness",                     .key = "balloons.*.skin.membrane.patches"},
    {"volume",      "each element keeps its own",        .key = "balloons.*.skin.membrane.volume"},
    {"inflation",   "without it",                        .key = "balloons.*.inflation"},
    {"law",         "the pressure of the first size",    .simplify = law},
    {"adiabatic",   "at one temperature",                .key = "balloons.*.inflation.adiabatic"},
    {"filling",     "a gas without weight and lift",     .key = "balloons.*.inflation.filling"},
    {"leak",        "without it",                        .key = "balloons.*.inflation.leak"},
    {"strain_limit",  "without it",                        .key = "balloons.*.strain_limit"},
    {"strain_limit.structural", "these springs are free",  .key = "balloons.*.strain_limit.structural", .several = true},
    {"strain_limit.shear",      "these springs are free",  .key = "balloons.*.strain_limit.shear", .several = true},
    {"strain_limit.flexion",    "these springs are free",  .key = "balloons.*.strain_limit.flexion", .several = true},
    {"tarantino",   "corrected springs go on pulling",   .key = "balloons.*.strain_limit.tarantino"},
    {"strings",     "untied",                            .key = "balloons.*.strings"},
    {"hold_rim",    "the rim moves",                     .key = "balloons.*.hold_rim"},
    {"pins",        "these particles move",              .key = "balloons.*.pins"},
    {"mesh",        "half as many edges each way",       .simplify = mesh},
    {"step",        "twice as long",                     .simplify = step},
    {"precision",   "float",                             .simplify = precision},
};
// clang-format on
enum { PARTS = sizeof part_table / sizeof *part_table };

// --- forces and materials ------------------------------------------------------------------------

static NeedsPart part_without(const char* path, const char* name, const char* parameter) {
    NeedsPart part = {.instead = "without it", .several = parameter != NULL};
    const char* dot = parameter ? "." : "";
    snprintf(part.name, sizeof part.name, "%s%s%s", name, dot, parameter ? parameter : "");
    snprintf(part.key, sizeof part.key, "%s%s", path, part.name);
    return part;
}

/// One part for each force with parameters, and one for each parameter of a force that can have
/// several.
static bool part_of_force(int index, NeedsPart* part) {
    for (int k = 0; k < force_count; k++) {
        const Force* force = force_table[k];
        const int alone = force->exclusive || force->parameter_count == 1;
        const int parts = force->parameter_count == 0 ? 0 : alone ? 1 : 1 + force->parameter_count;
        if (index < parts) {
            *part = part_without("balloons.*.", force->name,
                                 index > 0 ? force->parameters[index - 1].name : NULL);
            return true;
        }
        index -= parts;
    }
    return false;
}

/// Whether a material before row m has a parameter of this name.
static bool is_named_before(int m, const char* name) {
    while (--m >= 0)
        if (material_parameter(material_table[m], name))
            return true;
    return false;
}

/// One part for each material parameter whose default is 0: with that it has no effect.
static bool part_of_material(int index, NeedsPart* part) {
    for (int m = 0; m < material_count; m++)
        for (int p = 0; p < material_table[m]->parameter_count; p++) {
            const Parameter* parameter = &material_table[m]->parameters[p];
            if (parameter->default_value != 0 || is_named_before(m, parameter->name) || index-- > 0)
                continue;
            *part = part_without("balloons.*.skin.membrane.", parameter->name, NULL);
            return true;
        }
    return false;
}

static int parts_of_forces(void) {
    NeedsPart part;
    int count = 0;
    while (part_of_force(count, &part))
        count++;
    return count;
}

bool needs_part_at(int index, NeedsPart* part) {
    const int forces = parts_of_forces();
    if (index >= PARTS)
        return index < PARTS + forces ? part_of_force(index - PARTS, part)
                                      : part_of_material(index - PARTS - forces, part);
    *part = part_table[index];
    return true;
}

bool needs_part_exists(const char* name) {
    NeedsPart part;
    for (int k = 0; needs_part_at(k, &part); k++)
        if (strcmp(part.name, name) == 0)
            return true;
    return false;
}

// --- the overrides of a part with a key ----------------------------------------------------------

/// The number of finite numbers in the mapping that contains `path`.
typedef struct Siblings {
    const char* path;
    size_t length; ///< length of the mapping's path and its dot
    int count;
} Siblings;

static void count_sibling(const KeyValue* value, void* context) {
    Siblings* siblings = context;
    siblings->count += strncmp(value->path, siblings->path, siblings->length) == 0 &&
                       !strchr(value->path + siblings->length, '.') && value->present &&
                       isfinite(value->number);
}

static bool is_one_of_several(const WorldDef* def, const char* path) {
    Siblings siblings = {path, (size_t)(strrchr(path, '.') + 1 - path), 0};
    key_each_value(def, count_sibling, &siblings);
    return siblings.count > 1;
}

typedef struct Removal {
    const NeedsPart* part;
    const WorldDef* def;
    Overrides* sets;
} Removal;

static void remove_value(const KeyValue* value, void* context) {
    const Removal* removal = context;
    const NeedsPart* part = removal->part;
    if (!value->present || strcmp(value->pattern, part->key) != 0 ||
        (part->several && !is_one_of_several(removal->def, value->path)))
        return;
    overrides_add(removal->sets, "%s=%s", value->path, value->key->type == KEY_NUMBER ? "0" : "~");
}

void needs_part_simplify(const NeedsPart* part, const World* world, Overrides* sets) {
    if (part->simplify)
        part->simplify(world, sets);
    else
        key_each_value(&world->def, remove_value, &(Removal){part, &world->def, sets});
}
