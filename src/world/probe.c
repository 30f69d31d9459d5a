#include "world/probe.h"

#include <string.h>

#include "mesh/write.h"
#include "world/outputs.h"

/// Called for each column of the world in order; the walk ends when it returns true.
typedef bool (*Visit)(void* self, const char* name, const Output* output,
                      const OutputSubject* subject);

/// The rows of one kind for one subject.
static bool walk_rows(OutputKind kind, const char* prefix, const OutputSubject* subject,
                      Visit visit, void* self) {
    char name[64];
    for (int k = 0; k < output_count; k++) {
        const Output* output = &output_table[k];
        if (output->kind != kind || (output->present && !output->present(subject->balloon)))
            continue;
        snprintf(name, sizeof name, "%s%s", prefix, output->column);
        if (visit(self, name, output, subject))
            return true;
    }
    return false;
}

/// Columns are those of the scene: an untied string has one too.
static bool walk_balloon(OutputSubject* subject, int b, Visit visit, void* self) {
    char prefix[48];
    subject->balloon = &subject->world->balloon[b];
    snprintf(prefix, sizeof prefix, "balloon%d.", b);
    if (walk_rows(OF_BALLOON, prefix, subject, visit, self))
        return true;
    for (unsigned k = 0; k < subject->balloon->def->strings_count; k++) {
        subject->number = (int)k;
        snprintf(prefix, sizeof prefix, "balloon%d.string%u.", b, k);
        if (walk_rows(OF_STRING, prefix, subject, visit, self))
            return true;
    }
    return false;
}

/// The floor is the first plane of a world that has one.
static bool walk_planes(OutputSubject* subject, Visit visit, void* self) {
    const WorldDef* def = &subject->world->def;
    char prefix[48];
    subject->number = 0;
    if (def->floor && walk_rows(OF_FLOOR, output_prefix[OF_FLOOR], subject, visit, self))
        return true;
    for (unsigned w = 0; w < def->walls_count; w++) {
        subject->number = (int)w + (def->floor ? 1 : 0);
        snprintf(prefix, sizeof prefix, "wall%u.", w);
        if (walk_rows(OF_WALL, prefix, subject, visit, self))
            return true;
    }
    return false;
}

/// spheres: number of balls with columns.
static bool walk(const World* world, int spheres, Visit visit, void* self) {
    OutputSubject subject = {.world = world};
    char prefix[48];
    if (walk_rows(OF_TIME, "", &subject, visit, self))
        return true;
    for (int b = 0; b < world->balloon_count; b++)
        if (walk_balloon(&subject, b, visit, self))
            return true;
    for (int s = 0; s < spheres; s++) {
        subject.number = s;
        snprintf(prefix, sizeof prefix, "sphere%d.", s);
        if (walk_rows(OF_SPHERE, prefix, &subject, visit, self))
            return true;
    }
    if (spheres > 0 && walk_rows(OF_SPHERES, "", &subject, visit, self))
        return true;
    if (walk_planes(&subject, visit, self))
        return true;
    for (int k = 0; k < world->thing_count; k++) {
        subject.number = k;
        snprintf(prefix, sizeof prefix, "thing%d.", k);
        if (walk_rows(OF_THING, prefix, &subject, visit, self))
            return true;
    }
    for (unsigned k = 0; k < world->def.knots_count; k++) {
        subject.number = (int)k;
        snprintf(prefix, sizeof prefix, "knot%u.", k);
        if (walk_rows(OF_KNOT, prefix, &subject, visit, self))
            return true;
    }
    const SkinContacts* skins = &world->def.contacts;
    if ((skins->self || skins->others || world->thing_count > 0) &&
        walk_rows(OF_SKINS, "", &subject, visit, self))
        return true;
    return guard_splits(&world->guard, world->method) &&
           walk_rows(OF_GUARD, output_prefix[OF_GUARD], &subject, visit, self);
}

static bool print_name(void* self, const char* name, const Output* output,
                       const OutputSubject* subject) {
    (void)subject;
    fprintf(self, "%s%s", output->kind == OF_TIME ? "" : ",", name);
    return false;
}

static bool print_value(void* self, const char* name, const Output* output,
                        const OutputSubject* subject) {
    (void)name;
    fprintf(self, "%s%.17g", output->kind == OF_TIME ? "" : ",", output_value(output, subject));
    return false;
}

void probe_csv_header(const World* world, FILE* out) {
    walk(world, (int)world->def.spheres_count, print_name, out);
}

void probe_csv_row(const World* world, FILE* out) {
    walk(world, (int)world->def.spheres_count, print_value, out);
}

typedef struct Search {
    const char* name;
    double* value;
} Search;

static bool match_name(void* self, const char* name, const Output* output,
                       const OutputSubject* subject) {
    const Search* search = self;
    if (strcmp(name, search->name) != 0)
        return false;
    *search->value = output_value(output, subject);
    return true;
}

bool probe_value(const World* world, const char* column, double* value) {
    const int scene = (int)world->def.spheres_count, now = world->contacts.sphere_count;
    return walk(world, now > scene ? now : scene, match_name, &(Search){column, value});
}

void probe_obj(const World* world, FILE* out) {
    int first = 0;
    for (int b = 0; b < world->balloon_count; b++) {
        write_obj(&world->balloon[b].mesh, world->balloon[b].body.x, first, out);
        first += world->balloon[b].mesh.point_count;
    }
}
