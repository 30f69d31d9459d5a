#include "world/command.h"

#include <stdlib.h>
#include <string.h>

#include "base/table.h"
#include "force/force.h"
#include "scene/key.h"
#include "world/knots/knots.h"
#include "world/rest.h"

/// The balloons that keys act on: [first, last).
static int first(const World* world) {
    return world->selected == ALL_BALLOONS ? 0 : world->selected;
}

static int last(const World* world) {
    return world->selected == ALL_BALLOONS ? world->balloon_count : world->selected + 1;
}

static void inflate(World* world, double h) {
    for (int b = first(world); b < last(world); b++)
        balloon_blow(&world->balloon[b], h);
}

static void deflate(World* world, double h) {
    for (int b = first(world); b < last(world); b++)
        balloon_blow(&world->balloon[b], -h);
}

/// all, 0, 1, …, all
static void select_next(World* world) {
    world->selected++;
    if (world->selected == world->balloon_count || world->balloon_count == 1)
        world->selected = ALL_BALLOONS;
}

static void correction(World* world) {
    for (int b = first(world); b < last(world); b++) {
        Balloon* balloon = &world->balloon[b];
        strain_limit_switch(&balloon->strain_limit, &balloon->body, !balloon->strain_limit.on);
    }
}

static void tarantino(World* world) {
    for (int b = first(world); b < last(world); b++) {
        Balloon* balloon = &world->balloon[b];
        balloon->strain_limit.tarantino = !balloon->strain_limit.tarantino;
        strain_limit_switch(&balloon->strain_limit, &balloon->body, true);
    }
}

static void string(World* world) {
    for (int b = first(world); b < last(world); b++) {
        Balloon* balloon = &world->balloon[b];
        const bool joined = knots_tie(world, b);
        if (!joined || balloon->strings > 0)
            balloon_tie(balloon, &world->def, balloon->body.string_count == 0);
    }
}

static void clear(World* world) {
    contacts_clear(&world->contacts);
}

// clang-format off
const Command command_table[] = {
    {.name = "inflate",    .key = "up",    .about = "inflate while held",                 .hold = inflate},
    {.name = "deflate",    .key = "down",  .about = "deflate while held",                 .hold = deflate},
    {.name = "select",     .key = "tab",   .about = "select the next balloon, then all",  .down = select_next},
    {.name = "string",     .key = "t",     .about = "tie or untie the strings",           .down = string},
    {.name = "correction", .key = "c",     .about = "correct over-stretched springs (Provot)", .down = correction},
    {.name = "tarantino",  .key = "v",     .about = "corrected springs rest for a step (Tarantino)", .down = tarantino},
    {.name = "clear",      .key = "x",     .about = "take all balls away",                .down = clear},
    {.name = "reset",      .key = "r",     .about = "start the scene again",              .down = world_reset},
};
// clang-format on
const int command_count = sizeof command_table / sizeof *command_table;

int command_find(const char* name) {
    const Command* row = table_row_of(command_table, command_count, sizeof *command_table, name);
    return row ? (int)(row - command_table) : -1;
}

static bool press(World* world, const Event* event, Fault* fault) {
    const int row = command_find(event->name);
    if (row < 0)
        return fault_set(fault, event->name, "no such key in an input log; see balloon --help");
    const bool down = strcmp(event->value, "down") == 0;
    world->held = down ? world->held | 1u << row : world->held & ~(1u << row);
    world->guard.changed = true;
    if (down && command_table[row].down)
        command_table[row].down(world);
    return true;
}

/// A number of a balloon that a log may set while a world runs: a parameter of a force, or the
/// amount that the scene gives.
typedef struct Setting {
    int force; ///< row, NONE: inflation.amount
    int parameter;
} Setting;

/// False where no balloon has such a number. key: "FORCE.PARAMETER" or "inflation.amount"
static bool setting_find(const char* key, Setting* setting) {
    *setting = (Setting){NONE, 0};
    if (strcmp(key, "inflation.amount") == 0)
        return true;
    for (int k = 0; k < force_count; k++)
        for (int p = 0; p < force_table[k]->parameter_count; p++) {
            char name[64];
            snprintf(name, sizeof name, "%s.%s", force_table[k]->name,
                     force_table[k]->parameters[p].name);
            if (strcmp(name, key) == 0) {
                *setting = (Setting){k, p};
                return true;
            }
        }
    return false;
}

static bool is_allowed(Setting setting, double value, const Event* event, Fault* fault) {
    if (setting.force == NONE)
        return true;
    const Parameter* range = &force_table[setting.force]->parameters[setting.parameter];
    if (key_allows(range, value))
        return true;
    char words[96];
    key_range(range, words);
    return fault_set(fault, event->name, "must be %s, not %s", words, event->value);
}

