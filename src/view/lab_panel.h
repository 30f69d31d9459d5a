/// The lab panel of the overlay, as plain arrays: plots over time, the closed form of a balloon
/// beside its measured curve, a map of which steps are stable, and a slider from fast to accurate.
/// show/live_lab.c fills it; hud/ draws it, in the window as headless.
#ifndef BALLOON_VIEW_LAB_PANEL_H
#define BALLOON_VIEW_LAB_PANEL_H

#include <stdbool.h>

enum { LAB_PLOTS = 4, LAB_POINTS = 300, LAB_CURVE = 120, LAB_ROWS = 9, LAB_COLUMNS = 17 };
enum { LAB_NOTCHES = 32, LAB_LINES = 4 };

/// One quantity at the panel's times.
typedef struct LabPlot {
    const char* label;
    char value[24]; ///< the last value, with its unit
    float y[LAB_POINTS];
} LabPlot;

/// Pressure over stretch: the closed form, and the recorded path of the balloon.
typedef struct LabCurve {
    const char* law;           ///< material law of the closed form
    char value[64];            ///< the present stretch and pressure, and the error, as text
    float stretch, pressure;   ///< upper ends of the axes, which begin at 1 and 0
    float truth[LAB_CURVE];    ///< p of the closed form at equal distances from l = 1 to `stretch`
    int count;                 ///< points of the path, the last of which is the present state
    float path[LAB_POINTS][2]; ///< [count] stretch l, pressure p
} LabCurve;

typedef enum LabCell { LAB_UNKNOWN, LAB_STABLE, LAB_MARGINAL, LAB_EXPLODED, LAB_CELLS } LabCell;

/// Which steps are stable: columns are steps, rows are stiffnesses, the lowest first.
typedef struct LabMap {
    const char* method;
    LabCell cell[LAB_ROWS][LAB_COLUMNS];
    float theory[LAB_ROWS]; ///< limit, in columns: 0 is the middle of the first; NAN: unknown
    float bound[LAB_ROWS];  ///< the guard's bound, in the same units
    int own[2];             ///< row and column of the scene's own stiffness and step
    int chosen[2];          ///< row and column that the user has chosen
    bool watched;           ///< the scene runs with the stiffness and step of the chosen cell
    char ends[64];          ///< ends of the axes, as text
    char value[96];         ///< the chosen cell, as text
    char why[48];           ///< why cells are missing; empty: none are, or they are being measured
} LabMap;

/// A slider from fast to accurate, with a notch for each measured setting.
typedef struct LabSlider {
    int notches; ///< 0: nothing is measured, and the lines say what to do
    int notch;   ///< the present one, 1 …; 0: none
    int lines;
    char line[LAB_LINES][96]; ///< [lines] below the track
} LabSlider;

typedef struct LabPanel {
    char title[64];
    int count;           ///< points of every plot
    float t[LAB_POINTS]; ///< [count] their times, rising [s]
    int plot_count;
    LabPlot plot[LAB_PLOTS];
    bool has_curve;
    LabCurve curve;
    LabMap map;
    LabSlider slider;
} LabPanel;

#endif
