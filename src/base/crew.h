/// A few threads that share the parts of a loop. Who waits for longer than a moment sleeps.
///
/// A part's work and result depend on nothing but its number, and whoever sums results up does so
/// in the order of the parts: the same bits for any number of threads. One thread by default, which
/// then runs all parts itself.
#ifndef BALLOON_BASE_CREW_H
#define BALLOON_BASE_CREW_H

enum { CREW_MOST = 64 };

/// From now on `threads` share the work, the caller's one of them; 1 sends the others home.
void crew_set(int threads);

/// How many they are.
int crew_threads(void);

/// Call part(self, 0) … part(self, parts - 1), each thread a range of them in order; back when all
/// are done. A part that calls this itself runs its own parts alone.
void crew_run(void (*part)(void* self, int number), void* self, int parts);

#endif
