/// A world in play: its steps, the events that a log replays, and the log of what is done to it.
///
/// An event is applied before the step whose number it bears, and a log holds the events in the
/// order in which they were applied: replaying it gives the same bits.
#ifndef BALLOON_SHOW_SESSION_H
#define BALLOON_SHOW_SESSION_H

#include "show/ghost.h"

typedef struct Session {
    World* world;       ///< the caller's
    Ghost* ghost;       ///< the caller's second copy, which gets the same input; NULL: none
    Record replay;      ///< events that are still to come
    Record made;        ///< events that were applied
    const char* record; ///< name of the log to be written; NULL: none
    FILE* log;
    int scenes; ///< scenes that have been on, the present one included
} Session;

/// input: log to be replayed; record: log to be written; each NULL for none.
bool session_open(Session* session, World* world, const char* input, const char* record,
                  Fault* fault);

/// From now on a ghost gets what the world gets. It begins as the world does.
void session_compare(Session* session, Ghost* ghost);

/// A key of command_table goes down or up now.
bool session_key(Session* session, int row, bool down, Fault* fault);

/// A ball is thrown now: position, velocity, mass, radius (world/record.h), in world units.
bool session_throw(Session* session, const double thrown[THROW_NUMBERS], Fault* fault);

/// Apply the replayed events that are due, then one step.
bool session_step(Session* session, Fault* fault);

/// `next` takes the place of the world, which is closed: no more replay, and a new log, record.2,
/// record.3, … how: a line for it that says how the scene was loaded; NULL: as it is.
bool session_change(Session* session, World* next, const char* how, Fault* fault);

/// Ends the log with the count of steps and the state's hash.
void session_close(Session* session);

#endif
