/// A number that a scene may give: what a row of a table (a scene key, a force, a material) says of
/// each of its parameters. The reader, range check, help and scene reference walk these.
#ifndef BALLOON_BASE_PARAMETER_H
#define BALLOON_BASE_PARAMETER_H

#include <stdbool.h>

typedef struct Parameter {
    const char* name;  ///< the key
    const char* unit;  ///< in SI, "N/m"; "1" where it has no dimension
    double least;      ///< range
    double most;       ///< INFINITY: no upper end
    bool least_open;   ///< greater than `least`, not equal to it
    double usual;      ///< default
    const char* about; ///< one sentence
} Parameter;

#endif
