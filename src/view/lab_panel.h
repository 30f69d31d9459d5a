/// The lab's panel of the overlay, as plain arrays: plots over time, what a skin should do beside
/// what it does, a map of where steps fail, and a slider from fast to accurate. Whoever has
/// measured fills it, hud/ draws it the same in the window and headless.
#ifndef BALLOON_VIEW_LAB_PANEL_H
#define BALLOON_VIEW_LAB_PANEL_H

#include <stdbool.h>

enum { LAB_PLOTS = 4, LAB_POINTS = 300, LAB_CURVE = 120, LAB_ROWS = 9, LAB_COLUMNS = 17 };
enum { LAB_NOTCHES = 32, LAB_LINES = 4 };

/// One quantity over the panel's times.
typedef struct LabPlot {
    const char* label;
    char value[24]; ///< the last one, with its unit
    float y[LAB_POINTS];
} LabPlot;

/// Pressure over stretch: what it should be, and the way that the balloon has come.
typedef struct LabCurve {
    const char* law;           ///< whose closed form it is
    char value[64];            ///< where the balloon is, and how far off
    float stretch, pressure;   ///< ends of the axes, which begin at 1 and 0
    float truth[LAB_CURVE];    ///< p at equal distances from l = 1 to `stretch`
    int count;                 ///< points of the way, the last of which is now
    float path[LAB_POINTS][2]; ///< [count] l, p
} LabCurve;

typedef enum LabCell { LAB_UNKNOWN, LAB_STABLE, LAB_WOBBLING, LAB_EXPLODED, LAB_CELLS } LabCell;

/// Which steps are stable, over steps (to the right) and stiffnesses (upward).
typedef struct LabMap {
    const char* method;
    LabCell cell[LAB_ROWS][LAB_COLUMNS];
    float theory[LAB_ROWS]; ///< the limit, in columns: 0 is the middle of the first; NAN: none
    float bound[LAB_ROWS];  ///< what the program holds its steps against
    int own[2];             ///< row and column of the scene as it is
    int chosen[2];
    bool watched;   ///< the scene is now that of the chosen cell
    char ends[64];  ///< of the axes
    char value[96]; ///< the chosen cell in words
    char why[48];   ///< why cells are missing; empty: they are not, or will come
} LabMap;

/// A slider from fast to accurate, a notch for each way that is measured.
typedef struct LabSlider {
    int notches; ///< 0: nothing is known, and the lines say what to do
    int at;      ///< the present one, 1 …; 0: none
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
