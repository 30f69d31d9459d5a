/// What is charted: a table of cases, one row for each question that a scene answers.
///
/// A case is a shipped scene, dressed in one or several skins; each skin is run on its resolutions
/// by every method that takes it. What is measured is a function of the CSV of the run, and has a
/// truth of lab/truth.h.
#ifndef BALLOON_LAB_CHART_CASE_H
#define BALLOON_LAB_CHART_CASE_H

#include "lab/report.h"

/// The smallest chart that holds something; each larger one holds it too.
typedef enum ChartExtent { CHART_QUICK, CHART_FULL, CHART_ALL } ChartExtent;

/// Which methods run a resolution.
typedef enum ChartWho { ANY, EXPLICIT, IMPLICIT } ChartWho;

/// In which precisions.
typedef enum ChartState { DOUBLE, BOTH } ChartState;

typedef struct ChartResolution {
    const char* model; ///< NULL ends a list
    double step;       ///< [s]
    ChartWho who;
    ChartState state;
    ChartExtent extent;
} ChartResolution;

enum { CHART_SETS = 6, CHART_SKINS = 8, CHART_MEASURES = 6 };

typedef struct ChartSkin {
    const char* set[CHART_SETS]; ///< keys of the scene, up to the first NULL
    double mass;                 ///< of all particles together [kg]; 0: the scene's
    const ChartResolution* resolution;
} ChartSkin;

typedef struct ChartMeasure {
    const char* name;  ///< NULL where the scene's is enough
    const char* about; ///< "gauge pressure [Pa]"
    const char* set;   ///< a key of the scene for this measure alone, or NULL
    double (*measured)(const Report* report);
    double (*truth)(const ChartSkin* skin);
} ChartMeasure;

typedef struct ChartCase {
    const char* letter;
    const char* scene;
    const char* about;
    double seconds; ///< simulated [s]
    double rows;    ///< of the CSV, per simulated second
    ChartSkin skin[CHART_SKINS];
    ChartMeasure measure[CHART_MEASURES];
} ChartCase;

extern const ChartCase chart_exact_cube, chart_sphere_gas, chart_sphere_pressure, chart_sphere_step;

extern const ChartCase* const chart_table[];
extern const int chart_count;

#endif
