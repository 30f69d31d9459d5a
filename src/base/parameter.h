/// A number that a scene may give: what a row of a table (a scene key, a force, a material) says of
/// each of its parameters. The scene reader, the range check, the help and the scene reference walk
/// these rows.
#ifndef BALLOON_BASE_PARAMETER_H
#define BALLOON_BASE_PARAMETER_H

#include <stdbool.h>

typedef struct Parameter {
    const char* name;     ///< the key
    const char* unit;     ///< in SI, "N/m"; "1" where it has no dimension
    double min, max;      ///< range; -INFINITY and INFINITY: no end
    bool min_open;        ///< greater than `min`, not equal to it
    bool max_open;        ///< less than `max`, not equal to it
    bool per_particle;    ///< of each particle: half as much on a mesh of twice as many
    double default_value; ///< of a scene that does not give it
    const char* about;    ///< one sentence
} Parameter;

#endif
