#include "mesh/source.h"

#include <stdlib.h>

#include "base/memory.h"

void source_make(MeshSource* source, const char* name, int point_count, int face_count) {
    *source = (MeshSource){
        .name = name,
        .point_count = point_count,
        .face_count = face_count,
        .point = new_array(double4, point_count),
        .face = new_array(int[4], face_count),
    };
}

bool source_make_bounded(MeshSource* source, const char* path, long points, long faces,
                         Fault* fault) {
    if (points > POINTS_MAX || faces > FACES_MAX)
        return fault_set(fault, path,
                         "has %ld vertices and %ld faces; at most %d and %d can be read", points,
                         faces, POINTS_MAX, FACES_MAX);
    source_make(source, path, (int)points, (int)faces);
    return true;
}

void source_free(MeshSource* source) {
    free(source->point);
    free(source->face);
    free(source->point_line);
    free(source->face_line);
    *source = (MeshSource){0};
}
