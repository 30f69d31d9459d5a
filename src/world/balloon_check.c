#include "world/balloon_check.h"

#include <math.h>
#include <stdlib.h>

static const double shape_resolution = 1e-3; ///< [1] of a size, largest spacing of numbers

/// Largest coordinate [m]: its cube is a number of float, and Bullet's boxes end at 1e18 m.
static const double coordinate_max = 1e12;

/// Flexion springs and torsion join the ends of each two edges at a vertex: too many, if it has many.
static bool check_paths(const Balloon* balloon, const char* location, int number, Fault* fault) {
    const SpringsDef* springs = balloon->def->skin.springs;
    int vertex = 0;
    if (!springs || springs->flexion + springs->torsion <= 0)
        return true;
    const double paths = springs_paths(&balloon->mesh, &vertex);
    return paths <= SPRING_PATHS_MAX ||
           fault_set(fault, location,
                     "balloons.%d: %s has %.3g paths of two edges, most through particle %d; set "
                     "skin.springs.flexion and torsion to 0, which join the ends of each",
                     number, balloon->def->model, paths, balloon->mesh.loaded[vertex]);
}

bool balloon_check_mesh(const Balloon* balloon, const char* location, int number, Fault* fault) {
    const BalloonDef* def = balloon->def;
    const bool encloses = def->inflation && def->inflation->law != INFLATE_AREA &&
                          def->inflation->law != INFLATE_NONE;
    if (encloses && !balloon->mesh.closed)
        return fault_set(fault, location,
                         "balloons.%d: %s is open, and '%s' inflation needs a closed mesh; take "
                         "law 'area' or close it",
                         number, def->model, inflation_law_name[def->inflation->law]);
    for (unsigned k = 0; k < def->strings_count; k++)
        if (def->strings[k].at && def->strings[k].at[0] >= '0' && def->strings[k].at[0] <= '9' &&
            strtol(def->strings[k].at, NULL, 10) >= balloon->mesh.point_count)
            return fault_set(fault, location,
                             "balloons.%d.strings.%u.at: %s has particles 0 to %d, not %s", number,
                             k, def->model, balloon->mesh.point_count - 1, def->strings[k].at);
    return check_paths(balloon, location, number, fault);
}

bool balloon_check_position(const Body* body, const char* location, const char* name,
                            Fault* fault) {
    double farthest = 0;
    bool finite = true;
    for (int i = 0; i < body->count; i++)
        for (int k = 0; k < 3; k++) {
            farthest = fmax(farthest, fabs((double)body->x[i][k]));
            finite = finite && isfinite(body->x[i][k]);
        }
    if (finite && farthest > coordinate_max)
        return fault_set(fault, location,
                         "%s: it reaches %g m from the origin; coordinates are at most %g m", name,
                         farthest, coordinate_max);
    const double spacing = farthest * (double)REAL_EPSILON;
    return (finite && spacing <= shape_resolution * (double)body->size) ||
           fault_set(fault, location,
                     "%s: at %g m a state of " REAL_NAME " resolves %.2g m, which is too "
                     "coarse for its %g m; move it toward the origin",
                     name, farthest, spacing, (double)body->size);
}
