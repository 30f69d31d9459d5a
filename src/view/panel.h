/// What the overlay says, as plain text: the world and the main loop fill it, hud/ draws it the
/// same in the window and headless.
#ifndef BALLOON_VIEW_PANEL_H
#define BALLOON_VIEW_PANEL_H

#include <stdbool.h>
#include <stddef.h>

#include "view/page.h"

enum { PANEL_ROWS = 24, PANEL_TEXT = 112, PANEL_KEYS = 40 };

/// "label  value", one line of the status box.
typedef struct PanelRow {
    char label[32];
    char value[PANEL_TEXT];
} PanelRow;

/// A key and what it does, one line of the help box.
typedef struct PanelKey {
    const char* key;
    const char* about;
} PanelKey;

typedef struct Panel {
    bool shown;             ///< the status box
    char title[PANEL_TEXT]; ///< the scene's title
    int row_count;
    PanelRow row[PANEL_ROWS];
    bool help_shown; ///< the help box with all keys
    int key_count;
    PanelKey key[PANEL_KEYS];
    const Page* page;  ///< the lab's, where no help is; NULL: not shown
    char message[512]; ///< a sentence in the middle of the lower rim; empty: none
    bool alarm;        ///< the message is about what must not be: shown in red
} Panel;

/// Append a row; what does not fit is cut, never overrun.
void panel_row(Panel* panel, const char* label, const char* format, ...)
    __attribute__((format(printf, 3, 4)));

/// Copy a text into one of the panel's; what does not fit is cut, never overrun.
void panel_text(char* text, size_t size, const char* from);

#endif
