#include "scene/rules.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "force/force.h"

/// What contacts stop within a step without a crossing. [m/s]
static const double path_speed_max = 50;

/// A rule for each balloon: what breaks it, and what is then said of which key.
typedef struct Rule {
    const char* key; ///< within the balloon
    const char* sentence;
    bool (*broken)(const WorldDef* world, const BalloonDef* balloon);
} Rule;

static bool no_stiffness(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    const SpringsDef* springs = balloon->skin.springs;
    return springs &&
           springs->structural + springs->shear + springs->flexion + springs->torsion <= 0;
}

static bool two_skins(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    return balloon->skin.springs && balloon->skin.membrane;
}

static bool no_mass(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    return !balloon->mass && !balloon->skin.membrane;
}

static bool two_masses(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    return balloon->mass && balloon->skin.membrane;
}

static bool tied_without_skin(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    return balloon->strings_count > 0 && !balloon->skin.springs && !balloon->skin.membrane;
}

static bool limited_without_springs(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    return balloon->strain_limit && !balloon->skin.springs;
}

static bool tied_to_no_floor(const WorldDef* world, const BalloonDef* balloon) {
    for (unsigned i = 0; i < balloon->strings_count; i++)
        if (!balloon->strings[i].to && !string_joins(&balloon->strings[i]) && !world->floor)
            return true;
    return false;
}

static bool names_no_particle(const char* at) {
    return at && strcmp(at, "nearest") != 0 && strcmp(at, "lowest") != 0 &&
           strcmp(at, "highest") != 0 && (strlen(at) > 9 || at[strspn(at, "0123456789")]);
}

static bool tied_at_no_particle(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    for (unsigned i = 0; i < balloon->strings_count; i++)
        if (names_no_particle(balloon->strings[i].at) ||
            names_no_particle(balloon->strings[i].to_at))
            return true;
    return false;
}

static bool tied_twice(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    for (unsigned i = 0; i < balloon->strings_count; i++) {
        const StringDef* string = &balloon->strings[i];
        if (!!string->to + !!string->to_balloon + !!string->to_knot + !!string->to_thing > 1)
            return true;
    }
    return false;
}

static bool is_number_below(const double* number, unsigned count) {
    return *number == floor(*number) && *number < count;
}

static bool tied_to_none(const WorldDef* world, const BalloonDef* balloon) {
    for (unsigned i = 0; i < balloon->strings_count; i++) {
        const double *to = balloon->strings[i].to_balloon, *knot = balloon->strings[i].to_knot,
                     *thing = balloon->strings[i].to_thing;
        if ((to && (!is_number_below(to, world->balloons_count) ||
                    &world->balloons[(unsigned)*to] == balloon)) ||
            (knot && !is_number_below(knot, world->knots_count)) ||
            (thing && !is_number_below(thing, world->things_count)))
            return true;
    }
    return false;
}

static bool pinned_to_none(const WorldDef* world, const BalloonDef* balloon) {
    for (unsigned i = 0; i < balloon->pins_count; i++)
        if (balloon->pins[i].to_thing &&
            !is_number_below(balloon->pins[i].to_thing, world->things_count))
            return true;
    return false;
}

static bool gas_words_without_gas(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    const InflationDef* i = balloon->inflation;
    return i && i->law != INFLATE_GAS &&
           (i->ambient || i->unit || i->temperature || i->adiabatic || i->filling || i->leak > 0 ||
            i->vent > 0);
}

static bool less_than_no_gas(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    const InflationDef* inflation = balloon->inflation;
    return inflation && inflation->law == INFLATE_GAS && inflation->amount < 0;
}

static bool no_way_to_go(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    const InflationDef* inflation = balloon->inflation;
    return inflation && inflation->max != 0 && inflation->max <= inflation->min;
}

static bool touches_and_is_moved(const WorldDef* world, const BalloonDef* balloon) {
    return (world->contacts.self || world->contacts.others || world->things_count > 0) &&
           balloon->skin.membrane && balloon->skin.membrane->volume == VOLUME_GLOBAL;
}

