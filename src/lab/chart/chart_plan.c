#include <math.h>
#include <stdarg.h>
#include <string.h>
#include <strings.h>

#include "base/memory.h"
#include "lab/chart/chart.h"
#include "mesh/load.h"
#include "world/world.h"

enum { SETS = 2 * CHART_SETS + 5 };

/// One skin of a case at one resolution, for one measure: what all methods share.
typedef struct Dress {
    const ChartCase* chart;
    const ChartSkin* skin;
    const ChartResolution* resolution;
    const ChartMeasure* measure;
    const char* const* program;
    char text[SETS][220];
    SceneSet set[SETS];
    int sets;
} Dress;

__attribute__((format(printf, 2, 3))) static void add_set(Dress* dress, const char* format, ...) {
    char* text = dress->text[dress->sets];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof dress->text[0], format, list);
    va_end(list);
    dress->set[dress->sets++].text = text;
}

/// In place, for it points into itself.
static void dress_make(Dress* dress, const ChartCase* chart, const ChartSkin* skin,
                       const ChartResolution* resolution, const ChartMeasure* measure,
                       const ChartOptions* options) {
    *dress = (Dress){.chart = chart,
                     .skin = skin,
                     .resolution = resolution,
                     .measure = measure,
                     .program = options->program};
    add_set(dress, "balloons.0.model=%s", resolution->model);
    for (int k = 0; k < CHART_SETS && skin->set[k]; k++)
        add_set(dress, "%s", skin->set[k]);
    if (skin->law) { // kd = E h/2, and of E h = ks + 4 kf a third in flexion
        const double sheet = skin->sheet();
        add_set(dress,
                "balloons.0.skin={springs: {structural: %.17g, shear: %.17g, flexion: %.17g, law: "
                "%s}}",
                sheet * 2 / 3, sheet / 2, sheet / 12, skin->law);
    }
    if (measure->key)
        add_set(dress, "%s=%.17g", measure->key, measure->value(measure->at));
}

/// What the peer's scene has of its own.
static void dress_peer(Dress* dress) {
    const ChartPeer* peer = &dress->chart->peer;
    for (int k = 0; k < CHART_SETS && peer->set[k]; k++)
        add_set(dress, "%s", peer->set[k]);
    if (peer->key)
        add_set(dress, "%s=%.17g", peer->key, peer->value());
}

