#include "base/crew.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>

/// How often a thread looks for what it waits for before it sleeps: some 20 us, which is longer
/// than the loops of one step are apart, and far shorter than a frame.
enum { LOOKS = 2000 };

typedef struct Crew {
    pthread_mutex_t lock; ///< for who sleeps
    pthread_cond_t begin, end;
    pthread_t thread[CREW_MOST];
    int number[CREW_MOST]; ///< of each thread, for itself
    int threads;           ///< with the caller's, which is number 0
    bool home;             ///< all are to end
    atomic_long job;       ///< number of the present one: a thread waits for one it has not seen
    atomic_int working;    ///< threads that have not finished it
    void (*part)(void* self, int number);
    void* self;
    int parts;
} Crew;

static Crew crew = {.lock = PTHREAD_MUTEX_INITIALIZER,
                    .begin = PTHREAD_COND_INITIALIZER,
                    .end = PTHREAD_COND_INITIALIZER,
                    .threads = 1};

/// This thread is at work on a part.
static _Thread_local bool at_work;

static void run_share(int thread) {
    at_work = true;
    const int from = (int)((long)crew.parts * thread / crew.threads);
    const int to = (int)((long)crew.parts * (thread + 1) / crew.threads);
    for (int number = from; number < to; number++)
        crew.part(crew.self, number);
    at_work = false;
}

static void breathe(void) {
#ifdef __x86_64__
    __builtin_ia32_pause();
#endif
}

/// Wait for a job that is not `seen`. False when there is none any more.
static bool await_job(long seen) {
    for (int look = 0; look < LOOKS && atomic_load(&crew.job) == seen; look++)
        breathe();
    if (atomic_load(&crew.job) != seen)
        return true;
    pthread_mutex_lock(&crew.lock);
    while (atomic_load(&crew.job) == seen && !crew.home)
        pthread_cond_wait(&crew.begin, &crew.lock);
    const bool more = atomic_load(&crew.job) != seen;
    pthread_mutex_unlock(&crew.lock);
    return more;
}

static void await_end(void) {
    for (int look = 0; look < LOOKS && atomic_load(&crew.working) > 0; look++)
        breathe();
    if (atomic_load(&crew.working) == 0)
        return;
    pthread_mutex_lock(&crew.lock);
    while (atomic_load(&crew.working) > 0)
        pthread_cond_wait(&crew.end, &crew.lock);
    pthread_mutex_unlock(&crew.lock);
}

static void* work(void* self) {
    for (long seen = 0; await_job(seen);) {
        seen++;
        run_share(*(const int*)self);
        if (atomic_fetch_sub(&crew.working, 1) == 1) {
            pthread_mutex_lock(&crew.lock);
            pthread_cond_signal(&crew.end);
            pthread_mutex_unlock(&crew.lock);
        }
    }
    return NULL;
}

void crew_set(int threads) {
    pthread_mutex_lock(&crew.lock);
    crew.home = true;
    pthread_cond_broadcast(&crew.begin);
    pthread_mutex_unlock(&crew.lock);
    for (int t = 1; t < crew.threads; t++)
        pthread_join(crew.thread[t], NULL);

    crew.home = false;
    atomic_store(&crew.job, 0);
    crew.threads = 1;
    const int most = threads < CREW_MOST ? threads : CREW_MOST;
    for (int t = 1; t < most; t++) {
        crew.number[t] = t;
        if (pthread_create(&crew.thread[t], NULL, work, &crew.number[t]) != 0)
            break; // as many as there are
        crew.threads++;
    }
}

int crew_threads(void) {
    return crew.threads;
}

void crew_run(void (*part)(void* self, int number), void* self, int parts) {
    if (crew.threads == 1 || parts <= 1 || at_work) {
        for (int number = 0; number < parts; number++)
            part(self, number);
        return;
    }
    crew.part = part;
    crew.self = self;
    crew.parts = parts;
    atomic_store(&crew.working, crew.threads - 1);
    pthread_mutex_lock(&crew.lock);
    atomic_fetch_add(&crew.job, 1);
    pthread_cond_broadcast(&crew.begin);
    pthread_mutex_unlock(&crew.lock);

    run_share(0);
    await_end();
}
