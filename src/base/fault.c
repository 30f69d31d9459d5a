#include "base/fault.h"

#include <stdarg.h>

static bool fill(Fault* fault, const char* format, va_list arguments) {
    vsnprintf(fault->text, sizeof fault->text, format, arguments);

    // one sentence is one line, whatever a file name or a library put into it
    for (char* c = fault->text; *c; c++)
        if (*c == '\n' || *c == '\r')
            *c = ' ';
    return false;
}

bool fault_set(Fault* fault, const char* location, const char* format, ...) {
    if (fault->text[0])
        return false;
    snprintf(fault->location, sizeof fault->location, "%s", location ? location : "");

    va_list arguments;
    va_start(arguments, format);
    fill(fault, format, arguments);
    va_end(arguments);
    return false;
}

bool fault_at(Fault* fault, const char* file, long line, const char* format, ...) {
    if (fault->text[0])
        return false;
    snprintf(fault->location, sizeof fault->location, "%s:%ld", file, line);

    va_list arguments;
    va_start(arguments, format);
    fill(fault, format, arguments);
    va_end(arguments);
    return false;
}

void fault_print(const Fault* fault, FILE* out) {
    fprintf(out, "balloon: %s%s%s\n", fault->location, fault->location[0] ? ": " : "", fault->text);
}
