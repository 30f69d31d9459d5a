/// Commands that keys give a world: the table from which the input log, the help overlay, --help
/// and the README are made. Keys that only change the view are in show/keys.c.
#ifndef BALLOON_WORLD_COMMAND_H
#define BALLOON_WORLD_COMMAND_H

#include <stdio.h>

#include "world/world.h"

typedef struct Command {
    const char* name; ///< in the input log
    const char* key;  ///< default key, as the help shows it
    const char* about;
    void (*down)(World* world);           ///< called once when the key goes down; or NULL
    void (*hold)(World* world, double h); ///< called in each step while the key is down; or NULL
} Command;

/// inflate, deflate, select, correction, tarantino, string, reset.
extern const Command command_table[];
extern const int command_count;

/// Row by name, or -1.
int command_find(const char* name);

/// As Markdown: the names of the keys, and what a `set` may set while a world runs.
void command_reference(FILE* out);

#endif
