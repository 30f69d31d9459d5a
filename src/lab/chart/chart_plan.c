#include <math.h>
#include <stdarg.h>
#include <string.h>
#include <strings.h>

#include "base/memory.h"
#include "lab/chart/chart.h"
#include "mesh/load.h"
#include "world/world.h"

enum { SETS = 2 * CHART_SETS + 6 };

/// One skin of a case at one resolution, for one measure; the same for all methods.
typedef struct Variant {
    const ChartCase* chart;
    const ChartSkin* skin;
    const ChartResolution* resolution;
    const ChartMeasure* measure;
    const char* const* program;
    char text[SETS][220];
    SceneSet set[SETS];
    int sets;
} Variant;

__attribute__((format(printf, 2, 3))) static void add_set(Variant* variant, const char* format,
                                                          ...) {
    char* text = variant->text[variant->sets];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof variant->text[0], format, list);
    va_end(list);
    variant->set[variant->sets++].text = text;
}

/// Filled in place, because its overrides point to its own texts.
static void variant_make(Variant* variant, const ChartCase* chart, const ChartSkin* skin,
                         const ChartResolution* resolution, const ChartMeasure* measure,
                         const ChartOptions* options) {
    *variant = (Variant){.chart = chart,
                         .skin = skin,
                         .resolution = resolution,
                         .measure = measure,
                         .program = options->program};
    for (int b = 0; b == 0 || b < chart->balloons; b++)
        add_set(variant, "balloons.%d.model=%s", b, resolution->model);
    for (int k = 0; k < CHART_SETS && skin->set[k]; k++)
        add_set(variant, "%s", skin->set[k]);
    if (skin->law) { // kd = E h/2, and of E h = ks + 4 kf a third in flexion
        const double sheet = skin->sheet();
        add_set(variant,
                "balloons.0.skin={springs: {structural: %.17g, shear: %.17g, flexion: %.17g, law: "
                "%s}}",
                sheet * 2 / 3, sheet / 2, sheet / 12, skin->law);
    }
    if (measure->key)
        add_set(variant, "%s=%.17g", measure->key, measure->value(measure->at));
}

/// Overrides of the peer's scene alone.
static void add_peer_sets(Variant* variant) {
    const ChartPeer* peer = &variant->chart->peer;
    for (int k = 0; k < CHART_SETS && peer->set[k]; k++)
        add_set(variant, "%s", peer->set[k]);
    if (peer->key)
        add_set(variant, "%s=%.17g", peer->key, peer->value());
}

static bool count_vertices(const Variant* variant, int* vertices, Fault* fault) {
    char path[512];
    const WorldDef nowhere = {0};
    Mesh mesh = {0};
    MeshReport report = {0};
    if (!scene_model_path(&nowhere, variant->resolution->model, path, fault) ||
        !mesh_load(path, &mesh, &report, fault))
        return false;
    *vertices = mesh.point_count;
    mesh_free(&mesh);
    return true;
}

/// Divide the skin's mass equally among its particles.
static void divide_mass(Variant* variant, int vertices) {
    if (variant->skin->mass != 0)
        add_set(variant, "balloons.0.mass={per_particle: %.17g}", variant->skin->mass / vertices);
}

static int find_launch(ChartPlan* plan, Launch* launch) {
    for (int k = 0; k < plan->launches; k++)
        if (launch_same(&plan->launch[k], launch)) {
            launch_free(launch);
            return k;
        }
    plan->launch[plan->launches] = *launch;
    return plan->launches++;
}

/// The command line of a run by a method, or with NULL by the peer.
static void command(const Variant* variant, const char* method, double step, const char* precision,
                    Launch* launch) {
    const ChartPeer* peer = &variant->chart->peer;
    launch_add(launch, "%s", variant->program[strcmp(precision, "double") == 0]);
    launch_add(launch, method ? "run" : "peer");
    launch_add(launch, "%s.yaml", variant->chart->scene);
    if (method)
        launch_add(launch, "--method=%s", method);
    else if (peer->spring > 0)
        launch_add(launch, "--fit=%.17g", peer->spring);
    else if (peer->pressure)
        launch_add(launch, "--fit=%.17g,%.17g,%.17g", peer->pressure(), pow(peer->stretch(), 3),
                   peer->step);
    launch_add(launch, "--step=%.17g", step);
    for (int k = 0; k < variant->sets; k++)
        launch_add(launch, "--set=%s", variant->set[k].text);
    launch_add(launch, "--seconds=%.17g", variant->chart->seconds);
    launch_add(launch, "--fps=%.17g", variant->chart->rows);
    launch_add(launch, "--csv=-");
    launch_add(launch, "--report");
}

