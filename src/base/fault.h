/// One sentence about bad input, with its location: the second of three kinds of failure.
///
///   * a bug                         ASSERT, which prints the condition and a sentence and aborts
///   * a bad file, argument, display a Fault: the function returns false, main prints it once
///   * a state that blows up         found at its step (world/guard/blowup.h)
#ifndef BALLOON_BASE_FAULT_H
#define BALLOON_BASE_FAULT_H

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct Fault {
    char location[512]; ///< "squirrel.obj:12", or what the user typed; "" where there is none
    char text[1024];    ///< what is wrong and what to do, without a full stop
} Fault;

/// Fill the fault and return false, so that `return fault_set(…)` ends a function that failed.
/// `location` may be NULL. A fault that is already set is kept: the first one is the cause.
bool fault_set(Fault* fault, const char* location, const char* format, ...)
    __attribute__((format(printf, 3, 4)));

/// The same with a line number: the location becomes "file:line".
bool fault_at(Fault* fault, const char* file, long line, const char* format, ...)
    __attribute__((format(printf, 4, 5)));

/// Print "balloon: location: text" as one line.
void fault_print(const Fault* fault, FILE* out);

#ifdef __cplusplus
}
#endif

#define ASSERT(condition, sentence)                                                                \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "%s:%d: %s does not hold: %s\n", __FILE__, __LINE__, #condition,       \
                    sentence);                                                                     \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

#endif
