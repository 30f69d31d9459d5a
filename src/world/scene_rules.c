#include "world/scene_rules.h"

#include <string.h>

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

static bool tied_without_skin(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    return balloon->strings_count > 0 && !balloon->skin.springs;
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

static bool ambient_without_gas(const WorldDef* world, const BalloonDef* balloon) {
    (void)world;
    const InflationDef* inflation = balloon->inflation;
    return inflation && inflation->ambient && inflation->law != INFLATE_GAS;
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
    {"inflation.ambient", "only the law gas has an ambient pressure", ambient_without_gas},
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

static bool camera_looks_nowhere(const CameraDef* camera) {
    return camera && camera->eye[0] == camera->look[0] && camera->eye[1] == camera->look[1] &&
           camera->eye[2] == camera->look[2];
}

bool rules_hold(const WorldDef* def, const SceneTree* tree, Fault* fault) {
    if (def->method && !method_find(def->method))
        return tree_fault(tree, tree_find(tree, "method"), fault, "no method '%s'; there are %s",
                          def->method, method_names());
    if (camera_looks_nowhere(def->camera))
        return tree_fault(tree, tree_find(tree, "camera"), fault,
                          "the camera's eye is where it looks");
    for (unsigned i = 0; i < def->walls_count; i++) {
        const double* n = def->walls[i].normal;
        char path[64];
        snprintf(path, sizeof path, "walls.%u.normal", i);
        if (n[0] == 0 && n[1] == 0 && n[2] == 0)
            return tree_fault(tree, tree_find(tree, path), fault,
                              "a wall's normal points somewhere; this one has no length");
    }
    for (unsigned i = 0; i < def->balloons_count; i++)
        if (!balloon_rules_hold(def, i, tree, fault))
            return false;
    return true;
}
