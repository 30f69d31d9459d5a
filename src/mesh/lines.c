#include "mesh/lines.h"

#include <string.h>

enum { WORD_CHARS_SHOWN = 24 };

/// Cut the next line out of the text: its end becomes a zero.
static void cut(Lines* lines) {
    char* newline = memchr(lines->next, '\n', (size_t)(lines->end - lines->next));
    lines->stop = newline ? newline : lines->end;
    lines->next = newline ? newline + 1 : lines->end;
    *lines->stop = '\0';
    lines->read++;
}

bool lines_next(Lines* lines) {
    if (lines->next == lines->end)
        return false;
    lines->at = lines->next;
    lines->number = lines->read + 1;
    cut(lines);
    lines_word(lines);
    return true;
}

void lines_complete(Lines* lines) {
    // only the part that was appended last is searched, so that time is linear in the text
    char* part = lines->at;
    for (;;) {
        // a backslash in a comment continues nothing: it may be the end of a folder's name
        char* comment = memchr(part, '#', (size_t)(lines->stop - part));
        if (comment) {
            *comment = '\0';
            return;
        }
        char* last = lines->stop;
        while (last > part && is_blank(last[-1]))
            last--;
        if (last == part || last[-1] != '\\')
            return;
        last[-1] = ' ';
        if (lines->next == lines->end)
            return;
        *lines->stop = ' ';
        part = lines->next;
        cut(lines);
    }
}

bool lines_word(Lines* lines) {
    while (is_blank(*lines->at))
        lines->at++;
    return *lines->at != '\0';
}

int word_shown(const char* at) {
    int n = 0;
    while (n < WORD_CHARS_SHOWN && !ends_word(at[n]))
        n++;
    return n;
}
