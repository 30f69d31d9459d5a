/// The input log: all events of the user, one a line, in world units, each with the number of the
/// step before which it happens. Replaying a log gives the same bits.
///
///     # balloon input 1 SCENE
///     STEP key NAME down|up
///     STEP set KEY VALUE
///     STEP throw x y z vx vy vz mass radius
///
/// STEP counts calls of world_step since world_open; a reset does not set it back.
/// Keys act on the selected balloon, or on all if none is selected.
/// The first line is always there; further lines that begin with # and empty ones are skipped.
/// A VALUE is the rest of its line.
#ifndef BALLOON_WORLD_RECORD_H
#define BALLOON_WORLD_RECORD_H

#include <stdio.h>

#include "base/fault.h"

/// How a log begins.
#define RECORD_MARK "# balloon input "

typedef enum EventKind { EVENT_KEY, EVENT_SET, EVENT_THROW } EventKind;

enum { THROW_NUMBERS = 8 };

typedef struct Event {
    long step;
    EventKind kind;
    char name[64];  ///< key: a row of the command table (world/command.h); set: the scene's key
    char value[64]; ///< key: "down" or "up"; set: the value
    double thrown[THROW_NUMBERS]; ///< throw: position, velocity, mass, radius
    long line;                    ///< of the log that it was read from; 0: of none
} Event;

typedef struct World World;

typedef struct Record {
    int count;
    int capacity;
    Event* event; ///< [capacity] in order of step
    int next;     ///< the first event that has not been replayed
} Record;

/// Read a log. A line that cannot be understood, a key that is not in the command table, or steps
/// that run backwards are faults with line.
bool record_load(const char* file, Record* record, Fault* fault);

/// Whether a world can apply all events of a log: a line that it cannot is found before the run.
bool record_check(const Record* record, const char* file, const World* world, Fault* fault);

/// The form of a log as Markdown: its lines, the names of its keys, and what it may set.
void record_reference(FILE* out);

/// Write a log's first line.
void record_title(const char* scene, FILE* log);

/// Append to the record, and to `log` if it is not NULL.
void record_add(Record* record, const Event* event, FILE* log);

/// The next event due at or before `step`, or NULL.
const Event* record_due(Record* record, long step);

void record_free(Record* record);

#endif
