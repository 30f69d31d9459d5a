/// A text taken line by line, in place: the end of the line at hand is a zero.
#ifndef BALLOON_MESH_LINES_H
#define BALLOON_MESH_LINES_H

#include <stdbool.h>

typedef struct Lines {
    char* at;    ///< where reading stands in the line
    char* stop;  ///< the line's end
    char* next;  ///< the next line
    char* end;   ///< the text's end, where a zero stands
    long number; ///< of the line at hand, from 1
    long taken;  ///< lines so far, those that continue it included
} Lines;

/// Go on to the first word of the next line; false at the end of the text.
bool lines_take(Lines* lines);

/// Leave the comment out, and append the lines that a backslash at the end calls for.
void lines_complete(Lines* lines);

/// Go on to the next word; false at the end of the line.
bool lines_word(Lines* lines);

/// How many characters of the word at `at` a sentence shows.
int word_shown(const char* at);

static inline bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

static inline bool ends_word(char c) {
    return c == '\0' || is_blank(c);
}

#endif
