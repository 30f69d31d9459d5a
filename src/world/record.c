#include "world/record.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/input_file.h"
#include "base/table.h"
#include "base/memory.h"
#include "world/command.h"
#include "world/world.h"

enum {
    VERSION = 1,          ///< of the log's format
    LINE_MAX_BYTES = 512, ///< longest line; that of an event has at most 250
    STEP_DIGITS = 18,     ///< more may not fit a long
};
static const char title[] = RECORD_MARK;

/// Where a log is being read, for faults.
typedef struct Line {
    const char* file;
    long number;
    Fault* fault;
} Line;

/// A kind of event: its word, and the format of its line.
typedef struct Kind {
    const char* name;
    const char* form;
    bool (*parse)(const char* words, Event* event); ///< false if the words are not in this format
    bool (*validate)(const Event* event, const Line* line);
} Kind;

static bool validate_key(const Event* event, const Line* line) {
    if (strcmp(event->value, "down") != 0 && strcmp(event->value, "up") != 0)
        return fault_at(line->fault, line->file, line->number,
                        "a key goes down or up, and not '%s'", event->value);
    if (command_find(event->name) >= 0)
        return true;

    char names[256];
    table_names_of(command_table, command_count, sizeof *command_table, names, sizeof names);
    return fault_at(line->fault, line->file, line->number, "no key '%s'; there are %s", event->name,
                    names);
}

static bool validate_set(const Event* event, const Line* line) {
    (void)event;
    (void)line;
    return true; // world_event_check knows what may be set while a world runs
}

static bool validate_throw(const Event* event, const Line* line) {
    for (int i = 0; i < THROW_NUMBERS; i++)
        if (!real_holds(event->thrown[i]) || (i >= 6 && event->thrown[i] <= 0))
            return fault_at(line->fault, line->file, line->number,
                            "a throw has numbers that a state of " REAL_NAME
                            " holds, and a mass and a radius above 0");
    return true;
}

// Split "NAME VALUE"; the value is the rest of the line. False if one is missing or too long.
static bool parse_pair(const char* words, Event* event) {
    const size_t name = strcspn(words, " ");
    if (name == 0 || name >= sizeof event->name || words[name] != ' ')
        return false;
    const char* value = words + name + 1;
    if (!value[0] || strlen(value) >= sizeof event->value)
        return false;
    memcpy(event->name, words, name);
    memcpy(event->value, value, strlen(value));
    return true;
}

static bool parse_throw(const char* words, Event* event) {
    for (int i = 0; i < THROW_NUMBERS; i++) {
        char* end;
        event->thrown[i] = strtod(words, &end);
        if (end == words || *end != (i + 1 < THROW_NUMBERS ? ' ' : '\0'))
            return false;
        words = end + 1;
    }
    return true;
}

static const Kind kind_table[] = {
    [EVENT_KEY] = {"key", "STEP key NAME down|up", parse_pair, validate_key},
    [EVENT_SET] = {"set", "STEP set KEY VALUE", parse_pair, validate_set},
    [EVENT_THROW] = {"throw", "STEP throw x y z vx vy vz mass radius", parse_throw, validate_throw},
};
enum { KINDS = sizeof kind_table / sizeof kind_table[0] };

static bool kind_fault(const Line* line, const char* word, size_t length) {
    char names[128];
    table_names_of(kind_table, KINDS, sizeof *kind_table, names, sizeof names);
    return fault_at(line->fault, line->file, line->number, "no event '%.*s'; there are %s",
                    (int)length, word, names);
}

static int find_kind(const char* word, size_t length) {
    for (int i = 0; i < KINDS; i++)
        if (strlen(kind_table[i].name) == length && memcmp(kind_table[i].name, word, length) == 0)
            return i;
    return KINDS;
}

// One line without its end: STEP KIND NAME VALUE, single spaces between them.
static bool read_event(const char* text, Event* event, const Line* line) {
    *event = (Event){.line = line->number};
    const size_t digits = strspn(text, "0123456789");
    if (digits == 0 || digits > STEP_DIGITS || text[digits] != ' ')
        return fault_at(line->fault, line->file, line->number,
                        "an event begins with the number of its step, as in 12 key inflate down");
    event->step = strtol(text, NULL, 10);

    const char* word = text + digits + 1;
    const size_t length = strcspn(word, " ");
    const int kind = find_kind(word, length);
    if (kind == KINDS)
        return kind_fault(line, word, length);
    event->kind = (EventKind)kind;
    if (word[length] != ' ' || !kind_table[kind].parse(word + length + 1, event))
        return fault_at(line->fault, line->file, line->number, "this is not %s",
                        kind_table[kind].form);
    return kind_table[kind].validate(event, line);
}

