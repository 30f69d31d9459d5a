/// Torsion springs: they hold the angle of a two-edge path whose ends share no face.
///
///     p --- m --- q      bend b = |u + w|, u and w the unit vectors from m to p and to q;
///                        b = 2 sin(phi/2), phi the angle by which the path is not straight
///
/// The half-angle form needs a square root only, and is smooth where the path is straight, which is
/// where an energy in cos(phi) has no stiffness. Source of the idea: the mass-spring balloon paper,
/// "Discussion"; equations in force/torsion.c.
#ifndef BALLOON_BODY_TORSION_H
#define BALLOON_BODY_TORSION_H

#include "mesh/mesh.h"

typedef struct Torsion {
    int count;
    int (*path)[3]; ///< [count] p, m, q
    real* rest;     ///< [count] b at rest [1]
    real stiffness; ///< [N m] energy per squared bend, twice
    bool project;   ///< the last update of the tangent left out its indefinite part
    double bound;   ///< bound on the squared frequency at rest [1/s^2]
} Torsion;

/// All paths of the mesh; `path` is allocated.
void torsion_find(const Mesh* mesh, Torsion* torsion);

void torsion_free(Torsion* torsion);

#endif
