/// Features of skins that can meet: a vertex and a triangle, or an edge and an edge.
///
/// Two triangulated surfaces without crossings begin to cross only where a vertex comes to a triangle
/// or an edge to an edge. All is computed in double from the stored positions.
#ifndef BALLOON_CONTACT_SKINS_FEATURE_PAIR_H
#define BALLOON_CONTACT_SKINS_FEATURE_PAIR_H

#include <stdbool.h>
#include <stdint.h>

#include "base/vec.h"

/// Number of the nodes that belong to the first side.
typedef enum FeatureKind { VERTEX_TRIANGLE = 1, EDGE_EDGE = 2 } FeatureKind;

enum { FEATURE_NODES = 4 };

typedef struct FeaturePair {
    FeatureKind kind;
    int skin[2];             ///< of the first side's nodes, and of the others'
    int node[FEATURE_NODES]; ///< particles
    int64_t feature;         ///< number of both features, in rising order
    double rest_gap;         ///< distance at which the two touch [m]
    // where it was last measured
    int64_t measured; ///< number of drifts then
    double distance;  ///< [m]
    double
        clearance; ///< what it is at least, whatever was rounded; 0 or less: not known to be apart [m]
    double4 normal; ///< unit vector from the second side's nearest point to the first's
    double weight[FEATURE_NODES]; ///< nearest points: sum_k weight_k x_k is normal times distance
} FeaturePair;

/// The skin of node k.
static inline int feature_pair_skin(const FeaturePair* pair, int k) {
    return pair->skin[k >= (int)pair->kind];
}

/// Distance of the two features, and the weights of their nearest points: those of the first side sum
/// to 1, those of the second to -1. x: positions of the nodes.
double feature_distance(FeatureKind kind, const double4 x[FEATURE_NODES],
                        double weight[FEATURE_NODES]);

/// Least distance along the normal between the corners of the two sides: a plane across the normal
/// separates them where it is greater than 0.
double feature_separation(FeatureKind kind, const double4 x[FEATURE_NODES], double4 normal);

/// Least distance that the two surely have: the separation along the normal between their nearest
/// points, less what rounding may have added. The nearest points themselves need not be exact.
double feature_clearance(FeatureKind kind, const double4 x[FEATURE_NODES], double4 normal);

/// A part t of straight paths x + t dx, 0 <= t <= 1, in which the two come no nearer than `share` of
/// their clearance at the start: 1 if that is so on the whole path, 0 if they have none. Conservative
/// advancement: no point of a feature moves farther than its fastest corner.
/// Source: M. Li, D. M. Kaufman, C. Jiang, Codimensional Incremental Potential Contact, ACM Trans.
/// Graph. 40, 2021, section 5 (additive CCD).
double feature_safe_part(FeatureKind kind, const double4 x[FEATURE_NODES],
                         const double4 dx[FEATURE_NODES], double share);

/// Whether segment (a, b) pierces triangle c, by the signs of volumes; no when one is within rounding
/// of 0.
bool feature_pierces(double4 a, double4 b, const double4 c[3]);

#endif
