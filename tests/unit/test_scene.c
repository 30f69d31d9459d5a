// clang-format off
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
// clang-format on

#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "mesh/shape.h"
#include "world/scene.h"
#include "world/scene_range.h"

enum { SET_MOST = 4, MUTATIONS = 1000 };

static const char smallest[] = "step: 0.01\n"
                               "balloons:\n"
                               "  - model: cube\n"
                               "    mass: {per_particle: 0.5}\n";

// Every key of the format once.
static const char full[] =
    "title: All there is\n"
    "units: paper\n"
    "step: 0.002\n"
    "gravity: 0\n"
    "floor: -3.5\n"
    "guard: stop\n"
    "precision: double\n"
    "method: euler\n"
    "show: springs\n"
    "seconds: 12\n"
    "camera: {eye: [1, 2, 3], look: [4, 5, 6]}\n"
    "about: [{output: balloon0.cy, at: 20, tolerance: 0.05}]\n"
    "contact: paper\n"
    "spheres: [{position: [1, 2, 3], velocity: [4, 5, 6], radius: 0.5, mass: 2, restitution: "
    "0.25,\n"
    "  friction: 0.75}]\n"
    "walls: [{at: [0, 0, -7], normal: [0, 0, 2]}]\n"
    "balloons:\n"
    "  - model: cube-sphere:4\n"
    "    position: [1, -2, 3e-1]\n"
    "    size: 2\n"
    "    scale: 3\n"
    "    turn: 90\n"
    "    color: [0.1, 0.2, 1]\n"
    "    skin: {springs: {structural: 50, shear: 10, flexion: 11, torsion: 12, law: rubber}}\n"
    "    mass: {per_particle: 0.001}\n"
    "    hold_rim: true\n"
    "    inflation: {law: gas, amount: 1.5, rate: 2, least: 0.5, most: 9, ambient: 1e5,\n"
    "                fill: {to: 3, start: 0.25, seconds: 0.5}}\n"
    "    helium: {base: 20, per_inflation: 5}\n"
    "    damping: {coefficient: 0.2, rate: 0}\n"
    "    correction: {structural: 0.1, shear: 0.2, flexion: 0.3, tarantino: true}\n"
    "    strings:\n"
    "      - {to: [0, -6, 0.5], at: nearest, stiffness: 50, slack: 1.2}\n"
    "      - {at: 12, stiffness: 7}\n";

static char folder[] = "/tmp/balloon-scene-XXXXXX";
static char scene[64];  // the file that tests write
static char beside[64]; // a model beside it

static int make_folder(void** state) {
    (void)state;
    if (!mkdtemp(folder))
        return -1;
    snprintf(scene, sizeof scene, "%s/scene.yaml", folder);
    snprintf(beside, sizeof beside, "%s/beside.obj", folder);
    return 0;
}

static int remove_folder(void** state) {
    (void)state;
    remove(scene);
    remove(beside);
    return rmdir(folder);
}

static void write_bytes(const char* path, const void* bytes, size_t size) {
    FILE* out = fopen(path, "wb");
    assert_non_null(out);
    assert_int_equal(fwrite(bytes, 1, size, out), size);
    assert_int_equal(fclose(out), 0);
}

// Load a text with overrides, which end with NULL.
static bool load(const char* text, const char* const* set, WorldDef* def, Fault* fault) {
    SceneSet sets[SET_MOST];
    int count = 0;
    while (set && set[count]) {
        sets[count].text = set[count];
        count++;
    }
    *fault = (Fault){0};
    write_bytes(scene, text, strlen(text));
    return scene_load(scene, sets, count, def, fault);
}

static void must_load(const char* text, const char* const* set, WorldDef* def) {
    Fault fault;
    if (!load(text, set, def, &fault))
        fail_msg("%s: %s", fault.place, fault.text);
}

// The fault must be at this place and its sentence must hold these words.
static void must_refuse(const char* text, const char* const* set, const char* place,
                        const char* words) {
    WorldDef def;
    Fault fault;
    if (load(text, set, &def, &fault))
        fail_msg("this was taken, and not refused with '%s':\n%s", words, text);
    if (strcmp(fault.place, place) != 0 || !strstr(fault.text, words))
        fail_msg("got  %s: %s\nwant %s: … %s …\nof\n%s", fault.place, fault.text, place, words,
                 text);
    assert_null(strchr(fault.text, '\n'));
    assert_null(def.loaded);
}

