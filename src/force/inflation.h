/// Inflation: the pressure on the skin along the exact gradient of the enclosed volume, f = p
/// dV/dx.
///
///     area      p = 100 amount / A, A the skin's area: falls as the balloon grows. The mass-spring
///               paper's k_normal, with "closest_face_to_particle / total_surface_area" read as a
///               particle's share of the area: the push is per area, along the true gradient
///     pressure  p = amount, constant                              E = -p V
///     gas       p = n R T / V - ambient, an ideal gas (body/gas.h)
///                                                                 E = -n R T ln V + ambient V
///
/// On a closed skin the net force and net torque vanish, for p is one number and V does not change
/// when the skin moves or turns as a whole. An open skin encloses nothing: only `area` is for it.
#ifndef BALLOON_FORCE_INFLATION_H
#define BALLOON_FORCE_INFLATION_H

#include "body/body.h"

/// Gauge pressure at the present positions [Pa].
double inflation_pressure(const Body* body);

#endif
