/// One balloon at rest, pushed a little and left to a method: does what was given to it grow?
///
/// A trial holds a shipped scene without gravity, the guard off, brought to rest. A run starts from
/// that rest, moves every particle at random by up to 1e-6 of the balloon's size, and follows the
/// energy of what was given,
///
///     e = kinetic + potential - potential at rest                                          [J]
///
/// Where something damps, every particle gets a velocity too, 1e-6 of size times the fastest
/// frequency: past 2/gamma rigid motion is the first to fail. Where nothing damps it gets none, for
/// what meets no force, as rigid motion and folds of an empty skin, would drift far and be neutral
/// in theory. The constants of the definition and of the measurement stand in trial.c.
#ifndef BALLOON_LAB_STABILITY_TRIAL_H
#define BALLOON_LAB_STABILITY_TRIAL_H

#include "force/tangent.h"
#include "world/world.h"

typedef enum Verdict {
    VERDICT_STABLE,
    VERDICT_WOBBLING, ///< the fitted growth of the energy is above zero
    VERDICT_EXPLODED, ///< the energy has grown ten times within 2,000 steps, or the state went bad
    VERDICTS
} Verdict;
extern const char* const verdict_name[VERDICTS];

extern const double trial_precision; ///< of trial_limit [1]

/// A straight line through points (n, ln e) that come one by one.
typedef struct TrialFit {
    double count, n, n2, y, y2, ny;
} TrialFit;

typedef struct Trial {
    World world;
    real4* rest;      ///< [count] positions without net force
    double potential; ///< at rest [J]
    double w2;        ///< largest eigenvalue of M^-1 K at rest [1/s^2]
    double gamma;     ///< c/m [1/s]

    // on the way to rest, and to the fastest frequency
    World calm;
    Tangent tangent;
    real4* mode;  ///< [count]
    real4* image; ///< [count] M^-1 K mode
    bool rested;
    int done; ///< steps to rest, then rounds of power iteration

    // of the present run
    double h;     ///< its step [s]
    double first; ///< energy given [J]
    double most;  ///< [first energy] more is an explosion
    int steps;    ///< in all
    int made;     ///< of them
    TrialFit later;
} Trial;

/// Load the scene with overrides, bring it to rest and find its fastest frequency. A method that
/// refuses the scene leaves its sentence in `refused`, else NULL, and the trial closed.
bool trial_open(Trial* trial, const char* scene, const SceneSet* set, int set_count,
                const Method* method, const char** refused, Fault* fault);

/// The same in parts, for who has other things to do: first only the worlds are opened, which the
/// trial then owns, both of the same balloon: `calm` with newton, which brings it to rest, and
/// `def` with the method; then parts, until `ready`. False with a sentence where there is no rest.
bool trial_begin(Trial* trial, WorldDef* calm, WorldDef* def, Fault* fault);
bool trial_prepare(Trial* trial, bool* ready, Fault* fault);

/// A run of a step h, and at most so many steps of it: true when the verdict is certain.
void trial_start(Trial* trial, double h);
bool trial_follow(Trial* trial, int steps, Verdict* verdict, double* growth);

/// The verdict on a step h. growth: d ln e/dt over the later half of the run, by least squares, or
/// over all of it where the verdict was certain before the end [1/s].
Verdict trial_run(Trial* trial, double h, double* growth);

/// The largest stable step [s]: found between 1/100 and 100 times 2/w, the limit of undamped
/// semi-implicit Euler; trial_precision times longer is not stable. 0: there is none; INFINITY: all
/// are.
double trial_limit(Trial* trial);

/// The method's limit for the true fastest frequency, and the bound that the program computes [s].
double trial_theory(const Trial* trial);
double trial_bound(Trial* trial);

void trial_close(Trial* trial);

#endif