// The first line names the format and its version.
static bool validate_title(const char* text, const Line* line) {
    const size_t length = strlen(title);
    if (strncmp(text, title, length) == 0 && strtol(text + length, NULL, 10) == VERSION)
        return true;
    return fault_at(line->fault, line->file, line->number, "an input log begins with '%s%d SCENE'",
                    title, VERSION);
}

// Remove the end of a line. False where there is none: the line is too long, or has a zero byte.
static bool cut_end(char* text, bool last) {
    const size_t length = strlen(text);
    const bool ended = length > 0 && text[length - 1] == '\n';
    if (ended)
        text[length - 1] = '\0';
    return ended || (last && length < LINE_MAX_BYTES - 1);
}

static bool read_line(char* text, bool last, Record* record, const Line* line) {
    if (!cut_end(text, last))
        return fault_at(line->fault, line->file, line->number,
                        "this is no line of an input log: it is too long, or not text");
    if (line->number == 1)
        return validate_title(text, line);
    if (text[0] == '#' || text[0] == '\0')
        return true;

    Event event;
    if (!read_event(text, &event, line))
        return false;
    const long before = record->count ? record->event[record->count - 1].step : 0;
    if (event.step < before)
        return fault_at(line->fault, line->file, line->number,
                        "step %ld comes after step %ld: steps do not run backwards", event.step,
                        before);
    record_add(record, &event, NULL);
    return true;
}

static bool read_all(FILE* in, Record* record, Line* line) {
    char text[LINE_MAX_BYTES];
    while (fgets(text, sizeof text, in)) {
        line->number++;
        if (!read_line(text, feof(in), record, line))
            return false;
    }
    if (ferror(in))
        return fault_set(line->fault, line->file, "it cannot be read: %s", strerror(errno));
    return line->number > 0 || fault_set(line->fault, line->file, "this input log is empty");
}

bool record_load(const char* file, Record* record, Fault* fault) {
    *record = (Record){0};
    FILE* in = input_file_open(file, fault);
    if (!in)
        return false;

    Line line = {.file = file, .fault = fault};
    const bool good = read_all(in, record, &line);
    fclose(in);
    if (!good)
        record_free(record);
    return good;
}

bool record_check(const Record* record, const char* file, const World* world, Fault* fault) {
    for (int k = 0; k < record->count; k++) {
        Fault found = {0};
        if (!world_event_check(world, &record->event[k], &found))
            return fault_at(fault, file, record->event[k].line, "%s: %s", found.location,
                            found.text);
    }
    return true;
}

void record_reference(FILE* out) {
    fprintf(out, "\n### Input log\n\n    %s%d SCENE\n", title, VERSION);
    for (int k = 0; k < KINDS; k++)
        fprintf(out, "    %s\n", kind_table[k].form);
    fputs("\nThe first line is always there; further lines that begin with `#` and empty ones are\n"
          "skipped. STEP is the number of steps since the session began, which a reset does not\n"
          "set back; an event happens before that step, and steps never decrease. Keys act on the\n"
          "selected balloon, or on all. A ball is thrown with its position [m], velocity [m/s],\n"
          "mass [kg] and radius [m].\n",
          out);
    command_reference(out);
}

void record_title(const char* scene, FILE* log) {
    fprintf(log, "%s%d %s\n", title, VERSION, scene);
}

void record_add(Record* record, const Event* event, FILE* log) {
    array_reserve(record->event, record->count, record->capacity);
    record->event[record->count++] = *event;
    if (!log)
        return;
    fprintf(log, "%ld %s", event->step, kind_table[event->kind].name);
    if (event->kind == EVENT_THROW)
        for (int i = 0; i < THROW_NUMBERS; i++)
            fprintf(log, " %.17g", event->thrown[i]);
    else
        fprintf(log, " %s %s", event->name, event->value);
    fputc('\n', log);
}

const Event* record_due(Record* record, long step) {
    if (record->next >= record->count || record->event[record->next].step > step)
        return NULL;
    return &record->event[record->next++];
}

void record_free(Record* record) {
    free(record->event);
    *record = (Record){0};
}
