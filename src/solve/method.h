/// Methods of time stepping: a table, one file and one row each.
///
/// A step is a kick and a drift. The method's kick gives the velocities at the end of the step
/// under the forces that the scene lists; corrections and contacts then have their say on them; the
/// drift x' = x + h v' is the same for all (body_drift). A method knows forces only through the
/// force table, so a new force serves every method.
#ifndef BALLOON_SOLVE_METHOD_H
#define BALLOON_SOLVE_METHOD_H

#include "body/body.h"

typedef struct Method {
    const char* name;
    const char* about;
    void (*kick)(Body* body, double h);

    /// Largest stable step [s] for the largest squared frequency w2 [1/s^2] and the damping rate
    /// gamma = c/m [1/s]; INFINITY where there is none.
    double (*limit)(double w2, double gamma);
} Method;

extern const Method method_euler;

extern const Method* const method_table[];
extern const int method_count;

/// Row by name, or NULL.
const Method* method_find(const char* name);

/// Names of all methods, "euler, …", for sentences.
const char* method_names(void);

/// The bound that this program computes for a body: the method's limit for the sum of all forces'
/// bounds on the squared frequency (never less than the true one) and the damping.
double method_bound(const Method* method, const Body* body);

#endif
