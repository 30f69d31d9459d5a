/// The amounts of gas in a step: what the scene fills in, what held keys add and release, and what
/// moves through pipes and leaks. All of it is known before the step.
///
/// It enters evenly over the substeps. The gas of a whole step at once is a jump of the pressure, dp =
/// p dn/n, whose energy V dp^2 / (2 p) becomes motion of the skin and stays there without damping.
/// Measured at 10 s of `peak` by semi-implicit Euler, whose step of 1/30 s has 5,000 substeps: 17 J of
/// kinetic energy beside 78 J in the rubber, and pressures of 480 to 1,120 Pa, where steps of 2e-4 s
/// have 1e-5 J and 786 Pa.
#ifndef BALLOON_WORLD_GAS_FLOW_H
#define BALLOON_WORLD_GAS_FLOW_H

typedef struct World World;

/// Set the amounts at the end of this step: by the scenes' fillings and the held keys.
void gas_flow_fill(World* world);

/// And by pipes and leaks, at the pressures of now.
void gas_flow_through(World* world);

/// Set the amounts at the end of a substep, at this share of the step: 1 is its end.
void gas_flow_reach(World* world, double share);

#endif
