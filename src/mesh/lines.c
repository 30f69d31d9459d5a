#include "mesh/lines.h"

#include <string.h>

enum { WORD_SHOWN = 24 };

/// Cut the next line out of the text: its end becomes a zero.
static void cut(Lines* lines) {
    char* newline = memchr(lines->next, '\n', (size_t)(lines->end - lines->next));
    lines->stop = newline ? newline : lines->end;
    lines->next = newline ? newline + 1 : lines->end;
    *lines->stop = '\0';
    lines->taken++;
}

bool lines_take(Lines* lines) {
    if (lines->next == lines->end)
        return false;
    lines->at = lines->next;
    lines->number = lines->taken + 1;
    cut(lines);
    lines_word(lines);
    return true;
}

void lines_complete(Lines* lines) {
    for (;;) {
        // a backslash in a comment continues nothing: it may be the end of a folder's name
        char* comment = memchr(lines->at, '#', (size_t)(lines->stop - lines->at));
        if (comment) {
            *comment = '\0';
            return;
        }
        char* last = lines->stop;
        while (last > lines->at && is_blank(last[-1]))
            last--;
        if (last == lines->at || last[-1] != '\\')
            return;
        last[-1] = ' ';
        if (lines->next == lines->end)
            return;
        *lines->stop = ' ';
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
    while (n < WORD_SHOWN && !ends_word(at[n]))
        n++;
    return n;
}
