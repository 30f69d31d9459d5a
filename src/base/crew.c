#include "base/crew.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>

/// How often a thread polls before it sleeps: some 20 us, longer than the pause between two loops of a
/// step, and far shorter than a frame.
enum { SPINS = 2000 };

typedef struct Crew {
    pthread_mutex_t lock; ///< for threads that sleep
    pthread_cond_t begin, end;
    pthread_t thread[CREW_THREADS_MAX];
    int number[CREW_THREADS_MAX]; ///< index of each thread, its argument
    int threads;                  ///< the caller's included, which is thread 0
    bool stopping;                ///< all threads are to end
    atomic_long job;              ///< number of the current loop: a thread waits for a new one
    atomic_int working;           ///< threads that have not finished their share
    void (*task)(void* self, int number);
    void* self;
    int tasks;
} Crew;

static Crew crew = {.lock = PTHREAD_MUTEX_INITIALIZER,
                    .begin = PTHREAD_COND_INITIALIZER,
                    .end = PTHREAD_COND_INITIALIZER,
                    .threads = 1};

/// This thread is running a task.
static _Thread_local bool in_task;

static void run_share(int thread) {
    in_task = true;
    const int from = (int)((long)crew.tasks * thread / crew.threads);
    const int to = (int)((long)crew.tasks * (thread + 1) / crew.threads);
    for (int number = from; number < to; number++)
        crew.task(crew.self, number);
    in_task = false;
}

static void relax(void) {
#ifdef __x86_64__
    __builtin_ia32_pause();
#endif
}

/// Wait for a job that is not `seen`. False when the thread is to end.
static bool await_job(long seen) {
    for (int look = 0; look < SPINS && atomic_load(&crew.job) == seen; look++)
        relax();
    if (atomic_load(&crew.job) != seen)
        return true;
    pthread_mutex_lock(&crew.lock);
    while (atomic_load(&crew.job) == seen && !crew.stopping)
        pthread_cond_wait(&crew.begin, &crew.lock);
    const bool more = atomic_load(&crew.job) != seen;
    pthread_mutex_unlock(&crew.lock);
    return more;
}

static void await_end(void) {
    for (int look = 0; look < SPINS && atomic_load(&crew.working) > 0; look++)
        relax();
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
    crew.stopping = true;
    pthread_cond_broadcast(&crew.begin);
    pthread_mutex_unlock(&crew.lock);
    for (int t = 1; t < crew.threads; t++)
        pthread_join(crew.thread[t], NULL);

    crew.stopping = false;
    atomic_store(&crew.job, 0);
    crew.threads = 1;
    const int wanted = threads < CREW_THREADS_MAX ? threads : CREW_THREADS_MAX;
    for (int t = 1; t < wanted; t++) {
        crew.number[t] = t;
        if (pthread_create(&crew.thread[t], NULL, work, &crew.number[t]) != 0)
            break; // the system gives no more
        crew.threads++;
    }
}

int crew_threads(void) {
    return crew.threads;
}

void crew_run(void (*task)(void* self, int number), void* self, int tasks) {
    if (crew.threads == 1 || tasks <= 1 || in_task) {
        for (int number = 0; number < tasks; number++)
            task(self, number);
        return;
    }
    crew.task = task;
    crew.self = self;
    crew.tasks = tasks;
    atomic_store(&crew.working, crew.threads - 1);
    pthread_mutex_lock(&crew.lock);
    atomic_fetch_add(&crew.job, 1);
    pthread_cond_broadcast(&crew.begin);
    pthread_mutex_unlock(&crew.lock);

    run_share(0);
    await_end();
}
