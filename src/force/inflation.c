#include "force/inflation.h"

#include "force/force.h"
#include "mesh/measure.h"

/// The paper's factor from k_normal to force [1].
static const double area_factor = 100;

static double pressure_of(const Inflation* inflation, double area, double volume) {
    switch (inflation->law) {
        case INFLATE_AREA:
            return area_factor * inflation->amount / area;
        case INFLATE_PRESSURE:
            return inflation->amount;
        case INFLATE_GAS:
            return gas_pressure(inflation, volume);
        default:
            return 0;
    }
}

static double volume_if_gas(const Body* body) {
    return body->inflation.law == INFLATE_GAS ? measure_volume(body->mesh, body->x) : 0;
}

double inflation_pressure(const Body* body) {
    return pressure_of(&body->inflation, measure_area(body->mesh, body->x), volume_if_gas(body));
}

static bool present(const Body* body) {
    return body->inflation.law != INFLATE_NONE &&
           (body->inflation.amount != 0 || body->inflation.law == INFLATE_GAS);
}

static void add(Body* body) {
    real4* restrict gradient = body->inflation.gradient;
    const double area = measure_volume_gradient(body->mesh, body->x, gradient);
    body->inflation.volume = volume_if_gas(body);
    const real p = (real)pressure_of(&body->inflation, area, body->inflation.volume);

    real4* restrict f = body->f;
    for (int i = 0; i < body->count; i++)
        f[i] += p * gradient[i];
}

static double energy(const Body* body) {
    const Inflation* inflation = &body->inflation;
    const double volume = measure_volume(body->mesh, body->x);
    if (inflation->law == INFLATE_GAS)
        return gas_energy(inflation, volume);
    return -inflation_pressure(body) * volume;
}

/// Row sums of the second derivative of V, and of dA/dx and dV/dx, at one corner of a face: each
/// entry is at most a length of an edge or diagonal, for the gradients are cross products of those.
typedef struct Rows {
    double second; ///< sum over the corners of |d2V / dx_corner dx_k| [m]
    double area;   ///< |dA / dx_corner| [m]
} Rows;

static Rows rows_at(const Body* body, const int face[4], int corner) {
    const int corners = face_corners(face);
    const real4 a = body->x[face[corner]];
    const real4 b = body->x[face[(corner + 1) % corners]];
    const real4 d = body->x[face[(corner + corners - 1) % corners]];
    const double ab = (double)length(b - a), ad = (double)length(d - a), bd = (double)length(d - b);
    if (corners == 3) // dV/da = N/6, N = (b - a) x (d - a); |A| = |N|/2
        return (Rows){.second = (ab + ad + bd) / 6, .area = bd / 2};

    const real4 c = body->x[face[(corner + 2) % 4]]; // dV/da = (D + N)/12; |A| = |D|/2
    const double ac = (double)length(c - a);
    return (Rows){.second = (2 * (ac + bd) + ab + ad + bd) / 12, .area = bd / 2};
}

/// d(p dV/dx)/dx = p d2V/dx2 + dV/dx (dp/dx)^T: a bound on each part, over the masses.
static double bound(const Body* body) {
    const Inflation* inflation = &body->inflation;
    const Mesh* mesh = body->mesh;
    const double area = measure_volume_gradient(mesh, body->x, inflation->gradient);
    const double volume = volume_if_gas(body);
    const double p = pressure_of(inflation, area, volume);

    double second = 0, area2 = 0, volume2 = 0;
    for (int i = 0; i < body->count; i++) {
        Rows rows = {0};
        for (int k = mesh->point_face_from[i]; k < mesh->point_face_from[i + 1]; k++) {
            const int* face = mesh->face[mesh->point_face[k]];
            int corner = 0;
            while (face[corner] != i)
                corner++;
            const Rows at = rows_at(body, face, corner);
            rows.second += at.second;
            rows.area += at.area;
        }
        const double w = (double)body->inverse_mass[i];
        const double4 g = to_double4(inflation->gradient[i]);
        second = fmax(second, rows.second * w);
        area2 += rows.area * rows.area * w;
        volume2 += ddot(g, g) * w;
    }

    const double stiff = fabs(p) * second;
    if (inflation->law == INFLATE_AREA)
        return stiff + fabs(p) / area * sqrt(area2 * volume2);
    if (inflation->law == INFLATE_GAS)
        return stiff - gas_slope(inflation, volume) * volume2;
    return stiff;
}

/// The share of the thin-shell paper's eq. 16, whose 1/27 should be 1/9. [1]
static const double paper_share = 1.0 / 3;

/// K d = -p (d2V/dx2) d - dp/dV dV/dx (dV/dx . d), dense but of rank one: two sums. `area` at its
/// frozen pressure, as its energy.
static void product(const Body* body, const real4* d, real4* out) {
    const Inflation* inflation = &body->inflation;
    measure_volume_product(body->mesh, body->x, d, (real)-inflation->pressure, out);
    if (inflation->law != INFLATE_GAS)
        return;
    double along = 0;
    for (int i = 0; i < body->count; i++)
        along += (double)dot(inflation->gradient[i], d[i]);
    const real factor = (real)(-inflation->slope * along);
    for (int i = 0; i < body->count; i++)
        out[i] += factor * inflation->gradient[i];
}

static void stiffen(Body* body, bool project) {
    (void)project; // the second derivative of the volume has both signs; solvers watch for it
    Inflation* inflation = &body->inflation;
    const double area = measure_volume_gradient(body->mesh, body->x, inflation->gradient);
    const double volume = volume_if_gas(body);
    inflation->pressure = pressure_of(inflation, area, volume);
    inflation->slope = inflation->law == INFLATE_GAS ? gas_slope(inflation, volume) : 0;
    if (inflation->paper_tangent)
        inflation->slope *= paper_share;
}

/// Of the rank-one part, which alone is positive.
static void diagonal(const Body* body, Block* block) {
    const Inflation* inflation = &body->inflation;
    for (int i = 0; i < body->count; i++)
        for (int c = 0; c < 3; c++)
            block[i].column[c] +=
                ((real)-inflation->slope * inflation->gradient[i][c]) * inflation->gradient[i];
}

const Force force_inflation = {
    .name = "inflation",
    .about = "pressure p dV/dx, laws area, pressure and gas",
    .present = present,
    .add = add,
    .energy = energy,
    .bound = bound,
    .stiffen = stiffen,
    .product = product,
    .diagonal = diagonal,
    .internal = true,
};