// clang-format off
static const Rule rule_table[] = {
    {"skin", "a skin is of springs or a membrane, not both", two_skins},
    {"mass", "give the mass of a particle, as in mass: {per_particle: 0.001}", no_mass},
    {"mass", "a membrane has the mass of its rubber, from density and thickness", two_masses},
    {"skin.springs", "no kind of spring has a stiffness; give one, as in {structural: 50}",
     no_stiffness},
    {"skin.membrane", "a skin that touches skins or things needs `volume: local`; `global` moves particles after contacts "
                      "have been solved", touches_and_is_moved},
    {"strings", "a string needs a skin that holds its particle, as in "
                "skin: {springs: {structural: 50}}", tied_without_skin},
    {"strings", "a string without `to` hangs down to the floor, and this scene has none; "
                "give it `to`, or the scene a floor", tied_to_no_floor},
    {"strings", "`at` must be nearest, lowest, highest or the number of a particle",
     tied_at_no_particle},
    {"strings", "a string leads to one end: give to, to_balloon, to_knot or to_thing", tied_twice},
    {"strings", "a string leads to nothing: to_balloon must be the number of another balloon, to_knot that of one "
                "of the scene's `knots`, to_thing that of one of its `things`, each counted from 0", tied_to_none},
    {"pins", "a pin leads to nothing: to_thing must be the number of one of the scene's `things`, counted from 0",
     pinned_to_none},
    {"strain_limit", "a strain limit needs springs", limited_without_springs},
    {"inflation", "ambient, unit, temperature, adiabatic, filling, leak and vent are for the law gas",
     gas_words_without_gas},
    {"inflation.amount",  "there is no gas of less than nothing", less_than_no_gas},
    {"inflation.max",     "max must be greater than min", no_way_to_go},
};
// clang-format on

static bool balloon_rules_hold(const WorldDef* def, unsigned balloon, const SceneTree* tree,
                               Fault* fault) {
    for (size_t i = 0; i < sizeof rule_table / sizeof rule_table[0]; i++) {
        const Rule* rule = &rule_table[i];
        if (!rule->broken(def, &def->balloons[balloon]))
            continue;
        char path[64];
        snprintf(path, sizeof path, "balloons.%u.%s", balloon, rule->key);
        return tree_fault(tree, tree_find(tree, path), fault, "balloons.%u: %s", balloon,
                          rule->sentence);
    }
    return true;
}

/// A force that takes one of its parameters is not given two.
static bool exclusive_parameters_hold(const WorldDef* def, unsigned balloon, const SceneTree* tree,
                                      Fault* fault) {
    for (int k = 0; k < force_count; k++) {
        const Force* force = force_table[k];
        const double* value = def->balloons[balloon].force[k];
        const char* first = NULL;
        for (int p = 0; force->exclusive && value && p < force->parameter_count; p++) {
            const char* name = force->parameters[p].name;
            char path[80];
            snprintf(path, sizeof path, "balloons.%u.%s", balloon, force->name);
            if (value[p] != 0 && first)
                return tree_fault(tree, tree_find(tree, path), fault,
                                  "balloons.%u: give %s or %s, not both", balloon, first, name);
            if (value[p] != 0)
                first = name;
        }
    }
    return true;
}

static bool joins(const WorldDef* def, double number) {
    return number == floor(number) && number < def->balloons_count &&
           def->balloons[(unsigned)number].inflation &&
           def->balloons[(unsigned)number].inflation->law == INFLATE_GAS;
}

static bool pipes_join(const WorldDef* def, const SceneTree* tree, Fault* fault) {
    for (unsigned k = 0; k < def->pipes_count; k++) {
        const PipeDef* pipe = &def->pipes[k];
        char path[64];
        snprintf(path, sizeof path, "pipes.%u", k);
        if (pipe->from == pipe->to || !joins(def, pipe->from) || !joins(def, pipe->to))
            return tree_fault(tree, tree_find(tree, path), fault,
                              "a pipe joins two balloons with gas by their numbers, of 0 to %u",
                              def->balloons_count - 1);
    }
    return true;
}

/// What is wrong with a path, or NULL.
static const char* path_is_wrong(const double* position, const PathPointDef* path, unsigned count) {
    if (position && count > 0)
        return "give position or path, not both: it begins at the first point of its path";
    for (unsigned k = 1; k < count; k++) {
        const PathPointDef *from = &path[k - 1], *to = from + 1;
        double squared = 0;
        for (int c = 0; c < 3; c++)
            squared +=
                (to->position[c] - from->position[c]) * (to->position[c] - from->position[c]);
        if (!(to->at > from->at))
            return "the times of a path must increase";
        if (!(sqrt(squared) <= path_speed_max * (to->at - from->at)))
            return "a path is followed at 50 m/s at most; give it more time";
    }
    return NULL;
}

