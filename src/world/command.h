/// What keys do to a world: the table that the input log, the help overlay, --help and the README
/// walk. Keys that only change the view are in show/keys.c.
#ifndef BALLOON_WORLD_COMMAND_H
#define BALLOON_WORLD_COMMAND_H

#include "world/world.h"

typedef struct Command {
    const char* name; ///< in the input log
    const char* key;  ///< default key, as the help shows it
    const char* about;
    void (*down)(World* world);           ///< once, when the key goes down; or NULL
    void (*hold)(World* world, double h); ///< in each step while it is down; or NULL
} Command;

/// inflate, deflate, select, correction, tarantino, string, reset.
extern const Command command_table[];
extern const int command_count;

/// Row by name, or -1.
int command_find(const char* name);

#endif