/// Properties of a skin in the scene, the same for every resolution and measure.
typedef struct SkinFacts {
    bool known;
    char skin[16], law[32];
    unsigned refusing; ///< the methods that refuse the body, bit k for row k of method_table
} SkinFacts;

/// Open the scene in this skin.
static bool find_facts(const Variant* variant, SkinFacts* facts, Fault* fault) {
    char scene[80];
    snprintf(scene, sizeof scene, "%s.yaml", variant->chart->scene);
    WorldDef def;
    World world;
    if (!scene_load(scene, variant->set, variant->sets, &def, fault) ||
        !world_open(&world, &def, fault))
        return false;
    const SkinDef* skin = &world.balloon[0].def->skin;
    *facts = (SkinFacts){.known = true};
    snprintf(facts->skin, sizeof facts->skin, "%s",
             skin->springs    ? "springs"
             : skin->membrane ? "membrane"
                              : "-");
    snprintf(facts->law, sizeof facts->law, "%s",
             skin->springs    ? spring_law_name[skin->springs->law]
             : skin->membrane ? skin->membrane->material
                              : "-");
    for (int k = 0; k < method_count; k++)
        if (method_refuses(method_table[k], &world.balloon[0].body))
            facts->refusing |= 1u << k;
    world_close(&world);
    return true;
}

/// Add a point for the method in this row of method_table, or with facts NULL for the peer.
static void add_point(ChartPlan* plan, const Variant* variant, const SkinFacts* facts, int row,
                      int vertices, const char* precision) {
    const Method* method = facts ? method_table[row] : NULL;
    const ChartMeasure* measure = variant->measure;
    ChartPoint* point = &plan->point[plan->points++];
    *point = (ChartPoint){.chart = variant->chart,
                          .measure = measure,
                          .vertices = vertices,
                          .step = variant->resolution->step,
                          .precision = precision,
                          .truth = measure->truth ? measure->truth(variant->skin, measure->at)
                                                  : (double)NAN,
                          .apart = method && variant->skin->apart,
                          .launch = NONE};
    snprintf(point->name, sizeof point->name, "%s%s%s", variant->chart->scene,
             measure->name ? "." : "", measure->name ? measure->name : "");
    snprintf(point->method, sizeof point->method, "%s", method ? method->name : chart_peer_name);
    snprintf(point->skin, sizeof point->skin, "%s", facts ? facts->skin : "links");
    snprintf(point->law, sizeof point->law, "%s", facts ? facts->law : "-");
    if (facts && facts->refusing & 1u << row)
        return;

    Launch launch = {.words = 0};
    command(variant, method ? method->name : NULL, point->step, precision, &launch);
    point->launch = find_launch(plan, &launch);
}

static bool takes_part(const Method* method, ChartMethods methods) {
    switch (methods) {
        case EXPLICIT:
            return !method->implicit;
        case IMPLICIT:
            return method->implicit;
        case STABLE_UNDAMPED:
            return method_limit(method, 1, 0) > 0;
        default:
            return true;
    }
}

/// Add all points of one skin at one resolution for one measure: for all methods, or with facts
/// NULL for the peer.
static bool add_points(ChartPlan* plan, Variant* variant, SkinFacts* facts,
                       const ChartOptions* options, Fault* fault) {
    const ChartResolution* at = variant->resolution;
    const char* only = variant->skin->only;
    int vertices;
    if (!count_vertices(variant, &vertices, fault))
        return false;
    divide_mass(variant, vertices);
    if (facts && !facts->known && !find_facts(variant, facts, fault))
        return false;
    const bool both = at->state == BOTH || options->extent == CHART_ALL;
    for (int k = 0; k < (facts ? method_count : 1); k++) {
        const Method* method = method_table[k];
        if (facts &&
            (!takes_part(method, at->methods) || (only && strcmp(method->name, only) != 0)))
            continue;
        add_point(plan, variant, facts, k, vertices, "double");
        if (both)
            add_point(plan, variant, facts, k, vertices, "float");
    }
    return true;
}