static const char* knot_is_wrong(const KnotDef* knot) {
    if (!knot->position && knot->path_count == 0)
        return "give its position, or its path";
    for (unsigned k = 0; k < knot->path_count; k++)
        if (knot->path[k].rotation)
            return "a knot is a point and has no rotation";
    if (knot->mass > 0 && knot->path_count > 0)
        return "a knot on a path is held: give mass or path, not both";
    return path_is_wrong(knot->position, knot->path, knot->path_count);
}

/// False with a fault if there is a sentence on item `i` of a list.
static bool item_holds(const char* sentence, const char* list, unsigned i, const char* key,
                       const SceneTree* tree, Fault* fault) {
    char path[64];
    snprintf(path, sizeof path, "%s.%u%s", list, i, key);
    return !sentence ||
           tree_fault(tree, tree_find(tree, path), fault, "%s.%u: %s", list, i, sentence);
}

static bool paths_hold(const WorldDef* def, const SceneTree* tree, Fault* fault) {
    bool good = true;
    for (unsigned i = 0; good && i < def->things_count; i++) {
        const ThingDef* thing = &def->things[i];
        good = item_holds(path_is_wrong(thing->position, thing->path, thing->path_count), "things",
                          i, ".path", tree, fault);
    }
    for (unsigned i = 0; good && i < def->knots_count; i++)
        good = item_holds(knot_is_wrong(&def->knots[i]), "knots", i, "", tree, fault);
    return good;
}

static bool camera_looks_nowhere(const CameraDef* camera) {
    return camera && camera->eye[0] == camera->look[0] && camera->eye[1] == camera->look[1] &&
           camera->eye[2] == camera->look[2];
}

/// A failure is of one kind, and a number fails on one side.
static bool fails_in_no_way(const FailsDef* fails) {
    return fails && (fails->halts ? fails->output || fails->above || fails->below || fails->truth
                                  : !fails->output || !fails->above == !fails->below);
}

/// Outputs with their tolerances, or one reason for none.
static bool about_says(const WorldDef* def, const SceneTree* tree, Fault* fault) {
    for (unsigned k = 0; k < def->about_count; k++) {
        const AboutDef* about = &def->about[k];
        char path[64];
        snprintf(path, sizeof path, "about.%u", k);
        const bool none = about->none && !about->output && def->about_count == 1;
        const bool output = !about->none && about->output && about->tolerance > 0;
        if (!none && !output)
            return tree_fault(
                tree, tree_find(tree, path), fault,
                "a scene is about outputs, each as in {output: balloon0.volume, at: 5, "
                "tolerance: 0.02}, or about [{none: the reason}]");
    }
    return true;
}

bool rules_hold(const WorldDef* def, const SceneTree* tree, Fault* fault) {
    if (camera_looks_nowhere(def->camera))
        return tree_fault(tree, tree_find(tree, "camera"), fault,
                          "the camera's eye is where it looks");
    if (fails_in_no_way(def->fails))
        return tree_fault(tree, tree_find(tree, "fails"), fault,
                          "a failure is halts: true, or an output that is above or below a number");
    for (unsigned i = 0; i < def->walls_count; i++) {
        const double* n = def->walls[i].normal;
        char path[64];
        snprintf(path, sizeof path, "walls.%u.normal", i);
        const double squared = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
        if (!(squared >= DBL_MIN && squared <= DBL_MAX)) // else its direction is lost
            return tree_fault(tree, tree_find(tree, path), fault,
                              "a wall's normal points somewhere; the length of this one is %g",
                              sqrt(squared));
    }
    for (unsigned i = 0; i < def->balloons_count; i++)
        if (!exclusive_parameters_hold(def, i, tree, fault) ||
            !balloon_rules_hold(def, i, tree, fault))
            return false;
    return paths_hold(def, tree, fault) && pipes_join(def, tree, fault) &&
           about_says(def, tree, fault);
}
