/// Runs of a program, in parallel or one at a time, with their output and exit status.
///
/// The lab measures runs of the program itself: each is a command line that anyone can repeat, and a
/// crash does not affect the others. Every run has a limit of CPU time, of wall time if
/// one is set, and of memory; it ends with the process that started it.
#ifndef BALLOON_LAB_RUN_LAUNCH_H
#define BALLOON_LAB_RUN_LAUNCH_H

#include <sys/types.h>

#include "base/fault.h"

enum { LAUNCH_WORDS = 96 };                  ///< of a command line, at most
extern const double LAUNCH_CPU_MAX;          ///< CPU time of a run without a limit of its own [s]
extern const unsigned long LAUNCH_BYTES_MAX; ///< address space of a run [bytes]

typedef struct Launch {
    char* word[LAUNCH_WORDS + 1]; ///< program and arguments, then NULL; owned
    int words;
    double cpu_ask;      ///< CPU time after which SIGTERM asks it to end [s]; 0: never
    double cpu_max;      ///< CPU time after which the run is ended [s]; 0: the default
    double wall_max;     ///< time after which it is ended [s]; 0: none
    unsigned long bytes; ///< address space [bytes]; 0: the default
    int status;          ///< as waitpid() has it
    char* out;           ///< all that it printed on standard output; owned
    char* err;           ///< and on standard error; owned

    // while it runs
    pid_t process; ///< 0: it does not run
    bool asked;    ///< to end
    double start;  ///< of the clock that is monotonic [s]
    FILE* out_file;
    FILE* err_file;
} Launch;

/// Add a word to a command line, as printf has it.
void launch_add(Launch* launch, const char* format, ...) __attribute__((format(printf, 2, 3)));

/// The same words in the same order.
bool launch_same(const Launch* a, const Launch* b);

/// Start the run; its earlier output is forgotten. False where the program cannot be started.
bool launch_begin(Launch* launch, Fault* fault);

/// Whether a run that was started has ended; then its status and output are there. Returns at once.
bool launch_has_ended(Launch* launch);

/// Run all of them, at most `parallel` at a time; their earlier output is freed. On a terminal, print
/// the title, if there is one, and the number done. Returns false only if a program could not be
/// started.
bool launch_all(Launch* launch, int count, int parallel, const char* title, Fault* fault);

/// A run that goes on is ended.
void launch_free(Launch* launch);

#endif