/// NULL where this balloon has none.
static double* setting_of(Balloon* balloon, Setting setting) {
    if (setting.force != NONE)
        return &balloon->body.force_parameter[setting.force][setting.parameter];
    return balloon->def->inflation ? &balloon->scene_amount : NULL;
}

/// A number of the world that a log may set.
typedef struct WorldSetting {
    const char* key;
    void (*set)(World* world, double value);
} WorldSetting;

static void set_gravity(World* world, double value) {
    for (int b = 0; b < world->balloon_count; b++)
        world->balloon[b].body.gravity = value;
    world->contacts.gravity = value;
}

static const WorldSetting world_setting_table[] = {
    {"gravity", set_gravity},
};

void command_reference(FILE* out) {
    fputs("\n| NAME of `key` | key | effect |\n|---|---|---|\n", out);
    for (int k = 0; k < command_count; k++)
        fprintf(out, "| `%s` | %s | %s |\n", command_table[k].name, command_table[k].key,
                command_table[k].about);
    fputs("\nKEY of `set`, a number each; without `balloons.N.` it is set of all balloons:\n\n",
          out);
    for (size_t k = 0; k < sizeof world_setting_table / sizeof *world_setting_table; k++)
        fprintf(out, "* `%s`\n", world_setting_table[k].key);
    fputs("* `balloons.N.inflation.amount`\n", out);
    for (int k = 0; k < force_count; k++)
        for (int p = 0; p < force_table[k]->parameter_count; p++)
            fprintf(out, "* `balloons.N.%s.%s`\n", force_table[k]->name,
                    force_table[k]->parameters[p].name);
}

/// A number that an event sets, as the words of its line name it.
typedef struct Target {
    const WorldSetting* world; ///< NULL: of balloons
    Setting setting;
    int first, end; ///< balloons
    double value;
} Target;

static bool read_value(const Event* event, double* value, Fault* fault) {
    char* end;
    *value = strtod(event->value, &end);
    if (end == event->value || *end || !isfinite(*value))
        return fault_set(fault, event->name, "'%s' is not a number", event->value);
    return real_holds(*value) ||
           fault_set(fault, event->name, "%s is out of range in a state of " REAL_NAME,
                     event->value);
}

/// "balloons.2.damping.rate", or "damping.rate" for all balloons.
static bool find_of_balloons(const World* world, const Event* event, Target* target, Fault* fault) {
    int used = 0;
    *target = (Target){.end = world->balloon_count, .value = target->value};
    if (sscanf(event->name, "balloons.%d.%n", &target->first, &used) == 1 && used > 0) {
        if (target->first < 0 || target->first >= world->balloon_count)
            return fault_set(fault, event->name, "there are balloons 0 to %d",
                             world->balloon_count - 1);
        target->end = target->first + 1;
    }
    if (!setting_find(event->name + used, &target->setting))
        return fault_set(fault, event->name, "cannot be set while a scene runs");
    if (!is_allowed(target->setting, target->value, event, fault))
        return false;
    for (int b = target->first; b < target->end; b++)
        if (!setting_of(&world->balloon[b], target->setting))
            return fault_set(fault, event->name, "balloon %d has none", b);
    return true;
}

static bool find_target(const World* world, const Event* event, Target* target, Fault* fault) {
    if (!read_value(event, &target->value, fault))
        return false;
    for (size_t k = 0; k < sizeof world_setting_table / sizeof *world_setting_table; k++)
        if (strcmp(world_setting_table[k].key, event->name) == 0) {
            target->world = &world_setting_table[k];
            return true;
        }
    return find_of_balloons(world, event, target, fault);
}

static bool set(World* world, const Event* event, Fault* fault) {
    Target target;
    if (!find_target(world, event, &target, fault))
        return false;
    if (target.world)
        target.world->set(world, target.value);
    for (int b = target.first; !target.world && b < target.end; b++)
        *setting_of(&world->balloon[b], target.setting) = target.value;
    world->guard.changed = true;
    return true;
}

bool world_event_check(const World* world, const Event* event, Fault* fault) {
    Target target;
    return event->kind != EVENT_SET || find_target(world, event, &target, fault);
}

static const double thrown_restitution = 0.5; ///< [1] of balls that the user throws
static const double thrown_friction = 0.5;    ///< [1]

static bool throw(World * world, const Event* event, Fault* fault) {
    const double* n = event->thrown;
    if (!(n[6] > 0 && n[7] > 0))
        return fault_set(fault, "throw", "a ball has a mass and a radius above 0");
    const Sphere sphere = sphere_of(n, n + 3, n[7], n[6], thrown_restitution, thrown_friction);
    contacts_add(&world->contacts, &sphere);
    return true;
}

bool world_event(World* world, const Event* event, Fault* fault) {
    rest_wake_all(world);
    world->watch.touched = true;
    switch (event->kind) {
        case EVENT_THROW:
            return throw(world, event, fault);
        case EVENT_SET:
            return set(world, event, fault);
        default:
            return press(world, event, fault);
    }
}
