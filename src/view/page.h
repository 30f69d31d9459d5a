/// The lab's page of the overlay, as plain arrays: plots over time, what a skin should do beside
/// what it does, a map of where steps fail, and a slider from fast to accurate. Whoever has
/// measured fills it, hud/ draws it the same in the window and headless.
#ifndef BALLOON_VIEW_PAGE_H
#define BALLOON_VIEW_PAGE_H

#include <stdbool.h>

enum { PAGE_PLOTS = 4, PAGE_POINTS = 300, PAGE_CURVE = 120, PAGE_ROWS = 9, PAGE_COLUMNS = 17 };
enum { PAGE_NOTCHES = 32, PAGE_LINES = 4 };

/// One quantity over the page's times.
typedef struct PagePlot {
    const char* label;
    char value[24]; ///< the last one, with its unit
    float y[PAGE_POINTS];
} PagePlot;

/// Pressure over stretch: what it should be, and the way that the balloon has come.
typedef struct PageCurve {
    const char* law;           ///< whose closed form it is
    char value[64];            ///< where the balloon is, and how far off
    float stretch, pressure;   ///< ends of the axes, which begin at 1 and 0
    float truth[PAGE_CURVE];   ///< p at equal distances from l = 1 to `stretch`
    int count;                 ///< points of the way, the last of which is now
    float way[PAGE_POINTS][2]; ///< [count] l, p
} PageCurve;

typedef enum PageCell {
    PAGE_UNKNOWN,
    PAGE_STABLE,
    PAGE_WOBBLING,
    PAGE_EXPLODED,
    PAGE_CELLS
} PageCell;

/// Which steps are stable, over steps (to the right) and stiffnesses (upward).
typedef struct PageMap {
    const char* method;
    PageCell cell[PAGE_ROWS][PAGE_COLUMNS];
    float theory[PAGE_ROWS]; ///< the limit, in columns: 0 is the middle of the first; NAN: none
    float bound[PAGE_ROWS];  ///< what the program holds its steps against
    int own[2];              ///< row and column of the scene as it is
    int chosen[2];
    bool watched;   ///< the scene is now that of the chosen cell
    char ends[64];  ///< of the axes
    char value[96]; ///< the chosen cell in words
    char why[48];   ///< why cells are missing; empty: they are not, or will come
} PageMap;

/// A slider from fast to accurate, a notch for each way that is measured.
typedef struct PageSlider {
    int notches; ///< 0: nothing is known, and the lines say what to do
    int at;      ///< the present one, 1 …; 0: none
    int lines;
    char line[PAGE_LINES][96]; ///< [lines] below the track
} PageSlider;

typedef struct Page {
    char title[64];
    int count;            ///< points of every plot
    float t[PAGE_POINTS]; ///< [count] their times, rising [s]
    int plot_count;
    PagePlot plot[PAGE_PLOTS];
    bool has_curve;
    PageCurve curve;
    PageMap map;
    PageSlider slider;
} Page;

#endif
