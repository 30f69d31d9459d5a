/// Memory that the system does not give.
#ifndef BALLOON_BASE_MEMORY_MISSING_H
#define BALLOON_BASE_MEMORY_MISSING_H

#include <stddef.h>

/// End the program with a sentence and exit status 1. what: as in "an array".
_Noreturn void memory_missing(const char* what);

#endif