/// Give every particle its share of the skin's mass, once it is known how many there are.
static bool share_mass(Dress* dress, Fault* fault) {
    if (dress->skin->mass == 0)
        return true;
    char path[512];
    const WorldDef nowhere = {0};
    Mesh mesh = {0};
    MeshReport report = {0};
    if (!scene_model_path(&nowhere, dress->resolution->model, path, fault) ||
        !mesh_load(path, &mesh, &report, fault))
        return false;
    add_set(dress, "balloons.0.mass={per_particle: %.17g}", dress->skin->mass / mesh.point_count);
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

/// The command line of a run by a method, or NULL: by the peer.
static void command(const Dress* dress, const char* method, double step, const char* precision,
                    Launch* launch) {
    const ChartPeer* peer = &dress->chart->peer;
    launch_add(launch, "%s", dress->program[strcmp(precision, "double") == 0]);
    launch_add(launch, method ? "run" : "peer");
    launch_add(launch, "%s.yaml", dress->chart->scene);
    if (method)
        launch_add(launch, "--method=%s", method);
    else if (peer->spring > 0)
        launch_add(launch, "--fit=%.17g", peer->spring);
    else if (peer->pressure)
        launch_add(launch, "--fit=%.17g,%.17g,%.17g", peer->pressure(), pow(peer->stretch(), 3),
                   peer->step);
    launch_add(launch, "--step=%.17g", step);
    for (int k = 0; k < dress->sets; k++)
        launch_add(launch, "--set=%s", dress->set[k].text);
    launch_add(launch, "--seconds=%.17g", dress->chart->seconds);
    launch_add(launch, "--fps=%.17g", dress->chart->rows);
    launch_add(launch, "--csv=-");
    launch_add(launch, "--report");
}

static const char* skin_of(const BalloonDef* balloon, const char** law) {
    *law = balloon->skin.springs    ? spring_law_name[balloon->skin.springs->law]
           : balloon->skin.membrane ? balloon->skin.membrane->material
                                    : "-";
    return balloon->skin.springs ? "springs" : balloon->skin.membrane ? "membrane" : "-";
}

/// method NULL: the peer's.
static void add_point(ChartPlan* plan, const Dress* dress, const World* world, const Method* method,
                      const char* precision) {
    const char* law;
    const ChartMeasure* measure = dress->measure;
    ChartPoint* point = &plan->point[plan->points++];
    *point = (ChartPoint){.chart = dress->chart,
                          .measure = measure,
                          .vertices = world->balloon[0].body.count,
                          .step = dress->resolution->step,
                          .precision = precision,
                          .truth = measure->truth ? measure->truth(dress->skin, measure->at)
                                                  : (double)NAN,
                          .apart = method && dress->skin->apart,
                          .launch = NONE};
    snprintf(point->name, sizeof point->name, "%s%s%s", dress->chart->scene,
             measure->name ? "." : "", measure->name ? measure->name : "");
    const char* skin = skin_of(world->balloon[0].def, &law);
    snprintf(point->method, sizeof point->method, "%s", method ? method->name : chart_peer_name);
    snprintf(point->skin, sizeof point->skin, "%s", method ? skin : "links");
    snprintf(point->law, sizeof point->law, "%s", method ? law : "-");
    if (method && method_refuses(method, &world->balloon[0].body))
        return;

    Launch launch = {.words = 0};
    command(dress, method ? method->name : NULL, point->step, precision, &launch);
    point->launch = find_launch(plan, &launch);
}

static bool takes_part(const Method* method, ChartWho who) {
    switch (who) {
        case EXPLICIT:
            return !method->implicit;
        case IMPLICIT:
            return method->implicit;
        case HELD:
            return method_limit(method, 1, 0) > 0;
        default:
            return true;
    }
}

/// All points of one skin at one resolution, for one measure; of the peer, or of all methods.
static bool add_points(ChartPlan* plan, Dress* dress, bool peer, const ChartOptions* options,
                       Fault* fault) {
    const ChartResolution* at = dress->resolution;
    const char* only = dress->skin->only;
    char scene[80];
    snprintf(scene, sizeof scene, "%s.yaml", dress->chart->scene);
    WorldDef def;
    World world;
    if (!share_mass(dress, fault) || !scene_load(scene, dress->set, dress->sets, &def, fault) ||
        !world_open(&world, &def, fault))
        return false;
    const bool both = at->state == BOTH || options->extent == CHART_ALL;
    for (int k = 0; k < (peer ? 1 : method_count); k++) {
        const Method* method = peer ? NULL : method_table[k];
        if (method && (!takes_part(method, at->who) || (only && strcmp(method->name, only) != 0)))
            continue;
        add_point(plan, dress, &world, method, "double");
        if (both)
            add_point(plan, dress, &world, method, "float");
    }
    world_close(&world);
    return true;
}

/// The runs that tell what is true where no closed form does: h and h/2 of two methods.
static bool add_references(ChartPlan* plan, const ChartCase* chart, const ChartOptions* options,
                           Fault* fault) {
    const ChartReference* reference = &chart->reference;
    const ChartResolution at = {.model = reference->model};
    Dress dress;
    dress_make(&dress, chart, &chart->skin[0], &at, &chart->measure[0], options);
    plan->referred[plan->references / CHART_REFERENCES] = chart;
    if (!share_mass(&dress, fault))
        return false;
    for (int k = 0; k < CHART_REFERENCES; k++) {
        Launch* launch = &plan->reference[plan->references++];
        const double step = reference->step[k / 2] / (k % 2 + 1);
        command(&dress, reference->method[k / 2], step, "double", launch);
    }
    return true;
}

static bool is_wanted(const ChartCase* chart, const char* only) {
    return !only || strcmp(chart->scene, only) == 0 || strcasecmp(chart->letter, only) == 0;
}

/// The points of one list of resolutions; without a plan only their number is added to room.
static bool walk_resolutions(ChartPlan* plan, const ChartCase* chart, const ChartMeasure* measure,
                             const ChartSkin* skin, const ChartOptions* options, int* room,
                             Fault* fault) {
    const ChartResolution* at = skin ? skin->resolution : chart->peer.resolution;
    for (; at && at->model; at++) {
        if (at->extent > options->extent)
            continue;
        *room += 2 * method_count;
        if (!plan)
            continue;
        Dress dress;
        dress_make(&dress, chart, skin ? skin : &chart->skin[0], at, measure, options);
        if (!skin)
            dress_peer(&dress);
        if (!add_points(plan, &dress, !skin, options, fault))
            return false;
    }
    return true;
}

/// Each measure, skin and resolution of the extent, in the order of chart.csv; the peer last.
static bool walk(ChartPlan* plan, const ChartCase* chart, const ChartOptions* options, int* room,
                 Fault* fault) {
    for (int m = 0; m < CHART_MEASURES && chart->measure[m].measured; m++) {
        const ChartMeasure* measure = &chart->measure[m];
        for (int s = 0; s < CHART_SKINS && chart->skin[s].resolution; s++)
            if (!walk_resolutions(plan, chart, measure, &chart->skin[s], options, room, fault))
                return false;
        if (!walk_resolutions(plan, chart, measure, NULL, options, room, fault))
            return false;
    }
    return true;
}

bool chart_plan(ChartPlan* plan, const ChartOptions* options, Fault* fault) {
    *plan = (ChartPlan){.extent = options->extent};
    int room = 0;
    for (int k = 0; k < chart_count; k++)
        if (is_wanted(chart_table[k], options->only))
            walk(NULL, chart_table[k], options, &room, fault);
    if (room == 0)
        return fault_set(fault, options->only, "no such scene in this chart; see balloon list");
    plan->point = new_array(ChartPoint, room);
    plan->launch = new_array(Launch, room);
    plan->reference = new_array(Launch, CHART_REFERENCES * chart_count);
    plan->referred = new_array(const ChartCase*, chart_count);
    for (int k = 0; k < chart_count; k++) {
        const int before = plan->points;
        if (!is_wanted(chart_table[k], options->only))
            continue;
        if (!walk(plan, chart_table[k], options, &room, fault))
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
