/// Runs of a program, in parallel or one at a time, with their output and exit status.
///
/// The lab measures runs of the program itself: each is a command line that anyone can repeat, and
/// a crash does not affect the others. Every run has a limit of CPU time, of wall time if one is
/// set, and of memory; it ends with the process that started it.
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
    double cpu_ask;      ///< CPU time after which SIGTERM asks the run to end [s]; 0: never
    double cpu_max;      ///< CPU time after which the run is killed [s]; 0: the default
    double wall_max;     ///< wall time after which the run is killed [s]; 0: no limit
    unsigned long bytes; ///< limit of the address space [bytes]; 0: the default
    int status;          ///< the status that waitpid() returned
    char* out;           ///< its standard output; owned
    char* err;           ///< its standard error; owned

    // during the run
    pid_t process;      ///< 0: not running
    bool end_requested; ///< SIGTERM was sent
    double start;       ///< monotonic clock at the start [s]
    FILE* out_file;
    FILE* err_file;
} Launch;

/// Add a word to a command line, formatted like printf.
void launch_add(Launch* launch, const char* format, ...) __attribute__((format(printf, 2, 3)));

/// Whether two command lines have the same words in the same order.
bool launch_same(const Launch* a, const Launch* b);

/// Start the run; earlier output is freed. False if the program cannot be started.
bool launch_begin(Launch* launch, Fault* fault);

/// Whether a run that was started has ended; then its status and output are set. Does not wait.
bool launch_has_ended(Launch* launch);

/// Run all of them, at most `parallel` at a time; their earlier output is freed. On a terminal,
/// print the title, if there is one, and the number done. Returns false only if a program could not
/// be started.
bool launch_all(Launch* launch, int count, int parallel, const char* title, Fault* fault);

/// Frees a launch; a run that has not ended is killed.
void launch_free(Launch* launch);

#endif
