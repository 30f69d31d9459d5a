#include "mesh/point_corners.h"

#include <stdlib.h>

#include "base/memory.h"
#include "mesh/counting_sort.h"

PointCorners point_corners_open(const Mesh* mesh) {
    const int count = 3 * mesh->triangle_count;
    const PointCorners corners = {new_array(int, mesh->point_count + 1), new_array(int, count)};
    counting_sort(mesh->triangle[0], count, mesh->point_count, corners.from, corners.corner);
    return corners;
}

void point_corners_close(PointCorners* corners) {
    free(corners->from);
    free(corners->corner);
}