static void assert_vector(const double* vector, double x, double y, double z) {
    assert_non_null(vector);
    assert_true(vector[0] == x && vector[1] == y && vector[2] == z);
}

static void every_key_of_a_world_loads_into_its_field(void** state) {
    (void)state;
    WorldDef def;
    must_load(full, NULL, &def);

    assert_string_equal(def.title, "All there is");
    assert_int_equal(def.units, UNITS_PAPER);
    assert_true(def.step == 0.002);
    assert_true(def.gravity && *def.gravity == 0);
    assert_true(def.floor && *def.floor == -3.5);
    assert_int_equal(def.guard, GUARD_STOP);
    assert_int_equal(def.precision, PRECISION_DOUBLE);
    assert_string_equal(def.method, "euler");
    assert_string_equal(def.show, "springs");
    assert_true(def.seconds == 12);
    assert_vector(def.camera->eye, 1, 2, 3);
    assert_vector(def.camera->look, 4, 5, 6);
    assert_int_equal(def.about_count, 1);
    assert_string_equal(def.about[0].output, "balloon0.cy");
    assert_true(def.about[0].at == 20 && def.about[0].tolerance == 0.05);
    assert_int_equal(def.balloons_count, 1);
    assert_string_equal(def.file, scene);
    scene_free(&def);
}

static void every_key_of_spheres_and_walls_loads_into_its_field(void** state) {
    (void)state;
    WorldDef def;
    must_load(full, NULL, &def);
    assert_int_equal(def.contact, CONTACT_PAPER);
    assert_int_equal(def.spheres_count, 1);
    const SphereDef* sphere = &def.spheres[0];
    assert_vector(sphere->position, 1, 2, 3);
    assert_vector(sphere->velocity, 4, 5, 6);
    assert_true(sphere->radius == 0.5 && sphere->mass == 2);
    assert_true(sphere->restitution == 0.25 && sphere->friction == 0.75);
    assert_int_equal(def.walls_count, 1);
    assert_vector(def.walls[0].at, 0, 0, -7);
    assert_vector(def.walls[0].normal, 0, 0, 2);
    scene_free(&def);
}

static void every_key_of_a_balloon_loads_into_its_field(void** state) {
    (void)state;
    WorldDef def;
    must_load(full, NULL, &def);

    const BalloonDef* balloon = def.balloons;
    assert_string_equal(balloon->model, "cube-sphere:4");
    assert_vector(balloon->position, 1, -2, 0.3);
    assert_true(balloon->size == 2 && balloon->scale == 3 && balloon->turn == 90);
    assert_vector(balloon->color, 0.1, 0.2, 1);
    const SpringsDef* springs = balloon->skin.springs;
    assert_true(springs->structural == 50 && springs->shear == 10 && springs->flexion == 11);
    assert_true(springs->torsion == 12 && springs->law == LAW_RUBBER);
    assert_true(balloon->mass.per_particle == 0.001);
    assert_true(balloon->hold_rim);
    assert_true(balloon->helium->base == 20 && balloon->helium->per_inflation == 5);
    assert_true(balloon->damping->coefficient == 0.2 && balloon->damping->rate == 0);
    const CorrectionDef* correction = balloon->correction;
    assert_true(correction->structural == 0.1 && correction->shear == 0.2);
    assert_true(correction->flexion == 0.3 && correction->tarantino);
    scene_free(&def);
}

static void every_key_of_inflation_and_strings_loads_into_its_field(void** state) {
    (void)state;
    WorldDef def;
    must_load(full, NULL, &def);

    const InflationDef* inflation = def.balloons->inflation;
    assert_int_equal(inflation->law, INFLATE_GAS);
    assert_true(inflation->amount == 1.5 && inflation->rate == 2);
    assert_true(inflation->least == 0.5 && inflation->most == 9 && *inflation->ambient == 1e5);
    const FillDef* filling = inflation->fill;
    assert_true(filling->to == 3 && filling->start == 0.25 && filling->seconds == 0.5);
    assert_int_equal(def.balloons->strings_count, 2);
    const StringDef* string = def.balloons->strings;
    assert_vector(string[0].to, 0, -6, 0.5);
    assert_string_equal(string[0].at, "nearest");
    assert_true(string[0].stiffness == 50 && string[0].slack == 1.2);
    assert_null(string[1].to);
    assert_string_equal(string[1].at, "12");
    assert_true(string[1].stiffness == 7 && string[1].slack == 0);
    scene_free(&def);
}

