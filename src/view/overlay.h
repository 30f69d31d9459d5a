/// What the overlay says, as plain text: the world and the main loop fill it, hud/ draws it the
/// same in the window and headless.
#ifndef BALLOON_VIEW_OVERLAY_H
#define BALLOON_VIEW_OVERLAY_H

#include <stdbool.h>
#include <stddef.h>

#include "view/lab_panel.h"

enum { OVERLAY_ROWS = 24, OVERLAY_TEXT = 112, OVERLAY_KEYS = 40 };

/// "label  value", one line of the status box.
typedef struct OverlayRow {
    char label[32];
    char value[OVERLAY_TEXT];
} OverlayRow;

/// A key and what it does, one line of the help box.
typedef struct OverlayKey {
    const char* key;
    const char* about;
} OverlayKey;

typedef struct Overlay {
    bool shown;               ///< the status box
    char title[OVERLAY_TEXT]; ///< the scene's title
    int row_count;
    OverlayRow row[OVERLAY_ROWS];
    bool help_shown; ///< the help box with all keys
    int key_count;
    OverlayKey key[OVERLAY_KEYS];
    const LabPanel* lab_panel; ///< the lab's, where no help is; NULL: not shown
    char message[512];         ///< a sentence in the middle of the lower rim; empty: none
    bool alarm;                ///< the message is about what must not be: shown in red
} Overlay;

/// Append a row; what does not fit is cut, never overrun.
void overlay_row(Overlay* overlay, const char* label, const char* format, ...)
    __attribute__((format(printf, 3, 4)));

/// Copy a text into one of the overlay's; what does not fit is cut, never overrun.
void overlay_text(char* text, size_t size, const char* from);

#endif
