#include "lab/run/refinement.h"

#include <string.h>

#include "mesh/load.h"
#include "mesh/shape.h"
#include "scene/key.h"

enum { MAX_NAME = 96 };

/// Change a number of a shape's name; returns whether the result is within min … max.
static bool refine_number(const Shape* shape, int refinement, int* n, int min, int max) {
    if (strcmp(shape->name, "icosphere") == 0)
        *n += refinement;
    else if (refinement < 0)
        *n >>= -refinement;
    else
        *n <<= refinement;
    return *n >= min && *n <= max;
}

/// The shape's name at another refinement; false if there is none.
static bool refined_name(const char* model, int refinement, char name[MAX_NAME]) {
    const Shape* shape = shape_find(model);
    const char* colon = strchr(model, ':');
    int n[2];
    if (!shape || !colon || refinement == 0)
        return false;
    sscanf(colon, ":%dx%d", &n[0], &n[1]);
    for (int k = 0; k < shape->numbers; k++)
        if (!refine_number(shape, refinement, &n[k], shape->min[k], shape->max[k]))
            return false;
    snprintf(name, MAX_NAME, shape->numbers == 1 ? "%s:%d" : "%s:%dx%d", shape->name, n[0], n[1]);
    return true;
}

/// Number of points of a built-in shape.
static int points_of(const char* model) {
    Mesh mesh = {0};
    MeshReport report = {0};
    Fault unused = {0};
    const int count = mesh_load(model, &mesh, &report, &unused) ? mesh.point_count : 0;
    mesh_free(&mesh);
    return count;
}

static bool is_number(const char* at) {
    return at && strspn(at, "0123456789") > 0;
}

/// Whether a string is tied to a particle of balloon b by its number, which holds for one mesh only.
static bool is_tied_by_number(const WorldDef* def, unsigned b) {
    for (unsigned k = 0; k < def->balloons_count; k++)
        for (unsigned s = 0; s < def->balloons[k].strings_count; s++) {
            const StringDef* string = &def->balloons[k].strings[s];
            if ((k == b && is_number(string->at)) ||
                (string->to_balloon && *string->to_balloon == b && is_number(string->to_at)))
                return true;
        }
    return false;
}

/// Overrides of a balloon's numbers per particle.
typedef struct Shares {
    Overrides* sets;
    char balloon[32]; ///< its path, with a dot
    double share;     ///< particles before over particles after [1]
} Shares;

static void share_number(const KeyValue* value, void* context) {
    const Shares* shares = context;
    if (value->key->is.per_particle && value->number > 0 &&
        strncmp(value->path, shares->balloon, strlen(shares->balloon)) == 0)
        overrides_add(shares->sets, "%s=%.17g", value->path, shares->share * value->number);
}

bool refinement_add(const World* world, int refinement, Overrides* sets) {
    const int before = sets->count;
    for (unsigned b = 0; b < world->def.balloons_count; b++) {
        const BalloonDef* balloon = &world->def.balloons[b];
        char name[MAX_NAME];
        if (is_tied_by_number(&world->def, b) || !refined_name(balloon->model, refinement, name))
            continue;
        Shares shares = {.sets = sets,
                         .share = (double)world->balloon[b].body.count / points_of(name)};
        snprintf(shares.balloon, sizeof shares.balloon, "balloons.%u.", b);
        overrides_add(sets, "%smodel=%s", shares.balloon, name);
        key_each_value(&world->def, share_number, &shares);
    }
    return sets->count > before;
}