static void what_a_scene_does_not_name_is_absent(void** state) {
    (void)state;
    WorldDef def;
    must_load(smallest, NULL, &def);

    const WorldDef got = def;
    assert_true(!got.title && !got.gravity && !got.floor && !got.method && !got.show);
    assert_true(!got.camera && !got.about && got.about_count == 0 && got.seconds == 0);
    assert_int_equal(got.units, UNITS_SI);
    assert_int_equal(got.guard, GUARD_SPLIT);
    assert_int_equal(got.precision, PRECISION_ANY);
    const BalloonDef* b = got.balloons;
    assert_true(!b->position && !b->color && !b->skin.springs && !b->inflation && !b->helium);
    assert_true(!b->damping && !b->correction && !b->strings && b->strings_count == 0);
    assert_true(b->size == 0 && b->scale == 0 && b->turn == 0 && !b->hold_rim);
    scene_free(&def);
}

// The example of the scene format, with its comments.
static void a_scene_with_lists_in_one_line_and_comments_loads(void** state) {
    (void)state;
    static const char text[] =
        "# Figures 19-21: tied by its tail, the squirrel turns upside down.\n"
        "units: paper\n"
        "step: 0.002\n"
        "about: [{output: balloon0.cy, at: 20, tolerance: 0.05}]     # for `needs`\n"
        "balloons:\n"
        "  - model: squirrel.obj                 # or cube, cube-sphere:12, torus:24x12\n"
        "    skin:      {springs: {structural: 50, shear: 10, flexion: 10, law: hooke}}\n"
        "    mass:      {per_particle: 0.001}\n"
        "    inflation: {law: area, amount: 20}\n"
        "    helium:    {base: 20, per_inflation: 5}\n"
        "    damping:   {coefficient: 0.2}       # or {rate: 50}, times mass\n"
        "    strings:   [{to: [0, -6, 0], at: nearest, stiffness: 50, slack: 1.2}]\n";
    WorldDef def;
    must_load(text, NULL, &def);
    assert_string_equal(def.balloons->model, "squirrel.obj");
    assert_true(def.balloons->inflation->amount == 20);
    assert_vector(def.balloons->strings->to, 0, -6, 0);
    scene_free(&def);
}

static void what_an_alias_stands_for_is_copied(void** state) {
    (void)state;
    static const char text[] = "step: 0.01\n"
                               "balloons:\n"
                               "  - model: cube\n"
                               "    mass: &m {per_particle: 0.5}\n"
                               "  - {model: cube, mass: *m}\n";
    WorldDef def;
    must_load(text, NULL, &def);
    assert_true(def.balloons[1].mass.per_particle == 0.5);
    scene_free(&def);

    const char* const set[] = {"balloons.1.mass.per_particle=2", NULL};
    must_load(text, set, &def);
    assert_true(def.balloons[0].mass.per_particle == 0.5);
    assert_true(def.balloons[1].mass.per_particle == 2);
    scene_free(&def);
}

/// `smallest` with one thing wrong: a text, and what is said of which line.
typedef struct Wrong {
    const char* text;
    int line;
    const char* words;
} Wrong;

#define HEAD "step: 0.01\nballoons:\n  - model: cube\n    mass: {per_particle: 0.5}\n"

