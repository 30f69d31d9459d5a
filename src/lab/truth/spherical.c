#include "lab/truth/spherical.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "force/material.h"
#include "mesh/measure.h"

/// Minimum volume of a mesh over that of the sphere through its points: excludes a cube. [1]
static const double min_fill = 0.85;

/// Tolerance of the points' distances from the center. [R0]
static const double radius_tolerance = 1e-3;

/// R0 of a sphere, 0 of another shape. [unit of the mesh]
static double radius_of(const Mesh* mesh) {
    double4 center = {0, 0, 0, 0};
    for (int i = 0; i < mesh->point_count; i++)
        center += mesh->point[i] / mesh->point_count;
    double min = INFINITY, max = 0;
    for (int i = 0; i < mesh->point_count; i++) {
        const double r = dlength(mesh->point[i] - center);
        min = fmin(min, r);
        max = fmax(max, r);
    }
    const double radius = (min + max) / 2;
    return max - min <= 2 * radius_tolerance * radius ? radius : 0;
}

static double volume_of(const Mesh* mesh) {
    real4* x = new_array(real4, mesh->point_count);
    for (int i = 0; i < mesh->point_count; i++)
        for (int k = 0; k < 3; k++)
            x[i][k] = (real)mesh->point[i][k];
    const double volume = measure_volume(mesh, x);
    free(x);
    return volume;
}

static bool rubber(const Balloon* balloon, TruthBalloon* truth) {
    const MembraneDef* def = balloon->def->skin.membrane;
    const Rubber* skin = &balloon->body.membrane.rubber;
    if (!def || def->patches_count > 0)
        return false;
    truth->law = truth_law_find(skin->material->name);
    truth->thickness = def->thickness;
    truth->modulus = skin->young;
    truth->poisson = rubber_parameter(skin, "poisson", 0.5);
    truth->mooney = rubber_parameter(skin, "mooney", 0);
    return truth->law != NULL;
}

/// Quads only: triangles have no shear springs and so another stiffness.
static bool springs(const Balloon* balloon, TruthBalloon* truth) {
    const SpringsDef* def = balloon->def->skin.springs;
    if (!def)
        return false;
    for (int f = 0; f < balloon->mesh.face_count; f++)
        if (face_corners(balloon->mesh.face[f]) == 3)
            return false;
    truth->law = truth_law_find(spring_law_name[def->law]);
    truth->thickness = 1;
    truth->modulus = 1;
    truth->springs = truth_sheet(def->structural, def->shear, def->flexion).biaxial;
    return truth->law != NULL;
}

bool spherical_find(const Balloon* balloon, Spherical* spherical) {
    const double radius = balloon->mesh.closed ? radius_of(&balloon->mesh) : 0;
    const double scale = balloon->body.scale;
    if (radius == 0)
        return false;
    const double sphere = 4 * PI / 3 * radius * radius * radius;
    const double volume = volume_of(&balloon->mesh);
    if (volume < min_fill * sphere)
        return false;
    spherical->truth = truth_balloon_default();
    spherical->truth.radius = scale * radius;
    spherical->volume = scale * scale * scale * volume;
    return rubber(balloon, &spherical->truth) || springs(balloon, &spherical->truth);
}
