#include "scene/rules.h"

#include <string.h>

#include "base/table.h"
#include "force/material.h"
#include "solve/method.h"

/// A rule for each balloon: what breaks it, and what is then said of which key.
typedef struct Rule {
    const char* key; ///< within the balloon
    const char* sentence;
    bool (*broken)(const WorldDef* world, const BalloonDef* balloon);
} Rule;

static bool two_dampings(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    return balloon->damping && balloon->damping->coefficient > 0 && balloon->damping->rate > 0;
}

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

/// A material by name; rules_hold has yet to judge the name.
static const Material* material_of(const BalloonDef* balloon) {
    const MembraneDef* membrane = balloon->skin.membrane;
    return membrane ? material_find(membrane->material) : NULL;
}

static bool poisson_too_large(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    const Material* material = material_of(balloon);
    const double* poisson = material ? balloon->skin.membrane->poisson : NULL;
    const Parameter* row = material ? material_parameter(material, "poisson") : NULL;
    return poisson && row && row->max_open && *poisson >= row->max;
}

static bool poisson_of_incompressible(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    const Material* material = material_of(balloon);
    const double* poisson = material ? balloon->skin.membrane->poisson : NULL;
    return poisson && material->incompressible && *poisson != 0.5;
}

static bool mooney_of_another(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    const Material* material = material_of(balloon);
    return material && balloon->skin.membrane->mooney != 0 &&
           !material_parameter(material, "mooney");
}

static bool tied_without_skin(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    return balloon->strings_count > 0 && !balloon->skin.springs && !balloon->skin.membrane;
}

static bool corrected_without_springs(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    return balloon->correction && !balloon->skin.springs;
}

static bool tied_to_no_floor(const WorldDef* world, const BalloonDef* balloon) {
    for (unsigned i = 0; i < balloon->strings_count; i++)
        if (!balloon->strings[i].to && !world->floor)
            return true;
    return false;
}

static bool tied_at_no_particle(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    for (unsigned i = 0; i < balloon->strings_count; i++) {
        const char* at = balloon->strings[i].at;
        if (at && strcmp(at, "nearest") != 0 && strcmp(at, "lowest") != 0 &&
            strcmp(at, "highest") != 0 && (strlen(at) > 9 || at[strspn(at, "0123456789")]))
            return true;
    }
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
    return inflation && inflation->most != 0 && inflation->most <= inflation->least;
}

// clang-format off
static const Rule rule_table[] = {
    {"skin", "a skin is of springs or a membrane, not both", two_skins},
    {"mass", "give the mass of a particle, as in mass: {per_particle: 0.001}", no_mass},
    {"mass", "a membrane has the mass of its rubber, from density and thickness", two_masses},
    {"skin.membrane.poisson", "stvk-3d takes Poisson's ratios below 1/2 only", poisson_too_large},
    {"skin.membrane.poisson", "this rubber is incompressible: its Poisson's ratio is 1/2",
     poisson_of_incompressible},
    {"skin.membrane.mooney", "only mooney-rivlin has a ratio of C2 to C1", mooney_of_another},
    {"damping", "give coefficient or rate, not both", two_dampings},
    {"skin.springs", "no kind of spring has a stiffness; give one, as in {structural: 50}",
     no_stiffness},
    {"strings", "a string needs a skin that holds its particle, as in "
                "skin: {springs: {structural: 50}}", tied_without_skin},
    {"strings", "a string without `to` hangs down to the floor, and this scene has none; "
                "give it `to`, or the scene a floor", tied_to_no_floor},
    {"strings", "`at` must be nearest, lowest, highest or the number of a particle",
     tied_at_no_particle},
    {"correction", "correction needs springs to correct", corrected_without_springs},
    {"inflation", "ambient, unit, temperature, adiabatic, filling, leak and vent are for the law gas",
     gas_words_without_gas},
    {"inflation.amount",  "there is no gas of less than nothing", less_than_no_gas},
    {"inflation.most",    "most must be greater than least", no_way_to_go},
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

/// Names that tables know, and pipes between balloons that there are.
static bool names_are_known(const WorldDef* def, unsigned b, const SceneTree* tree, Fault* fault) {
    const MembraneDef* membrane = def->balloons[b].skin.membrane;
    const InflationDef* inflation = def->balloons[b].inflation;
    char path[80];
    if (membrane && !material_find(membrane->material)) {
        snprintf(path, sizeof path, "balloons.%u.skin.membrane.material", b);
        return tree_fault(tree, tree_find(tree, path), fault, "no material '%s'; there are %s",
                          membrane->material, material_names());
    }
    if (inflation && inflation->filling &&
        !table_find(filling_table, filling_count, inflation->filling)) {
        char names[64];
        snprintf(path, sizeof path, "balloons.%u.inflation.filling", b);
        return tree_fault(tree, tree_find(tree, path), fault, "no filling '%s'; there are %s",
                          inflation->filling,
                          table_names(filling_table, filling_count, names, sizeof names));
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
    if (def->method && !method_find(def->method))
        return tree_fault(tree, tree_find(tree, "method"), fault, "no method '%s'; there are %s",
                          def->method, method_names());
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
        if (n[0] == 0 && n[1] == 0 && n[2] == 0)
            return tree_fault(tree, tree_find(tree, path), fault,
                              "a wall's normal points somewhere; this one has no length");
    }
    for (unsigned i = 0; i < def->balloons_count; i++)
        if (!names_are_known(def, i, tree, fault) || !balloon_rules_hold(def, i, tree, fault))
            return false;
    return pipes_join(def, tree, fault) && about_says(def, tree, fault);
}
