/// `balloon peer`: Bullet's own soft body in a scene's first balloon's place, as `balloon run`
/// would run it: the same mesh, mass, damping and pressure law, and the same CSV.
///
/// Bullet has no law of stiffness: a link is as stiff as step, mass and rounds make it. So its
/// links are fitted, as who uses it must: the fewest rounds, doubled from 1, and then the softest
/// links with which the skin rests at a given volume under a given pressure; or, where there is no
/// such rest, links that move their ends in a step as a spring of k would,
///
///     rounds * stiffness = k h^2 (1/m + 1/m)
///
/// Its pressure is set before each step, in its favour, to what the scene's law says of the present
/// volume and area. Its strings are rods; it has only balls that are there from the start.
#ifndef BALLOON_LAB_PEER_PEER_RUN_H
#define BALLOON_LAB_PEER_PEER_RUN_H

#include "lab/peer/peer_world.h"

typedef struct PeerFit {
    double spring;   ///< k of a spring to be like [N/m]; 0: what follows
    double pressure; ///< gauge [Pa]
    double ratio;    ///< volume at rest under it, in first volumes [1]; 0: links stay Bullet's own
    double step;     ///< at this step; 0: at the run's own [s]
} PeerFit;

typedef struct PeerRun {
    double seconds; ///< simulated [s]
    double fps;     ///< rows of the CSV per simulated second
    PeerFit fit;
    bool time;   ///< print the CPU time of Bullet's steps alone
    bool report; ///< print the line of lab/run/report_line.h
    bool quiet;
} PeerRun;

/// The links that the fit asks for; where the stiffest there are will not do, those.
PeerLinks peer_fit(World* world, const PeerFit* fit);

/// Run, and print the CSV to `csv`, NULL for none. The world's first balloon is left as the peer
/// is. False with a sentence where its state went bad.
bool peer_run(World* world, const PeerRun* options, FILE* csv, Fault* fault);

#endif
