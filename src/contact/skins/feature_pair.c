#include "contact/skins/feature_pair.h"

enum { MAX_ADVANCES = 64 }; ///< after them, the part so far is safe
static const double rounding =
    1e-14; ///< [1] of the terms of a volume, many times what double loses

/// [1] of the pair's extent, twice what double loses of a separation
static const double separation_rounding = 4e-15;

/// [1] of the product of their squared lengths: of the area between two edges that are far from
/// parallel, squared
static const double far_from_parallel = 1e-6;

static double clamp(double a) {
    return a > 0 ? (a < 1 ? a : 1) : 0;
}

/// Parameter of the point of segment (a, b) nearest p.
static double nearest_on_segment(double4 p, double4 a, double4 b) {
    const double4 ab = b - a;
    const double length2 = ddot(ab, ab);
    return length2 > 0 ? clamp(ddot(p - a, ab) / length2) : 0;
}

/// Keep the nearer of what is there and a candidate with weights w.
static void keep_nearer(const double4 x[4], const double w[4], double* distance2,
                        double weight[4]) {
    double4 away = {0};
    for (int k = 0; k < FEATURE_NODES; k++)
        away += w[k] * x[k];
    const double candidate = ddot(away, away);
    if (candidate < *distance2) {
        *distance2 = candidate;
        for (int k = 0; k < FEATURE_NODES; k++)
            weight[k] = w[k];
    }
}

/// The nearest point is inside the triangle, or on one of its edges.
static double vertex_triangle(const double4 x[4], double weight[4]) {
    double distance2 = INFINITY;
    const double4 p = x[0], ab = x[2] - x[1], ac = x[3] - x[1], ap = p - x[1];
    const double4 n = dcross(ab, ac);
    const double area2 = ddot(n, n);
    const double v = ddot(n, dcross(ap, ac)), w = ddot(n, dcross(ab, ap));
    if (area2 > 0 && v >= 0 && w >= 0 && v + w <= area2) {
        keep_nearer(x, (const double[4]){1, -(1 - v / area2 - w / area2), -v / area2, -w / area2},
                    &distance2, weight);
        return sqrt(distance2);
    }
    for (int k = 0; k < 3; k++) {
        const int from = 1 + k, to = 1 + (k + 1) % 3;
        const double t = nearest_on_segment(p, x[from], x[to]);
        double candidate[4] = {1, 0, 0, 0};
        candidate[from] = -(1 - t);
        candidate[to] = -t;
        keep_nearer(x, candidate, &distance2, weight);
    }
    return sqrt(distance2);
}

/// The candidate with end k of the first edge, or of the second one.
static void keep_end(const double4 x[4], bool first, int k, double* distance2, double weight[4]) {
    if (first) {
        const double t = nearest_on_segment(x[k], x[2], x[3]);
        keep_nearer(x, (const double[4]){1 - k, k, -(1 - t), -t}, distance2, weight);
    } else {
        const double s = nearest_on_segment(x[2 + k], x[0], x[1]);
        keep_nearer(x, (const double[4]){1 - s, s, k - 1, -k}, distance2, weight);
    }
}

/// The nearest points are inside both edges, or one is an end. The squared distance is convex in the
/// parameters: where the minimum for s clamped has t within the edge, that is it, else it is at the end
/// of the second edge. Edges that are nearly parallel try all ends, and lose nothing.
static double edge_edge(const double4 x[4], double weight[4]) {
    double distance2 = INFINITY;
    const double4 d1 = x[1] - x[0], d2 = x[3] - x[2], r = x[0] - x[2];
    const double a = ddot(d1, d1), e = ddot(d2, d2), b = ddot(d1, d2), c = ddot(d1, r),
                 f = ddot(d2, r), denominator = a * e - b * b;
    const double s = (b * f - c * e) / denominator, t = (a * f - b * c) / denominator;
    if (denominator > 0 && s > 0 && s < 1 && t > 0 && t < 1)
        keep_nearer(x, (const double[4]){1 - s, s, -(1 - t), -t}, &distance2, weight);
    if (!(denominator > far_from_parallel * (a * e))) {
        for (int k = 0; k < 2; k++) {
            keep_end(x, true, k, &distance2, weight);
            keep_end(x, false, k, &distance2, weight);
        }
    } else if (!(distance2 < INFINITY)) {
        const double along = b * clamp(s) + f; // e t
        if (!(s > 0 && s < 1) && along > 0 && along < e)
            keep_end(x, true, s > 0, &distance2, weight);
        else
            keep_end(x, false, along > 0, &distance2, weight);
    }
    return sqrt(distance2);
}

