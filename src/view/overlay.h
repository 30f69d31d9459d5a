/// The overlay as plain text: view/status.c and the main loop fill it, hud/ draws it, in the window
/// as headless.
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
    bool status_visible;
    char title[OVERLAY_TEXT]; ///< the scene's title
    int row_count;
    OverlayRow row[OVERLAY_ROWS];
    bool has_crossings;   ///< the scene has skins that touch
    double crossings;     ///< when last counted
    long crossings_clock; ///< the world's clock then, plus 1; 0: never
    bool help_visible;    ///< the help box with all keys
    int key_count;
    OverlayKey key[OVERLAY_KEYS];
    const LabPanel* lab_panel; ///< hidden while the help box is visible; NULL: none
    char message[512];         ///< a sentence at the middle of the lower edge; empty: none
    bool alarm;                ///< the message reports an error: drawn in red
} Overlay;

/// Append a row; a text that is too long is truncated.
void overlay_row(Overlay* overlay, const char* label, const char* format, ...)
    __attribute__((format(printf, 3, 4)));

/// Copy a text into one of the overlay's; a text that is too long is truncated.
void overlay_text(char* text, size_t size, const char* from);

#endif
