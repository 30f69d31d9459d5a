#include "show/session.h"

#include <errno.h>
#include <string.h>

#include "base/stream.h"
#include "world/command.h"

/// The present scene's log: record, record.2, record.3, …
static void log_name(const Session* session, char file[1024]) {
    if (session->scenes == 1)
        snprintf(file, 1024, "%s", session->record);
    else
        snprintf(file, 1024, "%s.%d", session->record, session->scenes);
}

static bool end_log(Session* session, Fault* fault) {
    if (!session->log)
        return true;
    char file[1024];
    log_name(session, file);
    fprintf(session->log, "# %ld steps of %.17g s, hash %016llx\n", session->world->clock,
            session->world->step, (unsigned long long)world_hash(session->world));
    FILE* log = session->log;
    session->log = NULL;
    return stream_close(log, file, fault);
}

static bool begin_log(Session* session, Fault* fault) {
    session->scenes++;
    if (!session->record)
        return true;
    char file[1024];
    log_name(session, file);
    session->log = fopen(file, "w");
    if (!session->log)
        return fault_set(fault, file, "this input log cannot be written: %s", strerror(errno));

    // line buffered, so that after a crash the log is complete
    setvbuf(session->log, NULL, _IOLBF, BUFSIZ);
    record_title(session->world->def.file, session->log);
    if (!ferror(session->log))
        return true;
    fault_set(fault, file, "this input log cannot be written: %s", strerror(errno));
    return end_log(session, fault);
}

bool session_close(Session* session, Fault* fault) {
    const bool whole = end_log(session, fault);
    record_free(&session->replay);
    record_free(&session->made);
    return whole;
}

bool session_open(Session* session, World* world, const char* input, const char* record,
                  Fault* fault) {
    *session = (Session){.world = world, .record = record};
    if ((!input || (record_load(input, &session->replay, fault) &&
                    record_check(&session->replay, input, world, fault))) &&
        begin_log(session, fault))
        return true;
    session_close(session, fault);
    return false;
}

void session_compare(Session* session, Ghost* ghost) {
    session->ghost = ghost;
}

static bool apply(Session* session, const Event* event, Fault* fault) {
    if (!world_event(session->world, event, fault) ||
        (session->ghost && !world_event(&session->ghost->world, event, fault)))
        return false;
    record_add(&session->made, event, session->log);
    return true;
}

bool session_key(Session* session, int row, bool down, Fault* fault) {
    Event event = {.step = session->world->clock, .kind = EVENT_KEY};
    snprintf(event.name, sizeof event.name, "%s", command_table[row].name);
    snprintf(event.value, sizeof event.value, "%s", down ? "down" : "up");
    return apply(session, &event, fault);
}

bool session_throw(Session* session, const double thrown[THROW_NUMBERS], Fault* fault) {
    Event event = {.step = session->world->clock, .kind = EVENT_THROW};
    memcpy(event.thrown, thrown, sizeof event.thrown);
    return apply(session, &event, fault);
}

bool session_step(Session* session, Fault* fault) {
    const Event* due;
    while ((due = record_due(&session->replay, session->world->clock)))
        if (!apply(session, due, fault))
            return false;
    if (session->ghost)
        ghost_step(session->ghost, session->world);
    else
        world_step(session->world);
    return true;
}

bool session_change(Session* session, World* next, const char* how, Fault* fault) {
    const bool whole = session_close(session, fault);
    world_close(session->world);
    *session->world = *next;
    *next = (World){0};
    if (!begin_log(session, fault))
        return false;
    if (session->log && how)
        fprintf(session->log, "# %s\n", how);
    return whole;
}
