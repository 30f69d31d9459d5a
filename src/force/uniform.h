/// The forces that act on every particle by the same law, added in one pass:
///
///     f_i += m_i a + p dV/dx_i - (drag + rate m_i) v_i
///
/// Each force adds its part to the numbers (Force.uniform).
#ifndef BALLOON_FORCE_UNIFORM_H
#define BALLOON_FORCE_UNIFORM_H

#include "base/vec.h"

typedef struct Uniform {
    real4 acceleration; ///< a [m/s^2]
    double pressure;    ///< p [Pa]
    double drag;        ///< [kg/s]
    double rate;        ///< [1/s]
} Uniform;

#endif
