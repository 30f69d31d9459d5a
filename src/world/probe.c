#include "world/probe.h"

#include <string.h>

#include "force/force.h"
#include "force/inflation.h"
#include "force/strings.h"
#include "mesh/measure.h"
#include "mesh/write.h"

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

static double elastic(const Balloon* balloon) {
    return energy(balloon, &force_springs) + energy(balloon, &force_torsion) +
           energy(balloon, &force_membrane) + energy(balloon, &force_strings);
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
    const double pushed = mass(body) * body_helium(body);
    if (!body->inflation.weighs)
        return pushed;
    return pushed + body->gravity * (air_density * measure_volume(body->mesh, body->x) -
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
    double most = 0;
    for (int e = 0; e < membrane->count; e++)
        most = fmax(most, membrane_stretch(membrane, balloon->body.x, e));
    for (int s = 0; s < springs->count; s++) {
        const int* end = springs->end[s];
        const double now = (double)length(balloon->body.x[end[0]] - balloon->body.x[end[1]]);
        if (springs->rest[s] > 0)
            most = fmax(most, now / (double)springs->rest[s]);
    }
    return most;
}

static double thickness_min(const Balloon* balloon) {
    const Membrane* membrane = &balloon->body.membrane;
    double least = INFINITY;
    for (int e = 0; e < membrane->count; e++)
        least = fmin(least, membrane_thickness(membrane, balloon->body.x, e));
    return least;
}

static double rubber_volume(const Balloon* balloon) {
    return membrane_volume_ratio(&balloon->body.membrane, balloon->body.x).sum;
}

static double rubber_worst(const Balloon* balloon) {
    return membrane_volume_ratio(&balloon->body.membrane, balloon->body.x).worst;
}

// clang-format off
static double amount(const Balloon* b) { return b->body.inflation.amount; }
static double iterations(const Balloon* b) { return b->effort.iterations; }
static double products(const Balloon* b) { return b->effort.products; }
static double residual(const Balloon* b) { return b->effort.residual; }
static double px(const Balloon* b) { return momentum(&b->body)[0]; }
static double py(const Balloon* b) { return momentum(&b->body)[1]; }
static double pz(const Balloon* b) { return momentum(&b->body)[2]; }
static double lx(const Balloon* b) { return angular_momentum(&b->body)[0]; }
static double ly(const Balloon* b) { return angular_momentum(&b->body)[1]; }
static double lz(const Balloon* b) { return angular_momentum(&b->body)[2]; }
static double width(const Balloon* b) { return extent(b, 0); }
static double height(const Balloon* b) { return extent(b, 1); }
static double depth(const Balloon* b) { return extent(b, 2); }
static double cx(const Balloon* b) { return center(&b->body)[0]; }
static double cy(const Balloon* b) { return center(&b->body)[1]; }
static double cz(const Balloon* b) { return center(&b->body)[2]; }

static bool always(const Balloon* b) { (void)b; return true; }
static bool closed(const Balloon* b) { return b->mesh.closed; }
static bool inflated(const Balloon* b) { return b->body.inflation.law != INFLATE_NONE; }
static bool lifted(const Balloon* b) { return b->def->helium || b->body.inflation.weighs; }
static bool elastic_skin(const Balloon* b) { return b->def->skin.springs || b->def->skin.membrane; }
static bool thick(const Balloon* b) { return b->def->skin.membrane != NULL; }
static bool gassy(const Balloon* b) { return b->body.inflation.law == INFLATE_GAS; }
static bool solved(const Balloon* b) { return b->method->open != NULL; }

static const struct Column {
    const char* name;
    bool (*has)(const Balloon* balloon);
    double (*measure)(const Balloon* balloon);
} column_table[] = {
    {"volume", closed, volume},
    {"area", always, area},
    {"gauge_pressure", inflated, balloon_pressure},
    {"lift", lifted, lift},
    {"kinetic", always, kinetic},
    {"elastic", elastic_skin, elastic},
    {"total_energy", always, total_energy},
    {"px", always, px}, {"py", always, py}, {"pz", always, pz},
    {"lx", always, lx}, {"ly", always, ly}, {"lz", always, lz},
    {"cx", always, cx}, {"cy", always, cy}, {"cz", always, cz},
    {"width", always, width}, {"height", always, height}, {"depth", always, depth},
    {"stretch_max", elastic_skin, stretch_max},
    {"thickness_min", thick, thickness_min},
    {"rubber_volume", thick, rubber_volume},
    {"rubber_worst", thick, rubber_worst},
    {"amount", gassy, amount},
    {"iterations", solved, iterations},
    {"products", solved, products},
    {"residual", solved, residual},
};
// clang-format on
enum { COLUMNS = sizeof column_table / sizeof *column_table };

/// What a column measures: the time, a balloon's quantity, a string's tension, a ball's position or
/// velocity, or the pass-throughs.
typedef struct Measure {
    double (*of)(const struct Measure* measure);
    const World* world;
    const Balloon* balloon;
    const struct Column* column; ///< of the balloon
    int number;                  ///< of the string or ball
    int part;                    ///< of the ball, a row of sphere_parts
} Measure;

static double time_of(const Measure* measure) {
    return world_time(measure->world);
}

static double quantity_of(const Measure* measure) {
    return measure->column->measure(measure->balloon);
}

/// Columns are those of the scene: a string that is untied for now has no tension.
static double tension_of(const Measure* measure) {
    const Body* body = &measure->balloon->body;
    return measure->number < body->string_count ? string_tension(body, measure->number) : 0;
}

static const char* const sphere_parts[] = {"x", "y", "z", "vx", "vy", "vz"};
enum { SPHERE_PARTS = sizeof sphere_parts / sizeof *sphere_parts };

/// A ball that was taken away is nowhere.
static double part_of(const Measure* measure) {
    const Contacts* contacts = &measure->world->contacts;
    if (measure->number >= contacts->sphere_count)
        return (double)NAN;
    const Sphere* sphere = &contacts->sphere[measure->number];
    const real4 vector = measure->part < 3 ? sphere->x : sphere->v;
    return (double)vector[measure->part % 3];
}

static double pass_throughs_of(const Measure* measure) {
    return (double)measure->world->contacts.pass_throughs;
}

/// Called for each column of the world in order; the walk ends when it returns true.
typedef bool (*Visit)(void* self, const char* name, const Measure* measure);

static bool walk_balloon(Measure* measure, int b, Visit visit, void* self) {
    char name[64];
    measure->balloon = &measure->world->balloon[b];
    measure->of = quantity_of;
    for (int k = 0; k < COLUMNS; k++) {
        measure->column = &column_table[k];
        snprintf(name, sizeof name, "balloon%d.%s", b, measure->column->name);
        if (measure->column->has(measure->balloon) && visit(self, name, measure))
            return true;
    }
    measure->of = tension_of;
    for (unsigned k = 0; k < measure->balloon->def->strings_count; k++) {
        measure->number = (int)k;
        snprintf(name, sizeof name, "balloon%d.string%u.tension", b, k);
        if (visit(self, name, measure))
            return true;
    }
    return false;
}

static bool walk_spheres(Measure* measure, int count, Visit visit, void* self) {
    char name[64];
    measure->of = part_of;
    for (measure->number = 0; measure->number < count; measure->number++)
        for (measure->part = 0; measure->part < SPHERE_PARTS; measure->part++) {
            snprintf(name, sizeof name, "sphere%d.%s", measure->number,
                     sphere_parts[measure->part]);
            if (visit(self, name, measure))
                return true;
        }
    measure->of = pass_throughs_of;
    return count > 0 && visit(self, "pass_throughs", measure);
}

/// spheres: how many balls have columns.
static bool walk(const World* world, int spheres, Visit visit, void* self) {
    Measure measure = {.world = world, .of = time_of};
    if (visit(self, "t", &measure))
        return true;
    for (int b = 0; b < world->balloon_count; b++)
        if (walk_balloon(&measure, b, visit, self))
            return true;
    return walk_spheres(&measure, spheres, visit, self);
}

static bool print_name(void* self, const char* name, const Measure* measure) {
    fprintf(self, "%s%s", measure->of == time_of ? "" : ",", name);
    return false;
}

static bool print_value(void* self, const char* name, const Measure* measure) {
    (void)name;
    fprintf(self, "%s%.17g", measure->of == time_of ? "" : ",", measure->of(measure));
    return false;
}

void probe_csv_header(const World* world, FILE* out) {
    walk(world, (int)world->def.spheres_count, print_name, out);
}

void probe_csv_row(const World* world, FILE* out) {
    walk(world, (int)world->def.spheres_count, print_value, out);
}

typedef struct Wanted {
    const char* name;
    double* value;
} Wanted;

static bool take(void* self, const char* name, const Measure* measure) {
    const Wanted* wanted = self;
    if (strcmp(name, wanted->name) != 0)
        return false;
    *wanted->value = measure->of(measure);
    return true;
}

bool probe_value(const World* world, const char* column, double* value) {
    const int scene = (int)world->def.spheres_count, now = world->contacts.sphere_count;
    return walk(world, now > scene ? now : scene, take, &(Wanted){column, value});
}

void probe_obj(const World* world, FILE* out) {
    int first = 0;
    for (int b = 0; b < world->balloon_count; b++) {
        write_obj(&world->balloon[b].mesh, world->balloon[b].body.x, first, out);
        first += world->balloon[b].mesh.point_count;
    }
}
