/// Which numbers a scene may give: a table of keys and their ranges. Keys without a row take any
/// finite number.
#ifndef BALLOON_SCENE_SCENE_RANGE_H
#define BALLOON_SCENE_SCENE_RANGE_H

#include <stdbool.h>

typedef struct Range {
    const char* path; ///< of a key, with * for each number of an item: "balloons.*.scale"
    double least;
    double most;     ///< INFINITY: no upper end
    bool least_open; ///< greater than `least`, not equal to it
} Range;

extern const Range range_table[];
extern const int range_count;

/// The row of a number by its path, "balloons.0.scale", or NULL.
const Range* range_find(const char* path);

bool range_holds(const Range* range, double value);

/// "greater than 0 and at most 1", for a sentence.
void range_words(const Range* range, char words[96]);

#endif
