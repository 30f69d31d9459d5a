#include "view/thrower.h"

// From a tenth of a kilogram upward as in the mass-spring paper; radii are doubled.
static const double MASSES[] = {0.1, 1, 10, 100, 1000};
static const double RADII[] = {0.05, 0.1, 0.2, 0.4, 0.8};
static const double SPEEDS[] = {1, 5, 10, 20, 50, 100, 200};
enum {
    MASS_COUNT = sizeof MASSES / sizeof *MASSES,
    RADIUS_COUNT = sizeof RADII / sizeof *RADII,
    SPEED_COUNT = sizeof SPEEDS / sizeof *SPEEDS,
};

// Radius of the first ball: small enough to dent a balloon, large enough to be visible.
// [of a balloon's size]
static const double RADIUS_SHARE = 1.0 / 8;
// Maximum fall of the first ball between the eye and the camera's target. [of a balloon's size]
static const double FALL_SHARE = 1.0 / 4;
// Maximum time of the first ball to the camera's target. [s]
static const double MAX_FLIGHT = 0.5;
// Distance of a new ball from the eye: its diameter is then a third of the height of a picture with
// a field of view of 0.6 rad. [radii]
static const double START_DISTANCE = 10;
// Upper limit of that distance. [of the distance to the camera's target]
static const double MAX_BEFORE_EYE = 0.4;

// ---- the ball ----

/// The number of a rising list whose ratio to `target` is nearest to 1.
static double nearest(const double* list, int count, double target) {
    double best = list[0];
    for (int k = 1; k < count; k++)
        if (target * target > best * list[k]) // above the geometric mean of the two
            best = list[k];
    return best;
}

static double next_of(const double* list, int count, double value) {
    for (int k = 0; k < count; k++)
        if (list[k] > value)
            return list[k];
    return list[0];
}

void thrower_next_mass(Thrower* thrower) {
    thrower->mass = next_of(MASSES, MASS_COUNT, thrower->mass);
}

void thrower_next_radius(Thrower* thrower) {
    thrower->radius = next_of(RADII, RADIUS_COUNT, thrower->radius);
}

void thrower_next_speed(Thrower* thrower) {
    thrower->speed = next_of(SPEEDS, SPEED_COUNT, thrower->speed);
}

Thrower thrower_default(const World* world, const Camera* camera) {
    double mass = 0, size = 0;
    for (int b = 0; b < world->balloon_count; b++) {
        const Body* body = &world->balloon[b].body;
        size += body->size / world->balloon_count;
        for (int i = 0; i < body->count; i++)
            mass += (double)body->mass[i] / world->balloon_count;
    }

    // the speed at which the fall g/2 (distance/speed)^2 is FALL_SHARE size
    const double distance = (double)camera->distance;
    const double flat = distance * sqrt(world->contacts.gravity / (2 * FALL_SHARE * size));
    return (Thrower){
        .mass = nearest(MASSES, MASS_COUNT, mass),
        .radius = nearest(RADII, RADIUS_COUNT, RADIUS_SHARE * size),
        .speed = nearest(SPEEDS, SPEED_COUNT, fmax(flat, distance / MAX_FLIGHT)),
    };
}

// ---- the throw ----

/// A line of sight, and the interval of it where a ball's center may be.
typedef struct Sight {
    double4 eye;
    double4 along; ///< unit vector
    double from;   ///< begin of the interval, as distance from the eye [m]
    double to;     ///< its end [m]
} Sight;

static Sight sight_through(const Camera* camera, float aspect, const float pointer[2]) {
    float eye[3], ray[3];
    camera_eye(camera, eye);
    camera_ray(camera, aspect, pointer[0], pointer[1], ray);
    const double4 along = {ray[0], ray[1], ray[2], 0};
    return (Sight){
        .eye = {eye[0], eye[1], eye[2], 0},
        .along = along / dlength(along),
        .to = (double)camera->distance,
    };
}

/// Clip the interval to points at least a radius in front of a plane.
static void clip_to_plane(Sight* sight, const Plane* plane, double radius) {
    const double gap = ddot(plane->normal, sight->eye - plane->point) - radius;
    const double rise = ddot(plane->normal, sight->along);
    if (rise > 0)
        sight->from = fmax(sight->from, -gap / rise);
    else if (rise < 0)
        sight->to = fmin(sight->to, -gap / rise);
    else if (gap < 0)
        sight->to = -1;
}

/// Distance at which the line enters a balloon's bounding box, widened by a radius; INFINITY if it
/// misses the box or the eye is inside.
static double box_entry(const Sight* sight, const Body* body, double radius) {
    double4 low = to_double4(body->x[0]), high = low;
    for (int i = 0; i < body->count; i++) {
        const double4 x = to_double4(body->x[i]);
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], x[k]);
            high[k] = fmax(high[k], x[k]);
        }
    }

    double enter = -INFINITY, leave = INFINITY;
    for (int k = 0; k < 3; k++) {
        // a line parallel to two sides meets them at +-INFINITY
        const double a = (low[k] - radius - sight->eye[k]) / sight->along[k];
        const double b = (high[k] + radius - sight->eye[k]) / sight->along[k];
        enter = fmax(enter, fmin(a, b));
        leave = fmin(leave, fmax(a, b));
    }
    return enter >= 0 && enter < leave ? enter : INFINITY;
}

static bool is_clear(const World* world, double4 center, double radius) {
    for (int s = 0; s < world->contacts.sphere_count; s++) {
        const Sphere* other = &world->contacts.sphere[s];
        if (dlength(to_double4(other->x) - center) < radius + (double)other->radius)
            return false;
    }
    return true;
}

bool thrower_throw(const Thrower* thrower, const World* world, const Camera* camera, float aspect,
                   const float pointer[2], double thrown[THROW_NUMBERS]) {
    Sight sight = sight_through(camera, aspect, pointer);
    for (int k = 0; k < world->contacts.plane_count; k++)
        clip_to_plane(&sight, &world->contacts.plane[k], thrower->radius);
    if (sight.from > sight.to)
        return false;

    // near the eye, and in front of the balloons
    double start =
        fmin(START_DISTANCE * thrower->radius, MAX_BEFORE_EYE * (double)camera->distance);
    for (int b = 0; b < world->balloon_count; b++)
        start = fmin(start, box_entry(&sight, &world->balloon[b].body, thrower->radius));
    start = fmin(fmax(start, sight.from), sight.to);

    const double4 center = sight.eye + start * sight.along;
    for (int k = 0; k < 3; k++) {
        thrown[k] = center[k];
        thrown[3 + k] = thrower->speed * sight.along[k];
    }
    thrown[6] = thrower->mass;
    thrown[7] = thrower->radius;
    return is_clear(world, center, thrower->radius);
}
