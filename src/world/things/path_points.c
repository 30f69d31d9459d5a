#include "world/things/path_points.h"

#include "base/memory.h"

PathPoint* path_points(const PathPointDef* def, unsigned count) {
    PathPoint* point = new_array(PathPoint, count);
    for (unsigned k = 0; k < count; k++) {
        const double* to = def[k].position;
        point[k] = (PathPoint){def[k].at, {to[0], to[1], to[2], 0}};
    }
    return point;
}
