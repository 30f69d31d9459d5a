/// Methods of time stepping: a table, one file and one row each.
///
/// A step is a kick and a drift. The kick gives the velocities with which the particles are to
/// drift: under the forces that the scene lists, those at the end of the step (of `forward` those
/// at its start). Corrections and contacts then have their say on them; the drift moves the
/// particles, x' = x + h v'. `forward`, `euler` and `newton` know forces only through the force
/// table, so a new force serves them all; methods of constraints (solve/predict.h) know springs,
/// strings and gas themselves, and refuse skins that are something else.
#ifndef BALLOON_SOLVE_METHOD_H
#define BALLOON_SOLVE_METHOD_H

#include "body/body.h"

/// From where an implicit step begins.
typedef enum StepStart {
    START_INERTIA, ///< x + h v, where the body would go by itself
    START_REST,    ///< x, the thin-shell paper's eq. 20: what it has of v is lost
    STEP_STARTS
} StepStart;
extern const char* const step_start_name[STEP_STARTS];

/// What a scene may say of how a step is solved; 0: the method's own.
typedef struct Solver {
    int iterations;          ///< most of a step; exactly as many with a tolerance below 0, and of a
                             ///< method that does not look at what is left (xpbd)
    double tolerance;        ///< left of the step's equation, relative [1]; below 0: do not look
    double linear_tolerance; ///< left of each linear equation, relative [1]
    StepStart start;
    bool in_place; ///< euler: each particle moves before the next one's force is computed
} Solver;

/// What the last kick took.
typedef struct Effort {
    int iterations;
    int products;    ///< of the tangent with a vector
    double residual; ///< left of the step's equation, relative [1]
    int factored;    ///< matrices: the only thing for which a kick may allocate
} Effort;

typedef struct Method {
    const char* name;
    const char* about;
    bool implicit; ///< stable at every step
    bool iterates; ///< it has iterations, products and a residual to report
    bool can_fail; ///< its kick may return false

    /// Why this method cannot step this body, or NULL if it can.
    const char* (*refuses)(const Body* body);

    /// Room for a body's steps, NULL members: none is needed. A kick allocates nothing, but where
    /// it says that it has factored a matrix.
    void* (*open)(Body* body, const Solver* solver);
    void (*close)(void* room);

    /// Velocities of the coming drift. False, and nothing changed, where the step was not solved;
    /// only where the method can fail.
    bool (*kick)(Body* body, void* room, double h, Effort* effort);

    /// Positions after h, and what then is left to do to the velocities. Most take body_drift.
    void (*drift)(Body* body, double h);

    /// Largest stable step [s] for the largest squared frequency w2 [1/s^2] and the damping rate
    /// gamma = c/m [1/s]; INFINITY where there is none, 0 where no step is stable. Only of explicit
    /// methods; method_limit asks any.
    double (*limit)(double w2, double gamma);
} Method;

extern const Method method_euler, method_forward, method_newton, method_projective, method_xpbd;

extern const Method* const method_table[];
extern const int method_count;

/// Row by name, or NULL.
const Method* method_find(const char* name);

/// Names of all methods, "euler, …", for sentences.
const char* method_names(void);

/// The row's limit; INFINITY for an implicit method.
double method_limit(const Method* method, double w2, double gamma);

/// The bound that this program computes for a body: the method's limit for the sum of all forces'
/// bounds on the squared frequency (never less than the true one) and the damping, the least and
/// the largest over the particles: every mode's lies between them.
double method_bound(const Method* method, const Body* body);

#endif