// clang-format off
static const Wrong wrong_table[] = {
    // keys
    {HEAD "    helum: {base: 2}\n",  5, "no key 'helum' in balloons.0; there are model, position"},
    {HEAD "stp: 2\n",                5, "no key 'stp' in a scene; there are title, units, step"},
    {HEAD "    skin: {springs: {sheer: 1}}\n", 5,
     "no key 'sheer' in balloons.0.skin.springs; there are structural, shear, flexion, torsion, law"},
    {HEAD "    scale: 1\n    scale: 2\n", 6, "'scale' stands twice in balloons.0"},
    {HEAD "[a]: 2\n",                5, "a key in a scene must be a word"},
    {HEAD "\"ti\\0tle\": 2\n",       5, "no key 'ti' in a scene"},
    {"balloons: [{model: cube, mass: {per_particle: 1}}]\n", 1, "a scene needs the key 'step'"},
    {"\nstep: 0.1\n",                2, "a scene needs the key 'balloons'"},
    {"step: 0.1\nballoons: []\n",    2, "balloons needs at least 1"},
    {"step: 0.1\nballoons:\n - mass: {per_particle: 1}\n", 3, "balloons.0 needs the key 'model'"},
    {"step: 0.1\nballoons:\n - model: cube\n", 3, "balloons.0 needs the key 'mass'"},
    {HEAD "    skin: {}\n",          5, "balloons.0.skin needs the key 'springs'"},
    {HEAD "    inflation: {amount: 1}\n", 5, "balloons.0.inflation needs the key 'law'"},
    {HEAD "camera: {eye: [0, 0, 0]}\n", 5, "camera needs the key 'look'"},
    // types
    {"- 1\n- 2\n",                   1, "a scene must be keys with values; there are title"},
    {"hello\n",                      1, "a scene must be keys with values"},
    {HEAD "    skin: soft\n",        5, "balloons.0.skin must be keys with values; there are springs"},
    {HEAD "    skin:\n",             5, "balloons.0.skin must be keys with values"},
    {HEAD "    strings: {to: 1}\n",  5, "balloons.0.strings must be a list"},
    {HEAD "    turn: [1]\n",         5, "balloons.0.turn must be one value, not a list"},
    {HEAD "    turn: {a: 1}\n",      5, "balloons.0.turn must be one value, not keys with values"},
    {HEAD "    turn: fast\n",        5, "balloons.0.turn must be a number, not 'fast'"},
    {HEAD "    turn: 90deg\n",       5, "balloons.0.turn must be a number, not '90deg'"},
    {HEAD "    turn: 0,5\n",         5, "balloons.0.turn must be a number, not '0,5'"},
    {HEAD "    turn: 0x10\n",        5, "balloons.0.turn must be a number, not '0x10'"},
    {HEAD "    turn: nan\n",         5, "balloons.0.turn must be a number, not 'nan'"},
    {HEAD "    turn: -.inf\n",       5, "balloons.0.turn must be a number, not '-.inf'"},
    {HEAD "    turn: --1\n",         5, "balloons.0.turn must be a number, not '--1'"},
    {HEAD "    turn:\n",             5, "balloons.0.turn must be a number, not ''"},
    {HEAD "    turn: 1e999\n",       5, "balloons.0.turn is 1e999, which is beyond the numbers"},
    {HEAD "    turn: 1e-999\n",      5, "balloons.0.turn is 1e-999, which is beyond the numbers"},
    {HEAD "    hold_rim: maybe\n",   5, "balloons.0.hold_rim must be true or false, not 'maybe'"},
    {HEAD "    position: 3\n",       5, "balloons.0.position must be a list of 3 numbers"},
    {HEAD "    position: [1, 2]\n",  5, "balloons.0.position must be 3 numbers, not 2"},
    {HEAD "    color: [1, 1, 1, 1]\n", 5, "balloons.0.color must be 3 numbers, not 4"},
    {HEAD "    position: [1,\n     b, 2]\n", 6, "balloons.0.position.1 must be a number, not 'b'"},
    {HEAD "title: ''\n",             5, "title must not be empty"},
    {HEAD "title: \"a\\0b\"\n",      5, "title has a zero byte in it"},
    // names
    {HEAD "units: imperial\n",       5, "no units 'imperial'; there are si, paper"},
    {HEAD "guard: 1\n",              5, "no guard '1'; there are split, stop, off"},
    {HEAD "precision: half\n",       5, "no precision 'half'; there are any, float, double"},
    {HEAD "    skin: {springs: {structural: 1, law: hook}}\n", 5, "no law 'hook'; there are hooke, rubber"},
    {HEAD "    inflation: {law: air}\n", 5, "no law 'air'; there are none, area, pressure, gas"},
    {HEAD "method: magic\n",         5, "no method 'magic'; there are euler"},
    // keys among each other
    {HEAD "    damping: {rate: 1, coefficient: 2}\n", 5, "balloons.0: give coefficient or rate, not both"},
    {HEAD "    skin: {springs: {}}\n", 5, "no kind of spring has a stiffness"},
    {HEAD "    strings: [{to: [0, 0, 0], stiffness: 1}]\n", 5, "a string needs a skin"},
    {HEAD "    skin: {springs: {shear: 1}}\n    strings: [{stiffness: 1}]\n", 6, "hangs down to the floor"},
    {HEAD "    skin: {springs: {shear: 1}}\n    strings: [{to: [0, 0, 0], at: top, stiffness: 1}]\n", 6,
     "`at` must be nearest, lowest, highest or the number of a particle"},
    {HEAD "    correction: {shear: 0.1}\n", 5, "correction needs springs"},
    {HEAD "    inflation: {law: area, ambient: 1}\n", 5, "only the law gas has an ambient pressure"},
    {HEAD "    inflation: {law: gas,\n      amount: -1}\n", 6, "there is no gas of less than nothing"},
    {HEAD "    inflation: {law: area, least: 2, most: 1}\n", 5, "most must be greater than least"},
    {HEAD "camera: {eye: [0, 1, 0], look: [0, 1, 0]}\n", 5, "the camera's eye is where it looks"},
    // YAML itself
    {HEAD "    color: [1, 1\n",      5, "this is not YAML"},
    {HEAD "   color: 1\n",           5, "this is not YAML"},
    {HEAD "\ttitle: a\n",            5, "this is not YAML"},
    {HEAD "    color: *nothing\n",   5, "this is not YAML: found undefined alias"},
    {HEAD "title: \x01\n",           5, "this is not YAML: control characters are not allowed"},
    {HEAD "title: \xff\n",           5, "this is not YAML: invalid leading UTF-8 octet"},
    {HEAD "---\nstep: 1\n",          6, "a second YAML document begins"},
};
// clang-format on

