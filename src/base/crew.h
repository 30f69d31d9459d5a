/// The thread pool: a few threads that share the tasks of a loop.
///
/// The work and result of a task depend on nothing but its number, and results are summed in the
/// order of the tasks: the same bits for any number of threads. One thread by default, the caller,
/// which then runs all tasks itself. A thread that waits for longer than some 20 us sleeps.
///
/// OpenMP's `parallel for schedule(static)` would split loops alike, without the structs of arguments
/// that tasks need here. It is not used because clang needs one more package (libomp-dev), and because
/// the thread sanitizer does not understand gcc's libgomp: it reports a data race in a loop over an
/// array of integers that is correct. `make check` holds this pool to that sanitizer.
#ifndef BALLOON_BASE_CREW_H
#define BALLOON_BASE_CREW_H

enum { CREW_THREADS_MAX = 64 };

/// From now on `threads` threads share the work, the caller's included; 1 ends all others.
void crew_set(int threads);

/// Their number.
int crew_threads(void);

/// Call task(self, 0) … task(self, tasks - 1), and return when all are done. Each thread runs a
/// contiguous range in ascending order. A task that calls crew_run itself runs those tasks alone.
void crew_run(void (*task)(void* self, int number), void* self, int tasks);

#endif
