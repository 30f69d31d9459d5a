#include <strings.h>

#include <string.h>

#include "base/memory.h"
#include "lab/chart.h"
#include "mesh/load.h"
#include "world/place.h"
#include "world/world.h"

enum { SETS = CHART_SETS + 4 };

/// One skin of a case at one resolution, for one measure: what all methods share.
typedef struct Dress {
    const ChartCase* chart;
    const ChartSkin* skin;
    const ChartResolution* resolution;
    const ChartMeasure* measure;
    char text[SETS][160];
    SceneSet set[SETS];
    int sets;
} Dress;

static void add_set(Dress* dress, const char* text) {
    char* copy = dress->text[dress->sets];
    snprintf(copy, sizeof dress->text[0], "%s", text);
    dress->set[dress->sets++].text = copy;
}

/// In place, for it points into itself.
static void dress_make(Dress* dress, const ChartCase* chart, const ChartSkin* skin,
                       const ChartResolution* resolution, const ChartMeasure* measure) {
    *dress = (Dress){.chart = chart, .skin = skin, .resolution = resolution, .measure = measure};
    char model[160];
    snprintf(model, sizeof model, "balloons.0.model=%s", resolution->model);
    add_set(dress, model);
    for (int k = 0; k < CHART_SETS && skin->set[k]; k++)
        add_set(dress, skin->set[k]);
    if (measure->set)
        add_set(dress, measure->set);
}

/// Give every particle its share of the skin's mass, once it is known how many there are.
static bool share_mass(Dress* dress, Fault* fault) {
    if (dress->skin->mass == 0)
        return true;
    char path[512], text[160];
    const WorldDef nowhere = {0};
    Mesh mesh = {0};
    MeshReport report = {0};
    if (!scene_model_path(&nowhere, dress->resolution->model, path, fault) ||
        !mesh_load(path, &mesh, &report, fault))
        return false;
    snprintf(text, sizeof text, "balloons.0.mass={per_particle: %.17g}",
             dress->skin->mass / mesh.point_count);
    add_set(dress, text);
    mesh_free(&mesh);
    return true;
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

/// The command line of a point.
static bool command(const Dress* dress, const ChartPoint* point, Launch* launch, Fault* fault) {
    char program[512];
    if (!place_sibling(strcmp(point->precision, "double") == 0 ? "balloon-double" : "balloon",
                       program, fault))
        return false;
    launch_add(launch, "%s", program);
    launch_add(launch, "run");
    launch_add(launch, "%s", dress->chart->scene);
    launch_add(launch, "--method=%s", point->method);
    launch_add(launch, "--step=%.17g", point->step);
    for (int k = 0; k < dress->sets; k++)
        launch_add(launch, "--set=%s", dress->set[k].text);
    launch_add(launch, "--seconds=%.17g", dress->chart->seconds);
    launch_add(launch, "--fps=%.17g", dress->chart->rows);
    launch_add(launch, "--csv=-");
    launch_add(launch, "--time");
    launch_add(launch, "--hash");
    return true;
}

static const char* skin_of(const BalloonDef* balloon, const char** law) {
    *law = balloon->skin.springs    ? spring_law_name[balloon->skin.springs->law]
           : balloon->skin.membrane ? balloon->skin.membrane->material
                                    : "-";
    return balloon->skin.springs ? "springs" : balloon->skin.membrane ? "membrane" : "-";
}

static bool add_point(ChartPlan* plan, const Dress* dress, const World* world, const Method* method,
                      const char* precision, Fault* fault) {
    const char* law;
    ChartPoint* point = &plan->point[plan->points++];
    *point = (ChartPoint){.chart = dress->chart,
                          .measure = dress->measure,
                          .vertices = world->balloon[0].body.count,
                          .step = dress->resolution->step,
                          .precision = precision,
                          .truth = dress->measure->truth(dress->skin),
                          .launch = NONE};
    const char* measure = dress->measure->name;
    snprintf(point->name, sizeof point->name, "%s%s%s", dress->chart->scene, measure ? "." : "",
             measure ? measure : "");
    snprintf(point->method, sizeof point->method, "%s", method->name);
    snprintf(point->skin, sizeof point->skin, "%s", skin_of(world->balloon[0].def, &law));
    snprintf(point->law, sizeof point->law, "%s", law);
    snprintf(point->model, sizeof point->model, "%s", dress->resolution->model);
    if (method->refuses && method->refuses(&world->balloon[0].body))
        return true;

    Launch launch = {.words = 0};
    if (!command(dress, point, &launch, fault)) {
        launch_free(&launch);
        return false;
    }
    point->launch = find_launch(plan, &launch);
    return true;
}

/// Implicit methods are those that no step makes unstable.
static bool takes_part(const Method* method, ChartWho who) {
    const bool implicit = method->limit(INFINITY, INFINITY) == INFINITY;
    return who == ANY || (who == IMPLICIT) == implicit;
}

/// All points of one skin at one resolution, for one measure.
static bool add_points(ChartPlan* plan, Dress* dress, const ChartOptions* options, Fault* fault) {
    const ChartResolution* at = dress->resolution;
    WorldDef def;
    World world;
    if (!share_mass(dress, fault) ||
        !scene_load(dress->chart->scene, dress->set, dress->sets, &def, fault) ||
        !world_open(&world, &def, fault))
        return false;
    bool good = true;
    for (int k = 0; good && k < method_count; k++) {
        if (!takes_part(method_table[k], at->who))
            continue;
        good = add_point(plan, dress, &world, method_table[k], "double", fault);
        if (at->state == BOTH || options->extent == CHART_ALL)
            good = good && add_point(plan, dress, &world, method_table[k], "float", fault);
    }
    world_close(&world);
    return good;
}

static bool is_wanted(const ChartCase* chart, const char* only) {
    return !only || strcmp(chart->scene, only) == 0 || strcasecmp(chart->letter, only) == 0;
}

/// Calls for each measure, skin and resolution of the extent, in the order of chart.csv.
static bool walk(ChartPlan* plan, const ChartCase* chart, const ChartOptions* options, int* room,
                 Fault* fault) {
    for (int m = 0; m < CHART_MEASURES && chart->measure[m].measured; m++)
        for (int s = 0; s < CHART_SKINS && chart->skin[s].resolution; s++)
            for (const ChartResolution* at = chart->skin[s].resolution; at->model; at++) {
                if (at->extent > options->extent)
                    continue;
                *room += 2 * method_count;
                if (!plan)
                    continue;
                Dress dress;
                dress_make(&dress, chart, &chart->skin[s], at, &chart->measure[m]);
                if (!add_points(plan, &dress, options, fault))
                    return false;
            }
    return true;
}

bool chart_plan(ChartPlan* plan, const ChartOptions* options, Fault* fault) {
    *plan = (ChartPlan){0};
    int room = 0;
    for (int k = 0; k < chart_count; k++)
        if (is_wanted(chart_table[k], options->only))
            walk(NULL, chart_table[k], options, &room, fault);
    if (room == 0)
        return fault_set(fault, options->only, "no such scene in the chart; see balloon list");
    plan->point = new_array(ChartPoint, room);
    plan->launch = new_array(Launch, room);
    for (int k = 0; k < chart_count; k++)
        if (is_wanted(chart_table[k], options->only) &&
            !walk(plan, chart_table[k], options, &room, fault))
            return false;
    return true;
}

void chart_plan_free(ChartPlan* plan) {
    for (int k = 0; k < plan->launches; k++)
        launch_free(&plan->launch[k]);
    free(plan->launch);
    free(plan->point);
    *plan = (ChartPlan){0};
}
