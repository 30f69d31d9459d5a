/// What is charted: a table of cases, one row for each question that a scene answers.
///
/// A case is a shipped scene with one or several skins; each skin is run on its resolutions
/// by every method that takes it. What is measured is a function of the CSV of the run, and has a
/// truth of lab/truth/truth.h.
#ifndef BALLOON_LAB_CHART_CHART_CASE_H
#define BALLOON_LAB_CHART_CHART_CASE_H

#include "lab/run/report.h"

/// The smallest chart that holds something; each larger one holds it too.
typedef enum ChartExtent { CHART_QUICK, CHART_FULL, CHART_ALL } ChartExtent;

/// Which methods run a resolution: STABLE_UNDAMPED are those with a stable step without damping, to
/// which the guard can split.
typedef enum ChartMethods { ANY, EXPLICIT, IMPLICIT, STABLE_UNDAMPED } ChartMethods;

/// In which precisions.
typedef enum ChartState { DOUBLE, BOTH } ChartState;

typedef struct ChartResolution {
    const char* model; ///< NULL ends a list
    double step;       ///< [s]
    ChartMethods methods;
    ChartState state;
    ChartExtent extent;
} ChartResolution;

enum { CHART_SETS = 4, CHART_SKINS = 8, CHART_MEASURES = 6 };

typedef struct ChartSkin {
    const char* set[CHART_SETS]; ///< keys of the scene, up to the first NULL
    const char* material;        ///< of a membrane in `set`; NULL: the scene's own skin
    const char* law;             ///< a skin of springs with this law; NULL: the scene's own skin
    double (*sheet)(void);       ///< and of this E h: kd = E h/2, ks + 4 kf = E h [N/m]
    double mass;                 ///< of all particles together [kg]; 0: the scene's
    const char* only;            ///< this method alone; NULL: all
    bool apart;                  ///< judged by its own law, no answer to what the case asks
    const ChartResolution* resolution;
} ChartSkin;

typedef struct ChartMeasure {
    const char* name;  ///< NULL where the scene's is enough
    const char* about; ///< "gauge pressure"
    const char* unit;  ///< of an error that is none of something; NULL: it is relative
    double at;         ///< the time or stretch that this row of several asks for
    const char* key;   ///< of the scene, set to `value` for this measure alone; or NULL
    double (*value)(double at);
    double (*measured)(const Report* report, double at);

    /// NULL: reference runs; where it is 0, what is measured is the error itself, in `unit`.
    double (*truth)(const ChartSkin* skin, double at);
} ChartMeasure;

/// Where no closed form is known, the truth is what two runs of one method tell of no step at all,
/// 2 m(h/2) - m(h), and its own error how far another method's two are from that.
typedef struct ChartReference {
    const char* model;
    const char* method[2];
    double step[2]; ///< h of each [s]
} ChartReference;

/// Bullet's own soft body on the case (lab/peer/peer_run.h). Its links are fitted to rest at `stretch`
/// under `pressure`, or to be as springs are; `set` are keys of the scene for it alone.
typedef struct ChartPeer {
    double spring;            ///< [N/m]; 0: not
    double (*pressure)(void); ///< [Pa]; NULL: links stay Bullet's own, the stiffest
    double (*stretch)(void);  ///< [1]
    double step;              ///< at this step for all resolutions [s]; 0: at each one's own
    const char* set[CHART_SETS];
    const char* key; ///< one more, set to `value`; or NULL
    double (*value)(void);
    const ChartResolution* resolution; ///< NULL: Bullet cannot play this scene
    const char* none;                  ///< why not
} ChartPeer;

typedef struct ChartCase {
    const char* letter;
    const char* scene;
    const char* about;
    double seconds; ///< simulated [s]
    double rows;    ///< of the CSV, per simulated second
    ChartSkin skin[CHART_SKINS];
    ChartMeasure measure[CHART_MEASURES];
    ChartReference reference;
    ChartPeer peer;
} ChartCase;

extern const ChartCase chart_exact_cube, chart_sphere_gas, chart_sphere_pressure, chart_sphere_step,
    chart_discs, chart_ball_rests, chart_tether, chart_squirrel_turns, chart_sphere_fill,
    chart_sphere_curve, chart_independence, chart_sphere_free;

extern const ChartCase* const chart_table[];
extern const int chart_count;

#endif
