#include "mesh/doctor.h"

#include <stdlib.h>

#include "base/memory.h"
#include "mesh/edges.h"
#include "mesh/facet.h"
#include "mesh/validate.h"
#include "mesh/disjoint_sets.h"
#include "mesh/weld.h"
#include "mesh/orient.h"

static void count_faces(const MeshSource* source, MeshReport* report) {
    for (int f = 0; f < source->face_count; f++)
        report->quads += source->face[f][3] != NONE;
    report->triangles = source->face_count - report->quads;
}

/// Histogram of the points' numbers of edges; points without edges are not counted.
static void count_points(const MeshSource* source, const Edges* edges, MeshReport* report) {
    int* valence = new_array(int, source->point_count);
    for (int e = 0; e < edges->count; e++)
        for (int k = 0; k < 2; k++)
            valence[edges->end[e][k]]++;
    for (int i = 0; i < source->point_count; i++) {
        report->points += valence[i] > 0;
        if (valence[i] > 0)
            report->valence[valence[i] < VALENCE_MAX ? valence[i] : VALENCE_MAX]++;
    }
    report->unused_points = source->point_count - report->points - report->welded_points;
    free(valence);
}

/// Rim edges, and the loops that they form.
static void count_rims(const MeshSource* source, const Edges* edges, MeshReport* report) {
    int* loop = disjoint_make(source->point_count);
    for (int e = 0; e < edges->count; e++)
        if (edges->sides[e] == 1)
            disjoint_join(loop, edges->end[e][0], edges->end[e][1]);

    // each point of a sound rim begins one of its edges, so each loop is counted at its root
    char* counted = new_array(char, source->point_count);
    for (int e = 0; e < edges->count; e++) {
        if (edges->sides[e] != 1)
            continue;
        const int root = disjoint_root(loop, edges->end[e][0]);
        report->rim_edges++;
        report->rims += !counted[root];
        counted[root] = 1;
    }
    free(loop);
    free(counted);
}

/// Number the points in order of first use by a face, and leave out what no face uses.
static void number_by_first_use(MeshSource* source, int used) {
    int* number = new_array(int, source->point_count);
    double4* point = new_array(double4, used);
    long* line = source->point_line ? new_array(long, used) : NULL;
    int count = 0;
    for (int c = 0; c < 4 * source->face_count; c++) {
        int* corner = &source->face[c / 4][c % 4];
        if (*corner == NONE)
            continue;
        if (number[*corner] == 0) {
            point[count] = source->point[*corner];
            if (line)
                line[count] = source->point_line[*corner];
            number[*corner] = ++count;
        }
        *corner = number[*corner] - 1;
    }
    free(number);
    free(source->point);
    free(source->point_line);
    source->point = point;
    source->point_line = line;
    source->point_count = count;
}

/// Area and volume in the file's unit, in double in both builds.
static void measure(const Mesh* mesh, MeshReport* report) {
    for (int f = 0; f < mesh->face_count; f++) {
        const Facet facet = facet_of(mesh->point, mesh->face[f]);
        report->area += dlength(facet_area(&facet));
        if (mesh->closed)
            report->volume += facet_volume(&facet, mesh->point[0]);
    }
}

/// Euler: points - edges + faces + rims = 2 components - 2 genus.
static int find_genus(const MeshSource* source, const Edges* edges, const MeshReport* report) {
    const int euler = report->points - edges->count + source->face_count + report->rims;
    return report->components - euler / 2;
}

static void examine(MeshSource* source, MeshReport* report) {
    // sew first: degenerate and duplicate faces and rims are counted on the sewn mesh
    count_faces(source, report);
    report->welded_points = weld_seams(source);
    Edges edges;
    edges_find(&edges, (const int(*)[4])source->face, source->face_count, source->point_count);
    count_points(source, &edges, report);
    count_rims(source, &edges, report);

    validate_degenerate(source, report);
    validate_duplicate(source, report);
    validate_edges(source, &edges, report);
    validate_points(source, &edges, report);

    const Orientation orientation = orient_faces(source, &edges);
    report->components = orientation.components;
    report->flipped_faces = orientation.flipped;
    validate_one_sided(source, orientation.clash, report);

    if (!report->unusable.text[0])
        report->genus = find_genus(source, &edges, report);
    edges_free(&edges);
}

bool doctor_treat(MeshSource* source, Mesh* mesh, MeshReport* report) {
    *mesh = (Mesh){0};
    *report = (MeshReport){0};
    if (source->face_count == 0)
        return fault_set(&report->unusable, source->name,
                         "there are no faces, and a skin is made of faces");

    examine(source, report);
    number_by_first_use(source, report->points);
    if (report->unusable.text[0])
        return false;
    mesh_make(mesh, source->point, source->point_count, (const int(*)[4])source->face,
              source->face_count);
    measure(mesh, report);
    return true;
}
