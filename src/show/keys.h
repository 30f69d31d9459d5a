/// The table of keys that change the view and not the world. Keys that change the world are in
/// world/command.h. The help box, --help and the README list both through keys_row.
#ifndef BALLOON_SHOW_KEYS_H
#define BALLOON_SHOW_KEYS_H

#include <stdio.h>

#include "view/overlay.h"

struct App; // show/app.h

typedef struct ViewKey {
    const char* key;
    const char* about;
    void (*down)(struct App* app);
} ViewKey;

extern const ViewKey view_key_table[];
extern const int view_key_count;

/// Row by the key's name, or NULL.
const ViewKey* view_key_find(const char* key);

/// The row of command_table that a key triggers, or -1.
int command_key_find(const char* key);

/// All keys, commands first: row 0 … keys_count() - 1.
int keys_count(void);
OverlayKey keys_row(int row);

/// Print "  key  description", one a line, for --help and the README.
void keys_print(FILE* out);

#endif
