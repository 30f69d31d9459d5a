#include "world/things/path_points.h"

#include "base/memory.h"

PathPoint* path_points(const PathPointDef* def, unsigned count) {
    PathPoint* point = new_array(PathPoint, count);
    for (unsigned k = 0; k < count; k++) {
        point[k] = (PathPoint){.at = def[k].at};
        for (int c = 0; c < 3; c++) {
            point[k].position[c] = def[k].position[c];
            point[k].rotation[c] = def[k].rotation ? def[k].rotation[c] * PI / 180 : 0;
        }
    }
    return point;
}
