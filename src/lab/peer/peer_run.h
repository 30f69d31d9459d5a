/// `balloon peer`: `balloon run` with Bullet's own soft body instead of a scene's first balloon:
/// the same mesh, mass, damping and pressure law, and the same CSV.
///
/// The stiffness of Bullet's links depends on step, mass and rounds, so they must be fitted: to the
/// fewest rounds (1, 2, 4, …) and then the softest links with which the skin rests at a given
/// volume under a given pressure; or, if the skin has no such rest, to links whose correction in a
/// step equals that of a spring of stiffness k,
///
///     rounds * stiffness = k h^2 (1/m + 1/m)
///
/// In its favor, its pressure is set before each step to the scene's law at the present volume and
/// area. Strings become rods; balls must be in the scene from the start.
#ifndef BALLOON_LAB_PEER_PEER_RUN_H
#define BALLOON_LAB_PEER_PEER_RUN_H

#include "lab/peer/peer_world.h"

typedef struct PeerFit {
    double spring;   ///< k of the spring to imitate [N/m]; 0: fit pressure and ratio
    double pressure; ///< gauge [Pa]
    double ratio; ///< volume at rest under `pressure` over the initial volume [1]; 0: default links
    double step;  ///< step of the fit [s]; 0: the run's
} PeerFit;

typedef struct PeerRun {
    double seconds; ///< simulated [s]
    double fps;     ///< rows of the CSV per simulated second
    PeerFit fit;
    bool time;   ///< print the CPU time of Bullet's steps alone
    bool report; ///< print the line of lab/run/report_line.h
    bool quiet;
} PeerRun;

/// Run, and print the CSV to `csv`, NULL for none. The world's first balloon ends in the peer's
/// state. Returns false with a fault if that state is bad.
bool peer_run(World* world, const PeerRun* options, FILE* csv, Fault* fault);

#endif
