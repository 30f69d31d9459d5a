/// A text read line by line, in place: a zero ends the current line.
#ifndef BALLOON_MESH_LINES_H
#define BALLOON_MESH_LINES_H

#include <stdbool.h>

typedef struct Lines {
    char* at;    ///< the next character to read
    char* stop;  ///< end of the current line
    char* next;  ///< start of the next line
    char* end;   ///< end of the text, where a zero stands
    long number; ///< of the current line, from 1
    long read;   ///< lines so far, those included that continue another
} Lines;

/// Go on to the first word of the next line; false at the end of the text.
bool lines_next(Lines* lines);

/// Cut off a comment, and append the lines that a backslash at the end asks for.
void lines_complete(Lines* lines);

/// Go on to the next word; false at the end of the line.
bool lines_word(Lines* lines);

/// Length of the word at `at`, at most as much as a sentence shows.
int word_shown(const char* at);

static inline bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

static inline bool ends_word(char c) {
    return c == '\0' || is_blank(c);
}

#endif
