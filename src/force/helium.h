/// Lift of helium as the mass-spring paper has it: an upward acceleration
///
///     a = base + per_inflation * amount                                             [m/s^2]
///
/// of every particle, with the present amount of gas (body/gas.h).
#ifndef BALLOON_FORCE_HELIUM_H
#define BALLOON_FORCE_HELIUM_H

#include "force/force.h"

/// Parameters of the row.
enum { HELIUM_BASE, HELIUM_PER_INFLATION };

/// a at the present amount [m/s^2].
static inline double helium_acceleration(const Body* body) {
    const double* parameter = body->force_parameter[FORCE_HELIUM];
    return parameter[HELIUM_BASE] + parameter[HELIUM_PER_INFLATION] * body->inflation.amount;
}

#endif
