/// Outputs: a table, one row for each named number of the state.
///
/// The CSV's header, an `about:` of a scene and the scene reference walk it. The
/// order of the rows of a kind is that of the columns.
#ifndef BALLOON_WORLD_OUTPUTS_H
#define BALLOON_WORLD_OUTPUTS_H

#include <stdio.h>

#include "world/world.h"

/// The subject of a row: the time, each balloon, each string of a balloon, each ball, all balls
/// together, the floor, each wall, each thing, each knot, all skins together, or the guard of the step.
typedef enum OutputKind {
    OF_TIME,
    OF_BALLOON,
    OF_STRING,
    OF_SPHERE,
    OF_SPHERES,
    OF_FLOOR,
    OF_WALL,
    OF_THING,
    OF_KNOT,
    OF_SKINS,
    OF_GUARD,
    OUTPUT_KINDS
} OutputKind;

/// Before the column's name, "balloonN.stringK." with the numbers N and K.
extern const char* const output_prefix[OUTPUT_KINDS];

/// One thing that has outputs.
typedef struct OutputSubject {
    const World* world;
    const Balloon* balloon; ///< for OF_BALLOON and OF_STRING
    int number;             ///< number of the string, ball, plane, thing or knot
} OutputSubject;

typedef struct Output {
    const char* column; ///< "volume"
    const char* unit;   ///< "1" where there is none
    const char* about;  ///< a phrase, for help and reference
    OutputKind kind;
    bool (*present)(const Balloon* balloon); ///< NULL: every balloon has it
    double (*of_balloon)(const Balloon* balloon);
    double (*value)(const OutputSubject* subject); ///< for kinds other than OF_BALLOON
} Output;

extern const Output output_table[];
extern const int output_count;

/// The outputs as a Markdown table, in the order of the CSV's columns.
void outputs_reference(FILE* out);

double output_value(const Output* output, const OutputSubject* subject);

#endif
