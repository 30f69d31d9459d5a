/// A session: a world, the events of an input log that it replays, and the log of its own events.
///
/// An event is applied before the step of its number, and a log has the events in the order in which
/// they were applied, so replaying it gives the same bits.
#ifndef BALLOON_SHOW_SESSION_H
#define BALLOON_SHOW_SESSION_H

#include "show/ghost.h"

typedef struct Session {
    World* world;       ///< owned by the caller
    Ghost* ghost;       ///< owned by the caller, gets the same input; NULL: none
    Record replay;      ///< events to be replayed
    Record made;        ///< events that were applied
    const char* record; ///< name of the log to be written; NULL: none
    FILE* log;
    int scenes; ///< number of scenes so far, with the present one
} Session;

/// input: log to be replayed, or NULL; record: log to be written, or NULL.
bool session_open(Session* session, World* world, const char* input, const char* record,
                  Fault* fault);

/// Step a ghost with the same input from now on; its state is the world's, or NULL for none.
void session_compare(Session* session, Ghost* ghost);

/// Apply the press or release of the key in a row of command_table.
bool session_key(Session* session, int row, bool down, Fault* fault);

/// Throw a ball: position, velocity, mass, radius (world/record.h), in world units.
bool session_throw(Session* session, const double thrown[THROW_NUMBERS], Fault* fault);

/// Apply the replayed events that are due, then one step.
bool session_step(Session* session, Fault* fault);

/// Close the world and move `next` into it. Replay ends, and a new log begins: record.2, record.3, …
/// how: a comment for that log that names the scene's overrides, or NULL.
bool session_change(Session* session, World* next, const char* how, Fault* fault);

/// End the log with the number of steps and the hash of the state. False if the log could not be
/// written to its end.
bool session_close(Session* session, Fault* fault);

#endif