double feature_distance(FeatureKind kind, const double4 x[4], double weight[4]) {
    return kind == VERTEX_TRIANGLE ? vertex_triangle(x, weight) : edge_edge(x, weight);
}

double feature_separation(FeatureKind kind, const double4 x[4], double4 normal) {
    double first = INFINITY, second = -INFINITY;
    for (int k = 0; k < FEATURE_NODES; k++) {
        const double along = ddot(normal, x[k] - x[0]);
        if (k < (int)kind)
            first = fmin(first, along);
        else
            second = fmax(second, along);
    }
    return first - second;
}

double feature_clearance(FeatureKind kind, const double4 x[4], double4 normal) {
    double extent2 = 0;
    for (int k = 1; k < FEATURE_NODES; k++)
        extent2 = fmax(extent2, ddot(x[k] - x[0], x[k] - x[0]));
    return feature_separation(kind, x, normal) - separation_rounding * sqrt(extent2);
}

/// The same, with the normal of the nearest points.
static double clearance(FeatureKind kind, const double4 x[4]) {
    double weight[4];
    const double distance = feature_distance(kind, x, weight);
    double4 away = {0};
    for (int k = 0; k < FEATURE_NODES; k++)
        away += weight[k] * x[k];
    return distance > 0 ? feature_clearance(kind, x, away / dlength(away)) : 0;
}

/// How much nearer the two may come on the paths.
static double longest_approach(FeatureKind kind, const double4 dx[4]) {
    double4 common = {0};
    for (int k = 0; k < FEATURE_NODES; k++)
        common += 0.25 * dx[k];
    double longest[2] = {0, 0};
    for (int k = 0; k < FEATURE_NODES; k++) {
        const int side = k >= (int)kind;
        longest[side] = fmax(longest[side], dlength(dx[k] - common));
    }
    return longest[0] + longest[1];
}

double feature_safe_part(FeatureKind kind, const double4 x[4], const double4 dx[4], double share) {
    double4 at[4];
    for (int k = 0; k < FEATURE_NODES; k++)
        at[k] = x[k] - x[0];
    double now = clearance(kind, at), part = 0;
    const double approach = longest_approach(kind, dx), least = share * now;
    if (!(approach > 0)) // the two keep their distance
        return 1;
    for (int n = 0; n < MAX_ADVANCES && now > 1.1 * least; n++) {
        part += (now - least) * 0.9 / approach;
        if (part >= 1)
            return 1;
        for (int k = 0; k < FEATURE_NODES; k++)
            at[k] = x[k] - x[0] + part * dx[k];
        now = clearance(kind, at);
    }
    return part;
}

/// Six times the volume of a tetrahedron; 0 where its sign is not sure.
static double sure_volume(double4 a, double4 b, double4 c, double4 d) {
    const double4 u = a - d, v = b - d, w = c - d, n = dcross(v, w);
    const double volume = ddot(u, n);
    return fabs(volume) > rounding * dlength(u) * dlength(v) * dlength(w) ? volume : 0;
}

bool feature_pierces(double4 a, double4 b, const double4 c[3]) {
    const double from = sure_volume(a, c[0], c[1], c[2]), to = sure_volume(b, c[0], c[1], c[2]);
    if (!(from * to < 0))
        return false;
    int positive = 0, negative = 0;
    for (int k = 0; k < 3; k++) {
        const double side = sure_volume(a, b, c[k], c[(k + 1) % 3]);
        positive += side > 0;
        negative += side < 0;
    }
    return positive == 3 || negative == 3;
}
