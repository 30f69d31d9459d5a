#include "lab/bench/encounter.h"

#include <stdarg.h>
#include <string.h>

#include "base/interrupt.h"
#include "base/random.h"

enum { BALLOONS_MAX = 6, SIMPLE_MAX = 3, TRIES_MAX = 1000 };

static const double half = 0.5; ///< balloons begin within this of the origin along each axis [m]
static const double speed_max = 50;   ///< [m/s]
static const double pressed = 0.02;   ///< distance of the plates when they are nearest [m]
static const double plates_at = 0.85; ///< where they begin [m]
static const double afterward = 0.3;  ///< how long it goes on, once plates have opened again [s]

static const char* const simple_model[] = {"icosphere:2", "icosphere:1", "cube-sphere:5",
                                           "torus:12x6", "pillow:8"};
static const char* const model[] = {"icosphere:2", "icosphere:3",  "cube-sphere:8", "torus:24x12",
                                    "pillow:12",   "balloon.obj",  "heart.obj",     "star.obj",
                                    "dog.obj",     "squirrel.obj", "turtle.obj",    "bowl.obj"};

/// A method, its skins, and its steps.
typedef struct Kind {
    const char* method;
    const char* const* skin;
    const char* const* step;
} Kind;

#define HOOKE "springs: {structural: 50, shear: 10, flexion: 10}"
#define RUBBER "springs: {structural: 40, shear: 10, flexion: 5, law: rubber}"
#define MEMBRANE(law) "membrane: {material: " law ", young: 1e6, density: 1000, thickness: 0.0003}"
static const char* const all_skins[] = {HOOKE, RUBBER, MEMBRANE("neo-hookean"), MEMBRANE("stvk"),
                                        NULL};
static const char* const spring_skins[] = {HOOKE, RUBBER, NULL};
static const char* const hooke_skin[] = {HOOKE, NULL};
static const char* const short_steps[] = {"0.0005", "0.001", "0.002", NULL};
static const char* const long_steps[] = {"0.001", "0.004", "0.0166667", NULL};

static const Kind kind_table[] = {
    {"euler", all_skins, short_steps},    {"euler", all_skins, short_steps},
    {"newton", all_skins, long_steps},    {"newton", all_skins, long_steps},
    {"xpbd", spring_skins, short_steps},  {"projective", hooke_skin, short_steps},
    {"forward", hooke_skin, short_steps},
};
enum { KINDS = sizeof kind_table / sizeof *kind_table };

static int draw_below(Random* random, int count) {
    return (int)(random_next(random) * count);
}

static double draw_between(Random* random, double low, double high) {
    return low + random_next(random) * (high - low);
}

static const char* draw_name(Random* random, const char* const* name) {
    int count = 0;
    while (name[count])
        count++;
    return name[draw_below(random, count)];
}

/// What is known of a balloon before it is opened.
typedef struct Drawn {
    double4 position, velocity;
    double size;
} Drawn;

/// A place where it touches no other one: a model lies within sqrt(3) / 2 of its size.
static bool draw_place(Random* random, Drawn* drawn, int count) {
    Drawn* last = &drawn[count];
    for (int n = 0; n < TRIES_MAX; n++) {
        bool free_place = true;
        for (int k = 0; k < 3; k++)
            last->position[k] = draw_between(random, -half, half);
        for (int b = 0; b < count; b++)
            free_place &=
                dlength(last->position - drawn[b].position) > 0.87 * (last->size + drawn[b].size);
        if (free_place)
            return true;
    }
    return false;
}

/// Toward the middle of all, more or less.
static void draw_velocity(Random* random, Drawn* drawn, bool squeezed) {
    const double share = random_next(random);
    const double speed = speed_max * share * share * (squeezed ? 0.1 : 1);
    double4 to = -1 * drawn->position;
    for (int k = 0; k < 3; k++)
        to[k] += draw_between(random, -0.15, 0.15);
    drawn->velocity = speed / fmax(dlength(to), 1e-3) * to;
}

static void add_text(Encounter* encounter, const char* format, ...)
    __attribute__((format(printf, 2, 3)));

static void add_text(Encounter* encounter, const char* format, ...) {
    const size_t used = strlen(encounter->balloons);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(encounter->balloons + used, sizeof encounter->balloons - used, format, arguments);
    va_end(arguments);
}

