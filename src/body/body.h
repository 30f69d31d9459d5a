/// One balloon's state: particles on a mesh, and what its scene lists to act on them.
///
/// Features that a scene does not name take no memory: counts are 0 and arrays NULL. Positions and
/// velocities are the state; everything else follows from the scene. `body` holds the data,
/// `force/` acts.
#ifndef BALLOON_BODY_BODY_H
#define BALLOON_BODY_BODY_H

#include "body/gas.h"
#include "body/membrane.h"
#include "body/slices.h"
#include "body/springs.h"
#include "body/torsion.h"
#include "mesh/mesh.h"

/// From a particle to a fixed point. No force up to its free length, then stiffness times what
/// exceeds it.
typedef struct String {
    int particle;
    real4 anchor;       ///< [m]
    real stiffness;     ///< [N/m]
    real free_length;   ///< [m]
    real first_stretch; ///< when it was first tied [m]; tied again, it is stretched no more
    real4 impulse;      ///< h^2 times its pull in the last step, of a method that finds it [kg m]
} String;

/// Free length of a string that is tied again: at least distance - first stretch. With its old length,
/// a string of 50 N/m to a balloon that flew 80 m away would pull one particle of a gram with 4 kN.
static inline real string_tied_length(real free_length, real first_stretch, real distance) {
    return real_max(free_length, distance - first_stretch);
}

/// Capacity for the parameters of forces.
enum { FORCES_MAX = 16, FORCE_PARAMETERS_MAX = 4 };

typedef struct Body {
    const Mesh* mesh;
    int count;          ///< particles, one for each of the mesh's points, in its order
    real4* x;           ///< [count] position [m]
    real4* v;           ///< [count] velocity [m/s]
    real4* f;           ///< [count] force of the last evaluation [N]
    real* mass;         ///< [count] [kg]
    real* inverse_mass; ///< [count] [1/kg], 0 holds a particle where it is
    double size;        ///< longest side of the first bounding box [m]
    double scale;       ///< first lengths over the mesh's [1]
    bool asleep;        ///< it does not move, and no force on it is computed (world/rest.h)
    int still;          ///< rest checks since it last moved or was touched

    double gravity; ///< [m/s^2] downward, 0: none
    Springs springs;
    Slices slices; ///< neighborhoods, of a skin of springs or one that is blown up
    Torsion torsion;
    Membrane membrane;
    Inflation inflation;
    double force_parameter[FORCES_MAX][FORCE_PARAMETERS_MAX]; ///< by row of the table of forces and
        ///< in the row's order (force/force.h)
    String* string; ///< [string_capacity] the first string_count are in use
    int string_count;
    int string_capacity;
    double joined_w2; ///< bound on the squared frequency that joints add [1/s^2]; 0: none
                      ///< (solve/joints/joints.h)
} Body;

/// Transform of a mesh's points: x = position + rotation(scale (point - center)).
typedef struct Placement {
    double4 center;
    double scale;
    double rotation; ///< [degrees] about y
    double4 position;
} Placement;

/// Particles of equal mass [kg] at the placed points of the mesh, at rest, with no forces.
void body_make(Body* body, const Mesh* mesh, const Placement* placement, double mass);

/// Give the body springs, with rest lengths from the present positions.
/// stiffness: of each kind [N/m], 0 for kinds that do not exist.
void body_add_springs(Body* body, const double stiffness[SPRING_KINDS], SpringLaw law);

/// Set the present stiffness of a spring [N/m].
static inline void body_set_stiffness(Body* body, int spring, real stiffness) {
    body->springs.active[spring] = stiffness;
    slices_set_stiffness(&body->slices, spring, stiffness);
}

/// Make the slices again, after springs were changed.
void body_slice(Body* body);

void body_add_torsion(Body* body, double stiffness);

/// Hold the particles on the rim of an open mesh fixed. Call before body_add_springs.
void body_hold_rim(Body* body);

/// Hold the particles up to `radius` from a point. Returns how many there are.
int body_hold(Body* body, const double center[3], double radius);

/// Whether a particle is that near to the point.
static inline bool body_is_near(const Body* body, int particle, const double center[3],
                                double radius) {
    const double4 c = {center[0], center[1], center[2], 0};
    return dlength(to_double4(body->x[particle]) - c) <= radius;
}

/// Give the body a skin of rubber, at rest at the present positions, and that rubber's mass.
/// thickness: [count] at the particles [m]
void body_add_membrane(Body* body, const double* thickness, const Rubber* rubber);

/// Begin to inflate: law, amount and gas from `inflation`; the first volume is the present one.
void body_inflate(Body* body, const Inflation* inflation);

/// Tie a string of `slack` times the present distance from a particle to a fixed point.
void body_tie(Body* body, int particle, const double anchor[3], double stiffness, double slack);

/// v' = v + h f / m.
void body_push(Body* body, double h);

/// x' = x + h v'.
void body_drift(Body* body, double h);

static inline void body_wake(Body* body) {
    body->asleep = false;
    body->still = 0;
}

void body_free(Body* body);

#endif