static void what_is_wrong_is_said_in_one_sentence_with_its_line(void** state) {
    (void)state;
    for (size_t i = 0; i < sizeof wrong_table / sizeof wrong_table[0]; i++) {
        char place[96];
        snprintf(place, sizeof place, "%s:%d", scene, wrong_table[i].line);
        must_refuse(wrong_table[i].text, NULL, place, wrong_table[i].words);
    }
}

// "balloons.*.scale" → "balloons.0.scale"
static void first_of(const char* pattern, char path[128]) {
    snprintf(path, 128, "%s", pattern);
    for (char* c = path; *c; c++)
        if (*c == '*')
            *c = '0';
}

static void must_be_out_of_range(const char* path, double value) {
    char text[192], place[200], words[200];
    snprintf(text, sizeof text, "%s=%.17g", path, value);
    snprintf(place, sizeof place, "--set %s", text);
    snprintf(words, sizeof words, "%s must be", path);
    must_refuse(full, (const char* const[]){text, NULL}, place, words);
}

static void every_row_of_the_ranges_holds_a_number_of_the_format(void** state) {
    (void)state;
    for (int i = 0; i < range_count; i++) {
        const Range* range = &range_table[i];
        char path[128];
        first_of(range->path, path);
        must_be_out_of_range(path, range->least - 1e-6);
        must_be_out_of_range(path, -1e300);
        if (range->least_open)
            must_be_out_of_range(path, range->least);
        if (range->most < INFINITY)
            must_be_out_of_range(path, range->most + 1e-6);
    }
}

static void files_that_are_no_scenes_are_refused(void** state) {
    (void)state;
    must_refuse("", NULL, scene, "this scene is empty; it needs a step and balloons");
    must_refuse("# nothing\n", NULL, scene, "this scene is empty");

    unsigned char bytes[4096];
    unsigned random = 1;
    for (size_t i = 0; i < sizeof bytes; i++)
        bytes[i] = (unsigned char)((random = random * 1664525u + 1013904223u) >> 24);
    WorldDef def;
    Fault fault = {0};
    write_bytes(scene, bytes, sizeof bytes);
    assert_false(scene_load(scene, NULL, 0, &def, &fault));
    assert_non_null(strstr(fault.text, "this is not YAML"));

    fault = (Fault){0};
    remove(scene);
    assert_int_equal(mkdir(scene, 0700), 0);
    assert_false(scene_load(scene, NULL, 0, &def, &fault));
    rmdir(scene);
    assert_string_equal(fault.place, scene);
    assert_string_equal(fault.text, "it cannot be read: Is a directory");
}

static void a_file_that_may_not_be_read_is_refused(void** state) {
    (void)state;
    if (geteuid() == 0)
        skip(); // root may read everything
    WorldDef def;
    Fault fault = {0};
    write_bytes(scene, smallest, strlen(smallest));
    chmod(scene, 0);
    const bool good = scene_load(scene, NULL, 0, &def, &fault);
    chmod(scene, 0600);
    assert_false(good);
    assert_string_equal(fault.place, scene);
    assert_string_equal(fault.text, "it cannot be opened: Permission denied");
}

