/// Methods of time stepping: a table with one file and one row for each.
///
/// A step is a kick and a drift, the two halves of a step of molecular dynamics:
///
///     kick    v' = v + h f/m, f by the method, then strain limits and contacts (or contacts in f)
///     drift   x' = x + h v'
///
/// `forward` and `euler` evaluate f at the start of the step, the others at its end. `forward`,
/// `euler` and `newton` know forces only through the force table, so a new force serves them all.
/// Methods of constraints (solve/predict.h) replace forces by constraints of their own.
#ifndef BALLOON_SOLVE_METHOD_H
#define BALLOON_SOLVE_METHOD_H

#include "force/force.h"
#include "solve/system.h"

/// First guess of an implicit step.
typedef enum StepStart {
    START_INERTIA, ///< x + h v, free motion
    START_REST,    ///< x, the thin-shell paper's eq. 20: the old velocity is lost
    STEP_STARTS
} StepStart;
extern const char* const step_start_name[STEP_STARTS];

/// What a scene may set of the solve; 0: the method's own default.
typedef struct Solver {
    int iterations;          ///< maximum of a step; exactly as many where the tolerance is below 0,
                             ///< and in xpbd, which computes no residual
    double tolerance;        ///< residual of the step's equation, relative [1]; below 0: no test
    double linear_tolerance; ///< residual of each linear equation, relative [1]
    double residual_max;     ///< xpbd, projective: a step of a larger residual (solve/residual.h)
                             ///< is not solved [1]; 0: no test
    StepStart start;
    bool in_place; ///< euler: each particle moves before the next one's force is computed
} Solver;

/// A force that a method supports.
typedef struct ForceUse {
    const Force* force;
    bool (*replaced)(
        const Body* body); ///< whether the method replaces it by its own form for this body;
                           ///< NULL: never, it is evaluated through its row
} ForceUse;

typedef struct Method {
    const char* name;
    const char* about;
    bool implicit;   ///< stable at every step
    bool iterates;   ///< it has iterations and a residual to report
    bool multiplies; ///< it has a number of Hessian-vector products to report
    bool can_fail;   ///< its kick may return false
    bool staggered;  ///< its velocities belong to half a step before its positions
    bool joins;      ///< it steps bodies that strings join (solve/joints/joints.h)

    /// The forces that it supports, up to a row of NULL; a body with another force is refused. NULL:
    /// all, through the force table.
    const ForceUse* takes;

    /// Another reason why this method cannot step this body, or NULL. method_refuses checks both.
    const char* (*refuses)(const Body* body);

    /// The workspace for a body's steps; NULL members: none is needed. A kick allocates nothing,
    /// unless its statistics say that it has factored a matrix.
    void* (*open)(Body* body, const Solver* solver);
    void (*close)(void* workspace);

    /// Compute the velocities after a kick of h, under forces, strain limits and contacts. *drift: the
    /// longest drift until contacts must be found again; it becomes less where contacts have made a
    /// node so fast that this drift would not be safe. False where a body's step was not solved: then no velocity has changed, and
    /// system->unsolved is that body.
    bool (*kick)(const struct Method* method, System* system, Contacts* contacts, double h,
                 double* drift);

    /// Velocities of one body under its forces alone, for system_kick. False: not solved.
    bool (*kick_body)(Body* body, void* workspace, double h, SolveStats* stats);

    /// The same for a group whose equation contains its contacts, for the bodies' and the balls'
    /// velocities and the contacts' impulses. NULL: contacts change the velocities after the kick.
    bool (*kick_group)(Group* group, double h);

    /// Whether a body's solver can solve the equation with contacts; NULL: always. Where it cannot,
    /// contacts change the velocities after kick_body.
    bool (*solves_contacts)(const void* workspace);

    /// Positions after h; `forward` also changes the velocities here. The others use body_drift.
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

/// Why the method cannot step this body, "takes no force 'membrane'", or NULL if it can.
const char* method_refuses(const Method* method, const Body* body);

/// The row's limit; INFINITY for an implicit method.
double method_limit(const Method* method, double w2, double gamma);

/// The bound that this program computes for a body: the method's limit for the sum of all forces'
/// bounds on the squared frequency (never less than the true one) and the damping rate. Every mode's
/// damping rate lies between the particles' smallest and largest, and the smaller limit of the two
/// is taken.
double method_bound(const Method* method, const Body* body);

#endif
