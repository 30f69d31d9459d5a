/// The cases of a chart: a table of one row each.
///
/// A case is a shipped scene with one or several skins; each skin is run at its resolutions by
/// every method that accepts it. A measure is a function of the run's CSV, and is compared with a
/// closed form of lab/truth/truth.h or with reference runs.
#ifndef BALLOON_LAB_CHART_CHART_CASE_H
#define BALLOON_LAB_CHART_CHART_CASE_H

#include "lab/run/report.h"

/// The smallest chart that contains a resolution; larger charts contain it too.
typedef enum ChartExtent { CHART_QUICK, CHART_FULL, CHART_ALL } ChartExtent;

/// The methods that run a resolution. STABLE_UNDAMPED: those that have a stable step without
/// damping, into which the guard can split.
typedef enum ChartMethods { ANY, EXPLICIT, IMPLICIT, STABLE_UNDAMPED } ChartMethods;

/// The precisions of a resolution.
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
    const char* material;        ///< material of a membrane in `set`; NULL: the scene's own skin
    const char* law;             ///< law of a skin of springs; NULL: the scene's own skin
    double (*sheet)(void);       ///< E h of these springs: kd = E h/2, ks + 4 kf = E h [N/m]
    double mass;                 ///< total mass of the particles [kg]; 0: the scene's
    const char* only;            ///< the only method that runs it; NULL: all
    bool apart; ///< follows another law than the case's: compared with that law's truth
    const ChartResolution* resolution;
} ChartSkin;

typedef struct ChartMeasure {
    const char* name;  ///< NULL for the only measure of a case
    const char* about; ///< description, such as "gauge pressure"
    const char* unit;  ///< unit of an absolute error; NULL: the error is relative
    double at;         ///< the argument of the functions below: a time or a stretch
    const char* key;   ///< a key of the scene that is set to `value` for this measure; or NULL
    double (*value)(double at);
    double (*measured)(const Report* report, double at);

    /// The true value; if it is 0, the measured value is the error, in `unit`. NULL: reference
    /// runs.
    double (*truth)(const ChartSkin* skin, double at);
} ChartMeasure;

/// Reference runs of a case without a closed form. Two runs of one method, extrapolated to step 0
/// by 2 m(h/2) - m(h), give the truth; its distance from that of another method is the truth's
/// error.
typedef struct ChartReference {
    const char* model;
    const char* method[2];
    double step[2]; ///< h of each [s]
} ChartReference;

/// Bullet's own soft body on the case (lab/peer/peer_run.h). Its links are fitted so that the skin
/// rests at `stretch` under `pressure`, or so that they imitate springs.
typedef struct ChartPeer {
    double spring; ///< stiffness of the imitated springs [N/m]; 0: fit stretch and pressure
    double (*pressure)(void);    ///< [Pa]; NULL: Bullet's default links, the stiffest
    double (*stretch)(void);     ///< [1]
    double step;                 ///< step of the fit [s]; 0: each resolution's own
    const char* set[CHART_SETS]; ///< keys of the scene for the peer alone
    const char* key;             ///< one more key, set to `value`; or NULL
    double (*value)(void);
    const ChartResolution* resolution; ///< NULL: Bullet cannot run this scene
    const char* none;                  ///< the reason for that
} ChartPeer;

typedef struct ChartCase {
    const char* letter;
    const char* scene;
    const char* about;
    double seconds; ///< simulated [s]
    double rows;    ///< rows of the CSV per simulated second
    int balloons;   ///< how many get the resolution's model; 0: one
    ChartSkin skin[CHART_SKINS];
    ChartMeasure measure[CHART_MEASURES];
    ChartReference reference;
    ChartPeer peer;
} ChartCase;

extern const ChartCase chart_exact_cube, chart_sphere_gas, chart_sphere_pressure, chart_sphere_step,
    chart_discs, chart_ball_rests, chart_tether, chart_squirrel_turns, chart_sphere_fill,
    chart_sphere_curve, chart_independence, chart_sphere_free, chart_plates, chart_plates_force,
    chart_pair;

extern const ChartCase* const chart_table[];
extern const int chart_count;

#endif