/// The reference runs of a case without a closed form: h and h/2 of two methods.
static bool add_references(ChartPlan* plan, const ChartCase* chart, const ChartOptions* options,
                           Fault* fault) {
    const ChartReference* reference = &chart->reference;
    const ChartResolution at = {.model = reference->model};
    Variant variant;
    variant_make(&variant, chart, &chart->skin[0], &at, &chart->measure[0], options);
    plan->referred[plan->references / CHART_REFERENCES] = chart;
    int vertices;
    if (!count_vertices(&variant, &vertices, fault))
        return false;
    divide_mass(&variant, vertices);
    for (int k = 0; k < CHART_REFERENCES; k++) {
        Launch* launch = &plan->reference[plan->references++];
        const double step = reference->step[k / 2] / (k % 2 + 1);
        command(&variant, reference->method[k / 2], step, "double", launch);
    }
    return true;
}

static bool is_wanted(const ChartCase* chart, const char* only) {
    return !only || strcmp(chart->scene, only) == 0 || strcasecmp(chart->letter, only) == 0;
}

/// Add the points of one list of resolutions; with plan NULL, add only their number to *capacity.
static bool walk_resolutions(ChartPlan* plan, const ChartCase* chart, const ChartMeasure* measure,
                             const ChartSkin* skin, SkinFacts* facts, const ChartOptions* options,
                             int* capacity, Fault* fault) {
    const ChartResolution* at = skin ? skin->resolution : chart->peer.resolution;
    for (; at && at->model; at++) {
        if (at->extent > options->extent)
            continue;
        *capacity += 2 * method_count;
        if (!plan)
            continue;
        Variant variant;
        variant_make(&variant, chart, skin ? skin : &chart->skin[0], at, measure, options);
        if (!skin)
            add_peer_sets(&variant);
        if (!add_points(plan, &variant, facts, options, fault))
            return false;
    }
    return true;
}

/// Add the points of each measure, skin and resolution in the extent, in the order of chart.csv;
/// the peer is last.
static bool walk(ChartPlan* plan, const ChartCase* chart, const ChartOptions* options,
                 int* capacity, Fault* fault) {
    SkinFacts facts[CHART_SKINS] = {0};
    for (int m = 0; m < CHART_MEASURES && chart->measure[m].measured; m++) {
        const ChartMeasure* measure = &chart->measure[m];
        for (int s = 0; s < CHART_SKINS && chart->skin[s].resolution; s++)
            if (!walk_resolutions(plan, chart, measure, &chart->skin[s], &facts[s], options,
                                  capacity, fault))
                return false;
        if (!walk_resolutions(plan, chart, measure, NULL, NULL, options, capacity, fault))
            return false;
    }
    return true;
}

bool chart_plan(ChartPlan* plan, const ChartOptions* options, Fault* fault) {
    *plan = (ChartPlan){.extent = options->extent};
    int capacity = 0;
    for (int k = 0; k < chart_count; k++)
        if (is_wanted(chart_table[k], options->only))
            walk(NULL, chart_table[k], options, &capacity, fault);
    if (capacity == 0)
        return fault_set(fault, options->only, "no such scene in this chart; see balloon list");
    plan->point = new_array(ChartPoint, capacity);
    plan->launch = new_array(Launch, capacity);
    plan->reference = new_array(Launch, CHART_REFERENCES * chart_count);
    plan->referred = new_array(const ChartCase*, chart_count);
    for (int k = 0; k < chart_count; k++) {
        const int before = plan->points;
        if (!is_wanted(chart_table[k], options->only))
            continue;
        if (!walk(plan, chart_table[k], options, &capacity, fault))
            return false;
        if (plan->points > before && chart_table[k]->reference.model &&
            !add_references(plan, chart_table[k], options, fault))
            return false;
    }
    return true;
}

void chart_plan_free(ChartPlan* plan) {
    for (int k = 0; k < plan->launches; k++)
        launch_free(&plan->launch[k]);
    for (int k = 0; k < plan->references; k++)
        launch_free(&plan->reference[k]);
    free(plan->launch);
    free(plan->reference);
    free(plan->referred);
    free(plan->point);
    *plan = (ChartPlan){0};
}
