/// Runs of a program, side by side or one at a time: what each printed, and how it ended.
///
/// What the lab measures are runs of the program itself: each is one command line that anyone can
/// repeat, and one that crashes costs no other.
#ifndef BALLOON_LAB_RUN_LAUNCH_H
#define BALLOON_LAB_RUN_LAUNCH_H

#include "base/fault.h"

enum { LAUNCH_WORDS = 96 }; ///< of a command line, at most

typedef struct Launch {
    char* word[LAUNCH_WORDS + 1]; ///< program and arguments, then NULL; owned
    int words;
    int status; ///< as waitpid() has it
    char* out;  ///< all that it printed on standard output; owned
    char* err;  ///< and on standard error; owned
} Launch;

/// Add a word to a command line, as printf has it.
void launch_add(Launch* launch, const char* format, ...) __attribute__((format(printf, 2, 3)));

/// The same words in the same order.
bool launch_same(const Launch* a, const Launch* b);

/// Run all of them, so many side by side; each one's earlier output is forgotten. On a terminal
/// `what` and how many are done are said. False only where a program could not be started.
bool launch_all(Launch* launch, int count, int side_by_side, const char* what, Fault* fault);

void launch_free(Launch* launch);

#endif
