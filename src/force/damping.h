/// Drag of the air: a force -d_i v_i on each particle,
///
///     d_i = coefficient + rate m_i                                                  [kg/s]
///
/// A scene sets one of the two parameters.
#ifndef BALLOON_FORCE_DAMPING_H
#define BALLOON_FORCE_DAMPING_H

#include "force/force.h"

/// Parameters of the row.
enum { DAMPING_COEFFICIENT, DAMPING_RATE };

/// d_i [kg/s]
static inline double damping_drag(const Body* body, int particle) {
    const double* parameter = body->force_parameter[FORCE_DAMPING];
    return parameter[DAMPING_COEFFICIENT] + parameter[DAMPING_RATE] * (double)body->mass[particle];
}

#endif
