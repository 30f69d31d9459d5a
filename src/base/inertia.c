#include "base/inertia.h"

/// [cubes of the trace] least determinant of points that are not on one line
static const double determinant_min = 1e-12;

void inertia_add(Inertia* inertia, double mass, double4 r) {
    for (int k = 0; k < 3; k++) {
        inertia->column[k] -= mass * r[k] * r;
        inertia->column[k][k] += mass * ddot(r, r);
    }
}

bool inertia_invert(const Inertia* inertia, Inertia* inverse) {
    const double4* c = inertia->column;
    const double4 across = dcross(c[1], c[2]);
    const double determinant = ddot(c[0], across), trace = c[0][0] + c[1][1] + c[2][2];
    if (!(determinant > determinant_min * trace * trace * trace))
        return false;
    *inverse = (Inertia){{across / determinant, dcross(c[2], c[0]) / determinant,
                          dcross(c[0], c[1]) / determinant}}; // symmetric: rows are columns
    return true;
}
