#include "mesh/measure.h"

#include <string.h>

#include "mesh/facet.h"

static Facet facet_now(const real4* x, const int face[4]) {
    Facet facet = {.corners = face_corners(face)};
    for (int k = 0; k < facet.corners; k++)
        facet.corner[k] = to_double4(x[face[k]]);
    return facet;
}

double measure_area(const Mesh* mesh, const real4* x) {
    double area = 0;
    for (int f = 0; f < mesh->face_count; f++) {
        const Facet facet = facet_now(x, mesh->face[f]);
        area += dlength(facet_area(&facet));
    }
    return area;
}

double measure_volume(const Mesh* mesh, const real4* x) {
    if (!mesh->closed)
        return 0;
    const double4 origin = to_double4(x[0]);
    double volume = 0;
    for (int f = 0; f < mesh->face_count; f++) {
        const Facet facet = facet_now(x, mesh->face[f]);
        volume += facet_volume(&facet, origin);
    }
    return volume;
}

/// The cross product by lane shuffles: the same products and differences as cross(), so the same
/// bits, in two thirds of the time where a vector fits one register. Four doubles do not, and gcc
/// would shuffle them through memory. The spare lane stays zero if both spare lanes are.
static inline real4 cross_lanes(real4 a, real4 b) {
#ifdef BALLOON_DOUBLE
    return cross(a, b);
#else
    const real4 a_yzx = __builtin_shufflevector(a, a, 1, 2, 0, 3);
    const real4 b_yzx = __builtin_shufflevector(b, b, 1, 2, 0, 3);
    const real4 zxy = a * b_yzx - a_yzx * b;
    return __builtin_shufflevector(zxy, zxy, 1, 2, 0, 3);
#endif
}

/// gradient += dV/dx, face by face, so that the sums have one order on every machine.
/// Returns twice the area.
static double add_gradient(const int (*restrict face)[4], int face_count, bool closed,
                           const real4* restrict x, real4* restrict gradient) {
    const real sixth = (real)1 / 6;
    const real twelfth = (real)1 / 12;
    double area = 0;
    for (int f = 0; f < face_count; f++) {
        const int* k = face[f];
        const real4 a = x[k[0]];
        const real4 b = x[k[1]];
        const real4 c = x[k[2]];
        if (k[3] == NONE) {
            const real4 n = cross_lanes(b - a, c - a);
            const real4 part = n * sixth;
            gradient[k[0]] += part;
            gradient[k[1]] += part;
            gradient[k[2]] += part;
            area += dlength(to_double4(n));
            continue;
        }
        // N_a and N_b are cross products; N_c = D - N_a and N_d = D - N_b
        const real4 d = x[k[3]];
        const real4 two_areas = cross_lanes(c - a, d - b);
        const real4 at_a = closed ? cross_lanes(b - a, d - a) : two_areas * (real)0.5;
        const real4 at_b = closed ? cross_lanes(c - b, a - b) : two_areas * (real)0.5;
        gradient[k[0]] += (two_areas + at_a) * twelfth;
        gradient[k[1]] += (two_areas + at_b) * twelfth;
        gradient[k[2]] += (two_areas + (two_areas - at_a)) * twelfth;
        gradient[k[3]] += (two_areas + (two_areas - at_b)) * twelfth;
        area += dlength(to_double4(two_areas));
    }
    return area;
}

double measure_volume_gradient(const Mesh* mesh, const real4* x, real4* gradient) {
    memset(gradient, 0, (size_t)mesh->point_count * sizeof *gradient);
    return 0.5 *
           add_gradient((const int(*)[4])mesh->face, mesh->face_count, mesh->closed, x, gradient);
}

double4 measure_volume_gradient_at(const Mesh* mesh, const real4* x, int point) {
    double4 sum = {0, 0, 0, 0};
    for (int k = mesh->point_face_from[point]; k < mesh->point_face_from[point + 1]; k++) {
        const int* face = mesh->face[mesh->point_face[k]];
        const Facet facet = facet_now(x, face);
        const double4* corner = facet.corner;
        const double4 area = facet_area(&facet);
        if (facet.corners == 3) {
            sum += area / 3;
            continue;
        }
        int c = 0;
        while (face[c] != point)
            c++;
        const double4 own =
            mesh->closed ? dcross(corner[(c + 1) % 4] - corner[c], corner[(c + 3) % 4] - corner[c])
                         : area;
        sum += (2 * area + own) / 12;
    }
    return sum;
}

/// The change of the cross product of two edges as their ends move.
static inline real4 cross_change(real4 a, real4 da, real4 b, real4 db) {
    return cross_lanes(da, b) + cross_lanes(a, db);
}

void measure_volume_product(const Mesh* mesh, const real4* x, const real4* d, real factor,
                            real4* out) {
    const real sixth = factor / 6, twelfth = factor / 12;
    for (int f = 0; f < mesh->face_count; f++) {
        const int* k = mesh->face[f];
        const real4 a = x[k[0]], da = d[k[0]], ab = x[k[1]] - a, dab = d[k[1]] - da,
                    ac = x[k[2]] - a, dac = d[k[2]] - da;
        if (k[3] == NONE) {
            const real4 part = sixth * cross_change(ab, dab, ac, dac);
            for (int c = 0; c < 3; c++)
                out[k[c]] += part;
            continue;
        }
        const real4 ad = x[k[3]] - a, dad = d[k[3]] - da;
        const real4 both = cross_change(ac, dac, ad - ab, dad - dab);
        const real4 at_a = mesh->closed ? cross_change(ab, dab, ad, dad) : both * (real)0.5;
        const real4 at_b =
            mesh->closed ? cross_change(ac - ab, dac - dab, -ab, -dab) : both * (real)0.5;
        out[k[0]] += twelfth * (both + at_a);
        out[k[1]] += twelfth * (both + at_b);
        out[k[2]] += twelfth * (both + (both - at_a));
        out[k[3]] += twelfth * (both + (both - at_b));
    }
}
