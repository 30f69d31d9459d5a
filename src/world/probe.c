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
           energy(balloon, &force_strings);
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

static double gauge_pressure(const Balloon* balloon) {
    return inflation_pressure(&balloon->body);
}

static double lift(const Balloon* balloon) {
    return mass(&balloon->body) * body_helium(&balloon->body);
}

static double stretch_max(const Balloon* balloon) {
    const Springs* springs = &balloon->body.springs;
    double most = 0;
    for (int s = 0; s < springs->count; s++) {
        const int* end = springs->end[s];
        const double now = (double)length(balloon->body.x[end[0]] - balloon->body.x[end[1]]);
        if (springs->rest[s] > 0)
            most = fmax(most, now / (double)springs->rest[s]);
    }
    return most;
}

// clang-format off
static double px(const Balloon* b) { return momentum(&b->body)[0]; }
static double py(const Balloon* b) { return momentum(&b->body)[1]; }
static double pz(const Balloon* b) { return momentum(&b->body)[2]; }
static double lx(const Balloon* b) { return angular_momentum(&b->body)[0]; }
static double ly(const Balloon* b) { return angular_momentum(&b->body)[1]; }
static double lz(const Balloon* b) { return angular_momentum(&b->body)[2]; }
static double cx(const Balloon* b) { return center(&b->body)[0]; }
static double cy(const Balloon* b) { return center(&b->body)[1]; }
static double cz(const Balloon* b) { return center(&b->body)[2]; }

static bool always(const Balloon* b) { (void)b; return true; }
static bool closed(const Balloon* b) { return b->mesh.closed; }
static bool inflated(const Balloon* b) { return b->body.inflation.law != INFLATE_NONE; }
static bool lifted(const Balloon* b) { return b->def->helium != NULL; }
static bool sprung(const Balloon* b) { return b->body.springs.count > 0; }

static const struct Column {
    const char* name;
    bool (*has)(const Balloon* balloon);
    double (*measure)(const Balloon* balloon);
} column_table[] = {
    {"volume", closed, volume},
    {"area", always, area},
    {"gauge_pressure", inflated, gauge_pressure},
    {"lift", lifted, lift},
    {"kinetic", always, kinetic},
    {"elastic", sprung, elastic},
    {"total_energy", always, total_energy},
    {"px", always, px}, {"py", always, py}, {"pz", always, pz},
    {"lx", always, lx}, {"ly", always, ly}, {"lz", always, lz},
    {"cx", always, cx}, {"cy", always, cy}, {"cz", always, cz},
    {"stretch_max", sprung, stretch_max},
};
// clang-format on
enum { COLUMNS = sizeof column_table / sizeof *column_table };

/// What a column measures: the time, a balloon's quantity, or a string's tension.
typedef struct Measure {
    const World* world;
    const Balloon* balloon;      ///< NULL: the time
    const struct Column* column; ///< NULL: the tension of `string`
    int string;
} Measure;

static double value_of(const Measure* measure) {
    if (!measure->balloon)
        return world_time(measure->world);
    if (measure->column)
        return measure->column->measure(measure->balloon);
    // columns are those of the scene: a string that is untied for now has no tension
    const Body* body = &measure->balloon->body;
    return measure->string < body->string_count ? string_tension(body, measure->string) : 0;
}

/// Called for each column of the world in order; the walk ends when it returns true.
typedef bool (*Visit)(void* self, const char* name, const Measure* measure);

static bool walk(const World* world, Visit visit, void* self) {
    char name[64];
    Measure measure = {.world = world};
    if (visit(self, "t", &measure))
        return true;
    for (int b = 0; b < world->balloon_count; b++) {
        measure.balloon = &world->balloon[b];
        for (int k = 0; k < COLUMNS; k++) {
            measure.column = &column_table[k];
            snprintf(name, sizeof name, "balloon%d.%s", b, measure.column->name);
            if (measure.column->has(measure.balloon) && visit(self, name, &measure))
                return true;
        }
        measure.column = NULL;
        for (unsigned k = 0; k < measure.balloon->def->strings_count; k++) {
            measure.string = (int)k;
            snprintf(name, sizeof name, "balloon%d.string%u.tension", b, k);
            if (visit(self, name, &measure))
                return true;
        }
    }
    return false;
}

static bool print_name(void* self, const char* name, const Measure* measure) {
    fprintf(self, "%s%s", measure->balloon ? "," : "", name);
    return false;
}

static bool print_value(void* self, const char* name, const Measure* measure) {
    (void)name;
    fprintf(self, "%s%.17g", measure->balloon ? "," : "", value_of(measure));
    return false;
}

void probe_csv_header(const World* world, FILE* out) {
    walk(world, print_name, out);
    fputc('\n', out);
}

void probe_csv_row(const World* world, FILE* out) {
    walk(world, print_value, out);
    fputc('\n', out);
}

typedef struct Wanted {
    const char* name;
    double* value;
} Wanted;

static bool take(void* self, const char* name, const Measure* measure) {
    const Wanted* wanted = self;
    if (strcmp(name, wanted->name) != 0)
        return false;
    *wanted->value = value_of(measure);
    return true;
}

bool probe_value(const World* world, const char* column, double* value) {
    return walk(world, take, &(Wanted){column, value});
}

void probe_obj(const World* world, FILE* out) {
    int first = 0;
    for (int b = 0; b < world->balloon_count; b++) {
        write_obj(&world->balloon[b].mesh, world->balloon[b].body.x, first, out);
        first += world->balloon[b].mesh.point_count;
    }
}
