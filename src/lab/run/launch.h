/// Runs of a program, in parallel or one at a time, with their output and exit status.
///
/// The lab measures runs of the program itself: each is a command line that anyone can repeat, and a
/// crash does not affect the others.
#ifndef BALLOON_LAB_RUN_LAUNCH_H
#define BALLOON_LAB_RUN_LAUNCH_H

#include "base/fault.h"

enum { LAUNCH_WORDS = 96 }; ///< maximum number of words of a command line

typedef struct Launch {
    char* word[LAUNCH_WORDS + 1]; ///< program and arguments, then NULL; owned
    int words;
    int status; ///< of waitpid()
    char* out;  ///< text of its standard output; owned
    char* err;  ///< text of its standard error; owned
} Launch;

/// Add a word to a command line, formatted like printf.
void launch_add(Launch* launch, const char* format, ...) __attribute__((format(printf, 2, 3)));

/// The same words in the same order.
bool launch_same(const Launch* a, const Launch* b);

/// Run all of them, at most `parallel` at a time; their earlier output is freed. On a terminal, print
/// the title and the number done. Returns false only if a program could not be started.
bool launch_all(Launch* launch, int count, int parallel, const char* title, Fault* fault);

void launch_free(Launch* launch);

#endif
