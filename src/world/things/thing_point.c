#include "world/things/thing_point.h"

#include <stdlib.h>
#include <string.h>

#include "contact/skins/feature_pair.h"

static double4 lowest(const Thing* thing, double sign) {
    double4 best = to_double4(thing->start[0]);
    for (int i = 1; i < thing->body.count; i++) {
        const double4 x = to_double4(thing->start[i]);
        best = sign * x[1] < sign * best[1] ? x : best;
    }
    return best;
}

static double4 nearest_on_surface(const Thing* thing, double4 x) {
    double4 best = x;
    double distance_min = INFINITY;
    for (int t = 0; t < thing->mesh.triangle_count; t++) {
        double4 feature[FEATURE_NODES] = {x};
        double weight[FEATURE_NODES];
        for (int k = 0; k < 3; k++)
            feature[k + 1] = to_double4(thing->start[thing->mesh.triangle[t][k]]);
        const double distance = feature_distance(VERTEX_TRIANGLE, feature, weight);
        if (!(distance < distance_min))
            continue;
        distance_min = distance;
        best = (double4){0};
        for (int k = 1; k < FEATURE_NODES; k++)
            best -= weight[k] * feature[k];
    }
    return best;
}

static double4 middle(const Thing* thing) {
    double4 low = to_double4(thing->start[0]), high = low;
    for (int i = 1; i < thing->body.count; i++)
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], (double)thing->start[i][k]);
            high[k] = fmax(high[k], (double)thing->start[i][k]);
        }
    return 0.5 * (low + high);
}

void thing_point_at(const Thing* thing, const char* at, const double4* x, double point[3]) {
    double4 found;
    if (at && strcmp(at, "lowest") == 0)
        found = lowest(thing, 1);
    else if (at && strcmp(at, "highest") == 0)
        found = lowest(thing, -1);
    else if (at && strcmp(at, "nearest") != 0)
        found = to_double4(thing->start[thing->mesh.inside[strtol(at, NULL, 10)]]);
    else
        found = x ? nearest_on_surface(thing, *x) : middle(thing);
    for (int k = 0; k < 3; k++)
        point[k] = found[k];
}