static void scenes_without_measure_are_refused(void** state) {
    (void)state;
    static char text[(1 << 18) + 2];
    char place[96];
    snprintf(place, sizeof place, "%s:2", scene);

    memset(text, '[', 200000);
    text[0] = '\n';
    must_refuse(text, NULL, place, "no scene has so many brackets in each other");

    memset(text, ' ', sizeof text - 1);
    must_refuse(text, NULL, scene, "a scene has at most 262144 bytes");
}

// A thousand balloons of a thousand strings each, in a few lines.
static void aliases_cannot_ask_for_more_than_a_scene_may_hold(void** state) {
    (void)state;
    static char text[1 << 16];
    size_t length = (size_t)snprintf(text, sizeof text,
                                     "step: 1\nballoons:\n- &b\n  model: cube\n"
                                     "  mass: {per_particle: 1}\n"
                                     "  strings: [&s {stiffness: 1}");
    for (int i = 0; i < 1000; i++)
        length += (size_t)snprintf(text + length, sizeof text - length, ", *s");
    length += (size_t)snprintf(text + length, sizeof text - length, "]\n");
    for (int i = 0; i < 1000; i++)
        length += (size_t)snprintf(text + length, sizeof text - length, "- *b\n");

    WorldDef def;
    Fault fault;
    assert_false(load(text, NULL, &def, &fault));
    assert_non_null(strstr(fault.text, "this scene is too large"));
}

static void an_override_changes_what_the_file_says(void** state) {
    (void)state;
    const char* const set[] = {"step=0.5", "balloons.0.color=[0, 1, 0]",
                               "balloons.0.strings.1.at=lowest", NULL};
    WorldDef def;
    must_load(full, set, &def);
    assert_true(def.step == 0.5);
    assert_vector(def.balloons->color, 0, 1, 0);
    assert_string_equal(def.balloons->strings[1].at, "lowest");
    assert_true(def.balloons->strings[1].stiffness == 7);
    scene_free(&def);
}

static void an_override_makes_the_keys_that_are_absent(void** state) {
    (void)state;
    const char* const set[] = {"balloons.0.inflation.fill={to: 3, seconds: 1}",
                               "balloons.0.inflation.law=area",
                               "title='It''s \"so\": \u00e4 \xf0\x9f\x8e\x88' # not this", NULL};
    WorldDef def;
    must_load(smallest, set, &def);
    assert_true(def.balloons->inflation->law == INFLATE_AREA);
    assert_true(def.balloons->inflation->fill->to == 3);
    assert_string_equal(def.title, "It's \"so\": \u00e4 \xf0\x9f\x8e\x88");
    scene_free(&def);
}

static void the_last_of_two_overrides_holds(void** state) {
    (void)state;
    const char* const set[] = {"step=0.5", "step=0.25", NULL};
    WorldDef def;
    must_load(smallest, set, &def);
    assert_true(def.step == 0.25);
    scene_free(&def);
}

static void an_override_mends_what_is_wrong_in_the_file(void** state) {
    (void)state;
    const char* const set[] = {"step=0.5", NULL};
    WorldDef def;
    must_load("step: 7\nballoons: [{model: cube, mass: {per_particle: 1}}]\n", set, &def);
    assert_true(def.step == 0.5);
    scene_free(&def);
}

static void a_fault_of_the_file_keeps_its_line_under_overrides(void** state) {
    (void)state;
    char place[96];
    snprintf(place, sizeof place, "%s:5", scene);
    const char* const set[] = {"step=0.5", "balloons.0.turn=1", NULL};
    must_refuse(HEAD "    scale: 0\n", set, place, "balloons.0.scale must be greater than 0");
}

