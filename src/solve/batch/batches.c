#include "solve/batch/batches.h"

#include <stdlib.h>
#include <string.h>

#include "base/cpu.h"
#include "base/memory.h"
#include "solve/batch/batch_kernel.h"

enum { WINDOW = 32 };

/// The open batches. Slot w holds batch number[w]; a particle's bit w is set where a spring of that
/// batch ends at it.
typedef struct Window {
    int number[WINDOW];
    uint32_t* used; ///< [particles]
} Window;

static void clear_slot(Window* window, int w, const Springs* springs, const Batches* batches) {
    const int batch = window->number[w];
    for (int k = 0; k < batches->filled[batch]; k++)
        for (int e = 0; e < 2; e++)
            window->used[springs->end[batches->spring[batch][k]][e]] &= ~(1u << w);
}

static void add_spring(Batches* batches, int batch, int s, const Springs* springs) {
    const int lane = batches->filled[batch]++;
    batches->spring[batch][lane] = s;
    batches->rest[batch][lane] = springs->rest[s];
    for (int e = 0; e < 2; e++)
        batches->end[batch][e][lane] = (uint32_t)((size_t)springs->end[s][e] * sizeof(real4));
}

/// The slot for a spring whose ends have these bits set: the first clear bit w, or, where all are
/// set, -1 - w for the slot w of the oldest batch, which must close.
static int find_slot(uint32_t used, int* oldest) {
    if (~used)
        return __builtin_ctz(~used);
    const int w = *oldest;
    *oldest = (w + 1) % WINDOW;
    return -1 - w;
}

/// Remove the empty batches, and allocate the arrays of a step.
static void compact(Batches* batches) {
    int count = 0;
    for (int b = 0; b < batches->count; b++) {
        if (batches->filled[b] == 0)
            continue;
        batches->filled[count] = batches->filled[b];
        memmove(batches->spring[count], batches->spring[b], sizeof *batches->spring);
        memmove(batches->end[count], batches->end[b], sizeof *batches->end);
        memmove(batches->rest[count], batches->rest[b], sizeof *batches->rest);
        for (int k = batches->filled[count]; k < LANES; k++)
            batches->rest[count][k] = 1;
        count++;
    }
    batches->count = count;
    batches->weight = new_array(real[2][LANES], count);
    batches->stiff = new_array(real[LANES], count);
    batches->impulse = new_array(real[3][LANES], count);
}

void batches_make(Batches* batches, const Springs* springs, int particles) {
    const int capacity = springs->count + WINDOW;
    *batches = (Batches){.filled = new_array(int, capacity),
                         .spring = new_array(int[LANES], capacity),
                         .end = new_array(uint32_t[2][LANES], capacity),
                         .rest = new_array(real[LANES], capacity)};
    Window window = {.used = new_array(uint32_t, particles)};
    for (int w = 0; w < WINDOW; w++)
        window.number[w] = batches->count++;
    int oldest = 0;
    for (int s = 0; s < springs->count; s++) {
        const int i = springs->end[s][0], j = springs->end[s][1];
        int w = find_slot(window.used[i] | window.used[j], &oldest);
        if (w < 0) {
            w = -1 - w;
            clear_slot(&window, w, springs, batches);
            window.number[w] = batches->count++;
        }
        add_spring(batches, window.number[w], s, springs);
        window.used[i] |= 1u << w;
        window.used[j] |= 1u << w;
        if (batches->filled[window.number[w]] == LANES) {
            clear_slot(&window, w, springs, batches);
            window.number[w] = batches->count++;
        }
    }
    free(window.used);
    compact(batches);
}

void batches_begin(Batches* batches, const Springs* springs, const real* weight, real h2) {
    memset(batches->impulse, 0, (size_t)batches->count * sizeof *batches->impulse);
    for (int b = 0; b < batches->count; b++)
        for (int k = 0; k < batches->filled[b]; k++) {
            const int s = batches->spring[b][k];
            batches->stiff[b][k] = h2 * springs->active[s];
            for (int e = 0; e < 2; e++)
                batches->weight[b][e][k] = weight[springs->end[s][e]];
        }
}

void batches_relax(Batches* batches, SpringLaw law, const real4* x, real4* u) {
#ifdef __x86_64__
    if (cpu_is_v3()) {
        batch_relax_v3(batches, law, x, u);
        return;
    }
#endif
    batch_relax_baseline(batches, law, x, u);
}

void batches_free(Batches* batches) {
    free(batches->filled);
    free(batches->spring);
    free(batches->end);
    free(batches->rest);
    free(batches->weight);
    free(batches->stiff);
    free(batches->impulse);
    *batches = (Batches){0};
}
