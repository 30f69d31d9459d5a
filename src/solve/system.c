#include "solve/system.h"

#include <stdlib.h>
#include <string.h>

#include "base/crew.h"
#include "base/memory.h"
#include "solve/method.h"

void system_open(System* system, int body_count) {
    *system = (System){
        .body_count = body_count,
        .body = new_array(Body*, body_count),
        .strain_limit = new_array(StrainLimit*, body_count),
        .workspace = new_array(void*, body_count),
        .stats = new_array(SolveStats*, body_count),
        .v_start = new_array(real4*, body_count),
        .solved = new_array(bool, body_count),
        .unsolved = NONE,
    };
}

void system_for_each(const System* system, void (*task)(void* self, int body), void* self) {
    if (system->body_count >= 2 * crew_threads())
        crew_run(task, self, system->body_count);
    else
        for (int b = 0; b < system->body_count; b++)
            task(self, b);
}

/// What the tasks of a kick share.
typedef struct Kick {
    const Method* method;
    System* system;
    double h;
    bool keep_start; ///< the velocities before are needed
} Kick;

static void kick_body(void* self, int b) {
    const Kick* kick = self;
    System* system = kick->system;
    Body* body = system->body[b];
    system->solved[b] = true;
    if (body->asleep)
        return;
    if (kick->keep_start)
        memcpy(system->v_start[b], body->v, (size_t)body->count * sizeof *body->v);
    system->solved[b] =
        kick->method->kick_body(body, system->workspace[b], kick->h, system->stats[b]);
}

static void limit_strain(void* self, int b) {
    const Kick* kick = self;
    Body* body = kick->system->body[b];
    if (!body->asleep && kick->system->strain_limit[b])
        strain_limit_velocity(kick->system->strain_limit[b], body, kick->h);
}

static void restore_velocities(System* system) {
    for (int b = 0; b < system->body_count; b++) {
        Body* body = system->body[b];
        if (!body->asleep)
            memcpy(body->v, system->v_start[b], (size_t)body->count * sizeof *body->v);
    }
}

bool system_kick(const Method* method, System* system, Contacts* contacts, double h,
                 double* drift) {
    // velocities before: for a step that cannot be solved, and for contacts
    Kick kick = {method, system, h, method->can_fail || contacts->sphere_count > 0};
    system_for_each(system, kick_body, &kick);

    system->unsolved = NONE;
    for (int b = system->body_count - 1; b >= 0; b--)
        if (!system->solved[b])
            system->unsolved = b;
    if (system->unsolved != NONE) {
        restore_velocities(system);
        return false;
    }

    system_for_each(system, limit_strain, &kick);
    *drift = contacts_velocities(contacts, h);
    return true;
}

void system_close(System* system) {
    free(system->body);
    free(system->strain_limit);
    free(system->workspace);
    free(system->stats);
    free(system->v_start);
    free(system->solved);
    *system = (System){0};
}
