/// Memory that the system does not give.
#ifndef BALLOON_BASE_MEMORY_MISSING_H
#define BALLOON_BASE_MEMORY_MISSING_H

#ifdef __cplusplus
extern "C" {
#endif

/// End the program with a sentence and exit status 1. what: as in "an array".
void memory_missing(const char* what) __attribute__((noreturn));

/// From now on C++'s operator new ends the program so too, in libraries as well.
void memory_missing_in_new(void);

#ifdef __cplusplus
}
#endif

#endif