static void what_an_override_does_wrong_is_said_of_it(void** state) {
    (void)state;
    // clang-format off
    static const char* const wrong[][2] = {
        {"balloons.0.foo=3",      "no key 'foo' in balloons.0; there are model"},
        {"foo.bar=3",             "no key 'foo' in a scene"},
        {"step=2",                "step must be greater than 0 and at most 1, not 2"},
        {"step=",                 "step must be a number, not ''"},
        {"step",                  "this is not KEY=VALUE"},
        {"=3",                    "this is not KEY=VALUE"},
        {"",                      "this is not KEY=VALUE"},
        {"step.foo=3",            "step is one value and has no keys"},
        {"balloons.1.scale=3",    "balloons has no item '1'; it has 1, from 0"},
        {"balloons.-1.scale=3",   "balloons has no item '-1'"},
        {"balloons.00x.scale=3",  "balloons has no item '00x'"},
        {"balloons.99999999999999999999=3", "balloons has no item '99999999999999999999'"},
        {"balloons.0.color.1=1",  "there is no list balloons.0.color yet"},
        {"balloons.0.color=[1, 1", "this is not YAML"},
        {"balloons.0.color=red",  "balloons.0.color must be a list of 3 numbers"},
        {"balloons.0=&a [*a]",    "this value is too large"},
        {"balloons.0.damping={rate: 1, coefficient: 1}", "give coefficient or rate, not both"},
        {"balloons.0.mass.rate=2", "no key 'rate' in balloons.0.mass; there are per_particle"},
        {"method=magic",          "no method 'magic'; there are euler"},
    };
    // clang-format on
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        char place[128];
        snprintf(place, sizeof place, "--set %s", wrong[i][0]);
        must_refuse(smallest, (const char* const[]){wrong[i][0], NULL}, place, wrong[i][1]);
    }
}

static void a_bare_mesh_is_a_balloon_on_a_string(void** state) {
    (void)state;
    const SceneSet set[] = {{"balloons.0.inflation.amount=7"}};
    WorldDef def;
    Fault fault = {0};
    assert_true(shape_count > 0);
    for (int i = 0; i < shape_count; i++) {
        assert_true(scene_load(shape_table[i].name, set, 1, &def, &fault));
        assert_string_equal(def.balloons->model, shape_table[i].name);
        assert_true(def.balloons->skin.springs->structural == 50 && def.balloons->size == 2);
        assert_true(def.balloons->inflation->amount == 7 && def.floor);
        assert_string_equal(def.balloons->strings->at, "lowest");
        scene_free(&def);
    }
}

static void a_mesh_is_named_by_its_path_and_found_again(void** state) {
    (void)state;
    WorldDef def;
    Fault fault = {0};
    write_bytes(beside, "v 0 0 0\n", 8);
    assert_true(scene_load(beside, NULL, 0, &def, &fault));
    char path[512];
    assert_true(scene_model_path(&def, def.balloons->model, path, &fault));
    assert_string_equal(path, beside);
    scene_free(&def);
}

static void a_model_is_found_beside_its_scene(void** state) {
    (void)state;
    WorldDef def;
    Fault fault = {0};
    char path[512];
    write_bytes(beside, "v 0 0 0\n", 8);
    must_load(smallest, NULL, &def);

    assert_true(scene_model_path(&def, "beside.obj", path, &fault));
    assert_string_equal(path, beside);
    assert_true(scene_model_path(&def, beside, path, &fault));
    assert_string_equal(path, beside);
    assert_true(scene_model_path(&def, "cube", path, &fault));
    assert_string_equal(path, "cube");
    assert_false(scene_model_path(&def, "none.obj", path, &fault));
    assert_string_equal(fault.place, scene);
    assert_non_null(strstr(fault.text, "no model 'none.obj'; it is not beside the scene, in "
                                       "assets/models or in the working folder"));
    scene_free(&def);
}

static void every_shipped_scene_is_found_by_its_name(void** state) {
    (void)state;
    char** path;
    const int count = scene_list(&path);
    for (int i = 0; i < count; i++) {
        assert_true(i == 0 || strcmp(path[i - 1], path[i]) < 0);
        char name[256];
        scene_name(path[i], name);
        assert_null(strstr(name, ".yaml"));
        WorldDef def;
        Fault fault = {0};
        if (!scene_load(name, NULL, 0, &def, &fault))
            fail_msg("%s: %s", fault.place, fault.text);
        assert_string_equal(def.file, path[i]);
        scene_free(&def);
    }
    for (int i = 0; i < count; i++)
        free(path[i]);
    free(path);
}

static void a_name_that_is_nothing_is_told_what_there_is(void** state) {
    (void)state;
    static const char* const name[] = {
        "nothing", "nothing.yaml", "nothing.obj", "nothing:3", "", "/", ".."};
    for (size_t i = 0; i < sizeof name / sizeof name[0]; i++) {
        WorldDef def;
        Fault fault = {0};
        assert_false(scene_load(name[i], NULL, 0, &def, &fault));
        assert_string_equal(fault.place, name[i]);
        assert_non_null(strstr(fault.text, "there is no such scene or mesh, here or in "
                                           "assets/scenes and assets/models; scenes are "));
        assert_non_null(strstr(fault.text, shape_table[0].name));
    }
}

