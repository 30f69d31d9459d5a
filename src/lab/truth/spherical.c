#include "lab/truth/spherical.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "force/material.h"
#include "mesh/measure.h"

/// Minimum volume of a mesh over that of the sphere through its points: excludes a cube. [1]
static const double full = 0.85;

/// Tolerance of the points' distances from the center. [R0]
static const double unround = 1e-3;

/// R0 of a sphere, 0 of another shape. [unit of the mesh]
static double radius_of(const Mesh* mesh) {
    double4 center = {0, 0, 0, 0};
    for (int i = 0; i < mesh->point_count; i++)
        center += mesh->point[i] / mesh->point_count;
    double least = INFINITY, most = 0;
    for (int i = 0; i < mesh->point_count; i++) {
        const double r = dlength(mesh->point[i] - center);
        least = fmin(least, r);
        most = fmax(most, r);
    }
    const double radius = (least + most) / 2;
    return most - least <= 2 * unround * radius ? radius : 0;
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

/// Only quads: triangles have no shear springs and form another sheet.
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

bool spherical_find(const Balloon* balloon, Spherical* round) {
    const double radius = balloon->mesh.closed ? radius_of(&balloon->mesh) : 0;
    const double scale = balloon->body.scale;
    if (radius == 0)
        return false;
    const double sphere = 4 * PI / 3 * radius * radius * radius;
    const double volume = volume_of(&balloon->mesh);
    if (volume < full * sphere)
        return false;
    round->truth = truth_balloon_default();
    round->truth.radius = scale * radius;
    round->volume = scale * scale * scale * volume;
    return rubber(balloon, &round->truth) || springs(balloon, &round->truth);
}
