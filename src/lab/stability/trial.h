/// A stability experiment: one balloon at rest is perturbed and stepped by a method; does the
/// energy of the perturbation grow?
///
/// A trial is a scene without gravity, the guard off, brought to rest. A run starts from that rest,
/// moves every particle at random by up to 1e-6 of the balloon's size, and records the energy of
/// the perturbation,
///
///     e = kinetic + potential - potential at rest                                          [J]
///
/// With damping, every particle also gets a random velocity of up to 1e-6 of size times the highest
/// frequency, because above h = 2/gamma rigid motion is the first to become unstable. Without
/// damping it gets none: modes without a restoring force, such as rigid motion and folds of an
/// empty skin, would drift far, though they are neutrally stable. trial.c has the constants of the
/// definition and of the measurement.
#ifndef BALLOON_LAB_STABILITY_TRIAL_H
#define BALLOON_LAB_STABILITY_TRIAL_H

#include "force/tangent.h"
#include "world/world.h"

typedef enum Verdict {
    VERDICT_STABLE,
    VERDICT_MARGINAL, ///< the fitted growth of the energy is above zero
    VERDICT_EXPLODED, ///< the energy has grown ten times within 2,000 steps, or the state blew up
    VERDICTS
} Verdict;
extern const char* const verdict_name[VERDICTS];

extern const double trial_precision; ///< relative precision of trial_limit [1]

/// Sums for a straight line fitted to points (n, ln e) by least squares.
typedef struct TrialFit {
    double count, n, n2, y, y2, ny;
} TrialFit;

typedef struct Trial {
    World world;
    real4* rest;      ///< [count] positions without net force
    double potential; ///< at rest [J]
    double w2;        ///< largest eigenvalue of M^-1 K at rest [1/s^2]
    double gamma;     ///< c/m [1/s]

    // preparation: relaxation to rest, then power iteration for the highest frequency
    World calm;
    Tangent tangent;
    real4* mode;  ///< [count]
    real4* image; ///< [count] M^-1 K mode
    bool rested;
    int done; ///< steps of relaxation, then rounds of power iteration

    // the present run
    double h;            ///< step [s]
    double start_energy; ///< of the perturbation [J]
    double max;          ///< energy above which the run counts as an explosion [start_energy]
    int steps;           ///< number of steps
    int steps_done;
    TrialFit later; ///< over the second half
} Trial;

/// Load the scene with overrides, bring it to rest and find its fastest frequency. A method that
/// refuses the scene leaves its sentence in `refused`, else NULL, and the trial closed.
bool trial_open(Trial* trial, const char* scene, const SceneSet* set, int set_count,
                const Method* method, const char** refused, Fault* fault);

/// The same in small parts. trial_begin opens two worlds of the same balloon, owned by the trial:
/// `calm` with newton, for the relaxation, and `def` with the method. Then call trial_prepare until
/// `prepared`. Returns false with a fault if the balloon does not come to rest.
bool trial_begin(Trial* trial, WorldDef* calm, WorldDef* def, Fault* fault);
bool trial_prepare(Trial* trial, bool* prepared, Fault* fault);

/// Start a run with step h; continue it by at most `steps` steps. True: the verdict is certain.
void trial_start(Trial* trial, double h);
bool trial_follow(Trial* trial, int steps, Verdict* verdict, double* growth);

/// The verdict on a step h. growth: d ln e/dt over the second half of the run, by least squares, or
/// over all of it if the verdict was certain before the end [1/s].
Verdict trial_run(Trial* trial, double h, double* growth);

/// The largest stable step [s], searched between 1/100 and 100 times 2/w, the limit of undamped
/// semi-implicit Euler; a step longer by trial_precision is not stable. 0: no step is stable;
/// INFINITY: all are.
double trial_limit(Trial* trial);

/// The method's limit for the highest frequency at rest, and the bound that the program computes
/// [s].
double trial_theory(const Trial* trial);
double trial_bound(Trial* trial);

void trial_close(Trial* trial);

#endif