static void numbers_have_a_point_in_every_locale(void** state) {
    (void)state;
    static const char* const with_comma[] = {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "fr_FR"};
    bool found = false;
    for (int i = 0; i < 4 && !found; i++)
        found = setlocale(LC_NUMERIC, with_comma[i]);
    if (!found)
        skip(); // this machine has no locale with a comma
    WorldDef def;
    Fault fault;
    const bool good = load(full, NULL, &def, &fault);
    char one[8];
    snprintf(one, sizeof one, "%.1f", 0.5);
    setlocale(LC_NUMERIC, "C");
    assert_string_equal(one, "0,5");
    assert_true(good && def.step == 0.002);
    scene_free(&def);
}

static unsigned next_random(unsigned* random) {
    *random = *random * 1664525u + 1013904223u; // Numerical Recipes
    return *random >> 8;
}

static void a_mutated_scene_is_loaded_or_refused_in_one_sentence(void** state) {
    (void)state;
    static const char pieces[] = "{}[]:,-#&*!|>'\"%@`?\n \t0123456789.eabc\x01\xff";
    unsigned random = 20240229;
    for (int n = 0; n < MUTATIONS; n++) {
        char text[sizeof full];
        memcpy(text, full, sizeof full);
        for (unsigned k = next_random(&random) % 6 + 1; k > 0; k--)
            text[next_random(&random) % (sizeof full - 1)] =
                pieces[next_random(&random) % (sizeof pieces - 1)];
        WorldDef def;
        Fault fault;
        if (load(text, NULL, &def, &fault)) {
            assert_true(def.balloons_count >= 1 && def.step > 0);
            scene_free(&def);
        } else {
            assert_true(fault.text[0] && !strchr(fault.text, '\n'));
            assert_int_equal(strncmp(fault.place, scene, strlen(scene)), 0);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_key_of_a_world_loads_into_its_field),
        cmocka_unit_test(every_key_of_spheres_and_walls_loads_into_its_field),
        cmocka_unit_test(every_key_of_a_balloon_loads_into_its_field),
        cmocka_unit_test(every_key_of_inflation_and_strings_loads_into_its_field),
        cmocka_unit_test(what_a_scene_does_not_name_is_absent),
        cmocka_unit_test(a_scene_with_lists_in_one_line_and_comments_loads),
        cmocka_unit_test(what_an_alias_stands_for_is_copied),
        cmocka_unit_test(what_is_wrong_is_said_in_one_sentence_with_its_line),
        cmocka_unit_test(every_row_of_the_ranges_holds_a_number_of_the_format),
        cmocka_unit_test(files_that_are_no_scenes_are_refused),
        cmocka_unit_test(a_file_that_may_not_be_read_is_refused),
        cmocka_unit_test(scenes_without_measure_are_refused),
        cmocka_unit_test(aliases_cannot_ask_for_more_than_a_scene_may_hold),
        cmocka_unit_test(an_override_changes_what_the_file_says),
        cmocka_unit_test(an_override_makes_the_keys_that_are_absent),
        cmocka_unit_test(the_last_of_two_overrides_holds),
        cmocka_unit_test(an_override_mends_what_is_wrong_in_the_file),
        cmocka_unit_test(a_fault_of_the_file_keeps_its_line_under_overrides),
        cmocka_unit_test(what_an_override_does_wrong_is_said_of_it),
        cmocka_unit_test(a_bare_mesh_is_a_balloon_on_a_string),
        cmocka_unit_test(a_mesh_is_named_by_its_path_and_found_again),
        cmocka_unit_test(a_model_is_found_beside_its_scene),
        cmocka_unit_test(every_shipped_scene_is_found_by_its_name),
        cmocka_unit_test(a_name_that_is_nothing_is_told_what_there_is),
        cmocka_unit_test(numbers_have_a_point_in_every_locale),
        cmocka_unit_test(a_mutated_scene_is_loaded_or_refused_in_one_sentence),
    };
    return cmocka_run_group_tests_name("scene", tests, make_folder, remove_folder);
}
