/// A text read line by line, in place: a zero ends the current line.
#ifndef BALLOON_MESH_LINES_H
#define BALLOON_MESH_LINES_H

#include <stdbool.h>

typedef struct Lines {
    char* at;    ///< the next character to read
    char* stop;  ///< end of the current line
    char* next;  ///< start of the next line
    char* end;   ///< end of the text, which is a zero
    long number; ///< of the current line, from 1
    long read;   ///< number of lines read, including continuation lines
} Lines;

/// Go on to the first word of the next line; false at the end of the text.
bool lines_next(Lines* lines);

/// Cut off a comment, and append the following line after a backslash at the end.
void lines_complete(Lines* lines);

/// Go on to the next word; false at the end of the line.
bool lines_word(Lines* lines);

/// Length of the word at `at`, limited to what a message quotes.
int word_shown(const char* at);

static inline bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

static inline bool ends_word(char c) {
    return c == '\0' || is_blank(c);
}

#endif
