/// A list of overrides of a scene, as texts KEY=VALUE.
#ifndef BALLOON_LAB_RUN_OVERRIDES_H
#define BALLOON_LAB_RUN_OVERRIDES_H

enum { MAX_OVERRIDES = 48 };

typedef struct Overrides {
    char text[MAX_OVERRIDES][256];
    int count;
} Overrides;

/// Append an override, formatted like printf.
void overrides_add(Overrides* sets, const char* format, ...) __attribute__((format(printf, 2, 3)));

#endif
