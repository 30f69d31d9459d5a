/// The lab's page of the overlay, as plain arrays: plots over time. Whoever has measured fills it,
/// hud/ draws it the same in the window and headless.
#ifndef BALLOON_VIEW_PAGE_H
#define BALLOON_VIEW_PAGE_H

enum { PAGE_PLOTS = 4, PAGE_POINTS = 300 };

/// One quantity over the page's times.
typedef struct PagePlot {
    const char* label;
    char value[24]; ///< the last one, with its unit
    float y[PAGE_POINTS];
} PagePlot;

typedef struct Page {
    char title[64];
    int count;            ///< points of every plot
    float t[PAGE_POINTS]; ///< [count] their times, rising [s]
    int plot_count;
    PagePlot plot[PAGE_PLOTS];
} Page;

#endif
