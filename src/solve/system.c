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
    groups_open(&system->groups, body_count);
    joints_open(&system->joints, system->body, body_count, 0);
}

static void for_each(void (*task)(void* self, int number), void* self, int count) {
    if (count >= 2 * crew_threads())
        crew_run(task, self, count);
    else
        for (int k = 0; k < count; k++)
            task(self, k);
}

void system_for_each(const System* system, void (*task)(void* self, int body), void* self) {
    for_each(task, self, system->body_count);
}

/// What the tasks of a kick share.
typedef struct Kick {
    const Method* method;
    System* system;
    double h;
    bool keep_start; ///< the velocities before are needed
} Kick;

static void keep_start(const Kick* kick, int b) {
    System* system = kick->system;
    const Body* body = system->body[b];
    if (kick->keep_start)
        memcpy(system->v_start[b], body->v, (size_t)body->count * sizeof *body->v);
}

static void kick_body(void* self, int b) {
    const Kick* kick = self;
    System* system = kick->system;
    Body* body = system->body[b];
    system->solved[b] = true;
    if (body->asleep)
        return;
    keep_start(kick, b);
    system->solved[b] =
        kick->method->kick_body(body, system->workspace[b], kick->h, system->stats[b]);
}

static void kick_group(void* self, int g) {
    const Kick* kick = self;
    Group* group = &kick->system->groups.group[g];
    for (int k = 0; k < group->body_count; k++)
        keep_start(kick, group->body[k].number);
    if (kick->system->unsolved_in_row > UNSOLVED_MAX)
        group_forget_contacts(group);
    const bool solved = kick->method->kick_group(group, kick->h);
    for (int k = 0; k < group->body_count; k++)
        kick->system->solved[group->body[k].number] = solved;
}

/// The kicks of all groups, each of which contains its contacts.
static void kick_groups(Kick* kick, Contacts* contacts) {
    System* system = kick->system;
    contacts_begin(contacts, kick->h);
    groups_find(&system->groups, system, contacts);
    for (int b = 0; b < system->body_count; b++)
        system->solved[b] = true;
    for_each(kick_group, kick, system->groups.count);
}

static void limit_strain(void* self, int b) {
    const Kick* kick = self;
    Body* body = kick->system->body[b];
    if (!body->asleep && kick->system->strain_limit[b])
        strain_limit_velocity(kick->system->strain_limit[b], body, kick->h,
                              fmax(kick->h, kick->system->whole));
}

static void restore_velocities(System* system) {
    for (int b = 0; b < system->body_count; b++) {
        Body* body = system->body[b];
        if (!body->asleep)
            memcpy(body->v, system->v_start[b], (size_t)body->count * sizeof *body->v);
    }
}

/// Strain limits change the velocities after the solve: contacts must then follow them.
static bool contacts_in_equation(const Method* method, const System* system) {
    if (!method->kick_group)
        return false;
    if (system->joints.count > 0) // they join bodies only there
        return true;
    for (int b = 0; b < system->body_count; b++)
        if (system->strain_limit[b] && system->strain_limit[b]->on)
            return false;
    for (int b = 0; b < system->body_count; b++)
        if (method->solves_contacts && !method->solves_contacts(system->workspace[b]))
            return false;
    return true;
}

bool system_kick(const Method* method, System* system, Contacts* contacts, double h,
                 double* drift) {
    // velocities before: for a step that cannot be solved, and for contacts
    Kick kick = {method, system, h, method->can_fail || contacts->sphere_count > 0};
    const bool in_groups = contacts_in_equation(method, system);
    joints_begin(&system->joints, h);
    if (in_groups)
        kick_groups(&kick, contacts);
    else {
        system_for_each(system, kick_body, &kick);
        joints_push(&system->joints, h);
    }

    system->unsolved = NONE;
    for (int b = system->body_count - 1; b >= 0; b--)
        if (!system->solved[b])
            system->unsolved = b;
    if (system->unsolved != NONE) {
        restore_velocities(system);
        system->unsolved_in_row++;
        joints_undo(&system->joints);
        if (in_groups)
            contacts_undo(contacts);
        return false;
    }

    if (system->unsolved_in_row <= UNSOLVED_MAX)
        system->unsolved_in_row = 0;
    system_for_each(system, limit_strain, &kick);
    contacts->skins_kicked = true;
    *drift = in_groups ? contacts_finish(contacts, *drift) : contacts_velocities(contacts, *drift);
    return true;
}

void system_close(System* system) {
    free(system->body);
    free(system->strain_limit);
    free(system->workspace);
    free(system->stats);
    free(system->v_start);
    free(system->solved);
    groups_close(&system->groups);
    joints_close(&system->joints);
    *system = (System){0};
}