static void draw_balloon(Encounter* encounter, Random* random, const Drawn* drawn, const Kind* kind,
                         bool simple) {
    const char* name = simple ? simple_model[draw_below(random, 5)] : model[draw_below(random, 12)];
    const char* skin = draw_name(random, kind->skin);
    const bool rubber = strncmp(skin, "membrane", strlen("membrane")) == 0;
    add_text(encounter, "{model: '%s', size: %.4f, position: [%.4f, %.4f, %.4f], rotation: %.1f, ",
             name, drawn->size, drawn->position[0], drawn->position[1], drawn->position[2],
             draw_between(random, 0, 360));
    add_text(encounter, "skin: {%s}, damping: {rate: %.2f}", skin,
             strcmp(kind->method, "forward") == 0 ? 200 : draw_between(random, 0, 10));
    if (!rubber)
        add_text(encounter, ", mass: {per_particle: %.3g}", draw_between(random, 5e-5, 3e-4));
    const double gas = random_next(random), amount = draw_between(random, 0.95, 1.05);
    const bool encloses = strcmp(name, "bowl.obj") != 0 && !strstr(name, "pillow"); // it is flat
    if (encloses && gas < 0.7) // else it is empty, and may be crushed
        add_text(encounter, ", inflation: {law: gas, amount: %.4f}", amount);
    add_text(encounter, "}, ");
}

static void draw_scene(Encounter* encounter, Random* random, const Kind* kind) {
    static const char* const friction[] = {"0", "0.8", NULL};
    const double seconds = draw_between(random, 0.1, 0.4);
    snprintf(encounter->scene[0], 64, "method=%s", kind->method);
    snprintf(encounter->scene[1], 64, "step=%s", draw_name(random, kind->step));
    snprintf(encounter->scene[2], 64, "contacts={self: true, others: true, friction: %s}",
             draw_name(random, friction));
    snprintf(encounter->scene[3], 64, "gravity=%s", random_next(random) < 0.5 ? "0" : "9.81");
    snprintf(encounter->scene[4], 64, "floor=-2");
    encounter->seconds = (encounter->squeezed ? 2 * seconds : 0) + afterward;
    encounter->squeezed_at = seconds;
}

static bool open_world(Encounter* encounter, Fault* fault) {
    char things[2][400], list[900] = "things=[]";
    const double at = plates_at + 0.01, near = pressed / 2 + 0.01, t = encounter->squeezed_at;
    for (int k = 0; k < 2; k++) {
        const int sign = k == 0 ? -1 : 1;
        snprintf(things[k], sizeof things[k],
                 "{model: box, size: [0.02, 3, 3], path: [{position: [%g, 0, 0]}, "
                 "{at: %.3f, position: [%g, 0, 0]}, {at: %.3f, position: [%g, 0, 0]}]}",
                 sign * at, t, sign * near, 2 * t, sign * at);
    }
    if (encounter->squeezed)
        snprintf(list, sizeof list, "things=[%s, %s]", things[0], things[1]);
    const SceneSet set[] = {{encounter->scene[0]},
                            {encounter->scene[1]},
                            {encounter->scene[2]},
                            {encounter->scene[3]},
                            {encounter->scene[4]},
                            {encounter->balloons},
                            {list}};
    WorldDef def;
    return scene_load("cube-sphere:2", set, sizeof set / sizeof *set, &def, fault) &&
           world_open(&encounter->world, &def, fault);
}

bool encounter_open(Encounter* encounter, uint64_t seed, bool simple, Fault* fault) {
    *encounter = (Encounter){0};
    Random random = {seed};
    random_next(&random); // neighboring seeds differ from here
    Drawn drawn[BALLOONS_MAX] = {{{0}, {0}, 0}};
    const Kind* kind = &kind_table[draw_below(&random, simple ? KINDS - 1 : KINDS)];
    const int wanted = 2 + draw_below(&random, (simple ? SIMPLE_MAX : BALLOONS_MAX) - 1);
    encounter->squeezed = random_next(&random) < 0.5;
    draw_scene(encounter, &random, kind);
    add_text(encounter, "balloons=[");
    int count = 0;
    for (; count < wanted; count++) {
        drawn[count].size = draw_between(&random, 0.12, 0.3);
        if (!draw_place(&random, drawn, count))
            break;
        draw_velocity(&random, &drawn[count], encounter->squeezed);
        draw_balloon(encounter, &random, &drawn[count], kind, simple);
    }
    add_text(encounter, "]");
    if (!open_world(encounter, fault))
        return false;
    for (int b = 0; b < count; b++) {
        Body* body = &encounter->world.balloon[b].body;
        for (int i = 0; i < body->count; i++)
            body->v[i] = to_real4(drawn[b].velocity);
    }
    return true;
}

bool encounter_go_on(Encounter* encounter) {
    World* world = &encounter->world;
    const double until = world_time(world) + 1.0 / ENCOUNTER_LOOKS;
    if (!(world_time(world) < encounter->seconds))
        return false;
    while (world_time(world) < until && !world->blowup.halted && !interrupt_signal())
        world_step(world);
    return !world->blowup.halted && !interrupt_signal();
}

void encounter_close(Encounter* encounter) {
    world_close(&encounter->world);
}
