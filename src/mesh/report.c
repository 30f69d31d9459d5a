#include "mesh/doctor.h"

/// "valence: 3:8 4:2900 16+:1": how many points have how many edges.
static void print_valence(const MeshReport* report, FILE* out) {
    fprintf(out, "valence:");
    for (int v = 0; v <= VALENCE_MAX; v++)
        if (report->valence[v] > 0)
            fprintf(out, " %d%s:%d", v, v == VALENCE_MAX ? "+" : "", report->valence[v]);
    fprintf(out, "\n");
}

/// Genus, rims, area and volume are defined only if every edge and point is manifold.
static void print_measures(const MeshReport* report, FILE* out) {
    fprintf(out, "genus: %d\n", report->genus);
    fprintf(out, "rims: %d\n", report->rims);
    fprintf(out, "area: %.9g\n", report->area);
    if (report->rim_edges == 0)
        fprintf(out, "volume: %.9g (closed)\n", report->volume);
    else
        fprintf(out, "volume: none (open)\n");
}

void doctor_print(const MeshReport* report, FILE* out) {
    if (report->quads + report->triangles == 0)
        return;
    fprintf(out, "vertices: %d\n", report->points);
    fprintf(out, "faces: %d (%d quads, %d triangles)\n", report->quads + report->triangles,
            report->quads, report->triangles);
    print_valence(report, out);
    fprintf(out, "components: %d\n", report->components);
    fprintf(out, "boundary edges: %d\n", report->rim_edges);
    fprintf(out, "non-manifold edges: %d\n", report->nonmanifold_edges);
    fprintf(out, "non-manifold vertices: %d\n", report->nonmanifold_points);
    fprintf(out, "duplicate faces: %d\n", report->duplicate_faces);
    fprintf(out, "degenerate faces: %d\n", report->degenerate_faces);
    fprintf(out, "flipped faces: %d%s\n", report->flipped_faces,
            report->flipped_faces ? " (mended)" : "");
    fprintf(out, "seams: %d vertices welded\n", report->welded_points);
    fprintf(out, "unused vertices: %d%s\n", report->unused_points,
            report->unused_points ? " (left out)" : "");
    if (!report->unusable.text[0])
        print_measures(report, out);
}
