#include "lab/advice/needs_part.h"

#include <math.h>
#include <string.h>

#include "base/table.h"
#include "lab/run/refinement.h"
#include "mesh/measure.h"

// --- what is beside the balloons -----------------------------------------------------------------

static void gravity(const World* world, Overrides* sets) {
    if (scene_gravity(&world->def) != 0)
        overrides_add(sets, "gravity=0");
}

static void the_floor(const World* world, Overrides* sets) {
    if (world->def.floor)
        overrides_add(sets, "floor=~");
}

static void walls(const World* world, Overrides* sets) {
    if (world->def.walls_count > 0)
        overrides_add(sets, "walls=[]");
}

static void spheres(const World* world, Overrides* sets) {
    if (world->def.spheres_count > 0)
        overrides_add(sets, "spheres=[]");
}

static void friction(const World* world, Overrides* sets) {
    for (unsigned s = 0; s < world->def.spheres_count; s++)
        if (world->def.spheres[s].friction > 0)
            overrides_add(sets, "spheres.%u.friction=0", s);
}

static void restitution(const World* world, Overrides* sets) {
    for (unsigned s = 0; s < world->def.spheres_count; s++)
        if (world->def.spheres[s].restitution > 0)
            overrides_add(sets, "spheres.%u.restitution=0", s);
}

static void pipes(const World* world, Overrides* sets) {
    if (world->def.pipes_count > 0)
        overrides_add(sets, "pipes=[]");
}

// --- the skin ------------------------------------------------------------------------------------

/// A number of every balloon that has one is 0. A skin keeps one kind of spring.
#define WITHOUT(name, object, field, key)                                                          \
    static void name(const World* world, Overrides* sets) {                                        \
        for (unsigned b = 0; b < world->def.balloons_count; b++) {                                 \
            const BalloonDef* balloon = &world->def.balloons[b];                                   \
            if (balloon->object && balloon->object->field != 0)                                    \
                overrides_add(sets, "balloons.%u." key "=0", b);                                   \
        }                                                                                          \
    }
WITHOUT(structural, skin.springs, structural, "skin.springs.structural")
WITHOUT(shear, skin.springs, shear, "skin.springs.shear")
WITHOUT(flexion, skin.springs, flexion, "skin.springs.flexion")
WITHOUT(torsion, skin.springs, torsion, "skin.springs.torsion")
WITHOUT(mooney, skin.membrane, mooney, "skin.membrane.mooney")
WITHOUT(leak, inflation, leak, "inflation.leak")
WITHOUT(per_inflation, helium, per_inflation, "helium.per_inflation")

/// A key of every balloon that has it is taken out.
#define KEYLESS(name, object, key)                                                                 \
    static void name(const World* world, Overrides* sets) {                                        \
        for (unsigned b = 0; b < world->def.balloons_count; b++)                                   \
            if (world->def.balloons[b].object)                                                     \
                overrides_add(sets, "balloons.%u." key "=~", b);                                   \
    }
KEYLESS(inflation, inflation, "inflation")
KEYLESS(helium, helium, "helium")
KEYLESS(damping, damping, "damping")
KEYLESS(correction, correction, "correction")
KEYLESS(strings, strings_count, "strings")
KEYLESS(hold_rim, hold_rim, "hold_rim")

/// A key below one that every balloon may have.
#define KEYLESS_BELOW(name, object, field, key)                                                    \
    static void name(const World* world, Overrides* sets) {                                        \
        for (unsigned b = 0; b < world->def.balloons_count; b++) {                                 \
            const BalloonDef* balloon = &world->def.balloons[b];                                   \
            if (balloon->object && balloon->object->field)                                         \
                overrides_add(sets, "balloons.%u." key "=~", b);                                   \
        }                                                                                          \
    }
KEYLESS_BELOW(patches, skin.membrane, patches_count, "skin.membrane.patches")
KEYLESS_BELOW(global_volume, skin.membrane, volume, "skin.membrane.volume")
KEYLESS_BELOW(adiabatic, inflation, adiabatic, "inflation.adiabatic")
KEYLESS_BELOW(filling, inflation, filling, "inflation.filling")
KEYLESS_BELOW(tarantino, correction, tarantino, "correction.tarantino")

/// One kind of several; the only one is the correction itself.
#define CORRECTED(name, field, one, two)                                                           \
    static void name(const World* world, Overrides* sets) {                                        \
        for (unsigned b = 0; b < world->def.balloons_count; b++) {                                 \
            const CorrectionDef* correct = world->def.balloons[b].correction;                      \
            if (correct && correct->field > 0 && correct->one + correct->two > 0)                  \
                overrides_add(sets, "balloons.%u.correction." #field "=0", b);                     \
        }                                                                                          \
    }
CORRECTED(correct_structural, structural, shear, flexion)
CORRECTED(correct_shear, shear, structural, flexion)
CORRECTED(correct_flexion, flexion, structural, shear)

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

/// Springs that stretch like the rubber when it is stretched alike in all directions, B = 2 E h:
/// on square cells kd = E h/2 and ks + 4 kf = E h, a third of that in flexion; on triangles of
/// equal sides, where only sides are, B = sqrt(3) k.
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

/// A pressure that does not change with the size: what the law says of the first size. A gas in air
/// has atmospheres then, and no skin holds them.
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
const NeedsPart needs_part_table[] = {
    {"gravity",     "without it",                        gravity},
    {"floor",       "without it",                        the_floor},
    {"walls",       "without them",                      walls},
    {"spheres",     "without them",                      spheres},
    {"friction",    "without it",                        friction},
    {"restitution", "without it",                        restitution},
    {"pipes",       "without them",                      pipes},
    {"membrane",    "springs with rubber's law",         membrane},
    {"structural",  "without these springs",             structural},
    {"shear",       "without these springs",             shear},
    {"flexion",     "without these springs",             flexion},
    {"torsion",     "without these springs",             torsion},
    {"mooney",      "neo-Hookean rubber",                mooney},
    {"patches",     "one thickness",                     patches},
    {"volume",      "each element keeps its own",        global_volume},
    {"inflation",   "without it",                        inflation},
    {"law",         "the pressure of the first size",    law},
    {"adiabatic",   "at one temperature",                adiabatic},
    {"filling",     "a gas without weight and lift",     filling},
    {"leak",        "without it",                        leak},
    {"helium",      "without its lift",                  helium},
    {"per_inflation", "lift that does not grow",         per_inflation},
    {"damping",     "without it",                        damping},
    {"correction",  "without it",                        correction},
    {"correction.structural", "these springs are free",  correct_structural},
    {"correction.shear",      "these springs are free",  correct_shear},
    {"correction.flexion",    "these springs are free",  correct_flexion},
    {"tarantino",   "corrected springs go on pulling",   tarantino},
    {"strings",     "untied",                            strings},
    {"hold_rim",    "the rim moves",                     hold_rim},
    {"mesh",        "half as many edges each way",       mesh},
    {"step",        "twice as long",                     step},
    {"precision",   "float",                             precision},
};
// clang-format on
const int needs_part_count = sizeof needs_part_table / sizeof *needs_part_table;

const NeedsPart* needs_part_find(const char* name) {
    return table_row_of(needs_part_table, needs_part_count, sizeof *needs_part_table, name);
}
