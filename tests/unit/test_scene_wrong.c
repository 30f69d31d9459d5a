/// Each mistake in a scene gives one sentence with its line.
#include "scenes.h"

/// `smallest` with one mistake: a text, the line of the fault and words of its sentence.
typedef struct Wrong {
    const char* text;
    int line;
    const char* words;
} Wrong;

// clang-format off
static const Wrong wrong_table[] = {
    // keys
    {HEAD "    helum: {base: 2}\n",  5, "no key 'helum' in balloons.0; there are model, position"},
    {HEAD "stp: 2\n",                5, "no key 'stp' in a scene; there are title, units, step"},
    {HEAD "    skin: {springs: {sheer: 1}}\n", 5,
     "no key 'sheer' in balloons.0.skin.springs; there are structural, shear, flexion, torsion, law"},
    {HEAD "    scale: 1\n    scale: 2\n", 6, "'scale' stands twice in balloons.0"},
    {HEAD "[a]: 2\n",                5, "a key in a scene must be a word"},
    {HEAD "walls: [{at: [0, 0, 0], normal: [0, 0, 0]}]\n", 5, "a wall's normal points somewhere"},
    {HEAD "\"ti\\0tle\": 2\n",       5, "no key 'ti' in a scene"},
    {"balloons: [{model: cube, mass: {per_particle: 1}}]\n", 1, "a scene needs the key 'step'"},
    {"\nstep: 0.1\n",                2, "a scene needs the key 'balloons'"},
    {"step: 0.1\nballoons: []\n",    2, "balloons needs at least 1"},
    {"step: 0.1\nballoons:\n - mass: {per_particle: 1}\n", 3, "balloons.0 needs the key 'model'"},
    {"step: 0.1\nballoons:\n - model: cube\n", 3, "give the mass of a particle"},
    {HEAD "    skin: {springs: {structural: 1}, membrane: {material: stvk, young: 1, density: 1,\n"
          "      thickness: 1}}\n",  5, "a skin is of springs or a membrane, not both"},
    {HEAD "    skin: {membrane: {young: 1, density: 1, thickness: 1}}\n", 5,
     "balloons.0.skin.membrane needs the key 'material'"},
    {HEAD "    skin: {membrane: {material: stvk, young: 1, density: 1, thickness: 1}}\n", 4,
     "a membrane has the mass of its rubber"},
    {RUBBER "material: stvk-3d, volume: global}}\ncontacts: {self: true}\n", 4,
     "a skin that touches skins or things needs `volume: local`"},
    {RUBBER "material: stvk-3d, volume: global}}\nthings: [{model: box}]\n", 4,
     "a skin that touches skins or things needs `volume: local`"},
    {RUBBER "material: cheese}}\n", 4, "no material 'cheese'; there are neo-hookean"},
    {RUBBER "material: stvk-3d, poisson: 0.5}}\n", 4, "poisson must be greater than -1 and less than 0.5"},
    {RUBBER "material: neo-hookean, poisson: 0.4}}\n", 4, "poisson must be 0.5, not 0.4"},
    {RUBBER "material: stvk, mooney: 0.1}}\n", 4, "no key 'mooney' in balloons.0.skin.membrane of stvk; there are material"},
    {RUBBER "material: stvk}}\n    inflation: {law: gas, amount: 1, filling: xenon}\n", 5,
     "no filling 'xenon'; there are air, helium"},
    {RUBBER "material: stvk}}\n    inflation: {law: pressure, amount: 1, leak: 1}\n", 5,
     "are for the law gas"},
    {RUBBER "material: stvk}}\npipes: [{from: 0, to: 0, conductance: 1}]\n", 5,
     "a pipe joins two balloons with gas"},
    {HEAD "    inflation: {amount: 1}\n", 5, "balloons.0.inflation needs the key 'law'"},
    {HEAD "camera: {eye: [0, 0, 0]}\n", 5, "camera needs the key 'look'"},
    // types
    {"- 1\n- 2\n",                   1, "a scene must be keys with values; there are title"},
    {"hello\n",                      1, "a scene must be keys with values"},
    {HEAD "    skin: soft\n",        5, "balloons.0.skin must be keys with values; there are springs, membrane"},
    {HEAD "    skin:\n",             5, "balloons.0.skin must be keys with values"},
    {HEAD "    strings: {to: 1}\n",  5, "balloons.0.strings must be a list"},
    {HEAD "    rotation: [1]\n",         5, "balloons.0.rotation must be one value, not a list"},
    {HEAD "    rotation: {a: 1}\n",      5, "balloons.0.rotation must be one value, not keys with values"},
    {HEAD "    rotation: fast\n",        5, "balloons.0.rotation must be a number, not 'fast'"},
    {HEAD "    rotation: 90deg\n",       5, "balloons.0.rotation must be a number, not '90deg'"},
    {HEAD "    rotation: 0,5\n",         5, "balloons.0.rotation must be a number, not '0,5'"},
    {HEAD "    rotation: 0x10\n",        5, "balloons.0.rotation must be a number, not '0x10'"},
    {HEAD "    rotation: nan\n",         5, "balloons.0.rotation must be a number, not 'nan'"},
    {HEAD "    rotation: -.inf\n",       5, "balloons.0.rotation must be a number, not '-.inf'"},
    {HEAD "    rotation: --1\n",         5, "balloons.0.rotation must be a number, not '--1'"},
    {HEAD "    rotation:\n",             5, "balloons.0.rotation must be a number, not ''"},
    {HEAD "    rotation: 1e999\n",       5, "balloons.0.rotation is 1e999, which is beyond the numbers"},
    {HEAD "    rotation: 1e-999\n",      5, "balloons.0.rotation is 1e-999, which is beyond the numbers"},
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
    {HEAD "    strain_limit: {shear: 0.1}\n", 5, "a strain limit needs springs"},
    {HEAD "    inflation: {law: area, ambient: 1}\n", 5, "are for the law gas"},
    {HEAD "    inflation: {law: gas,\n      amount: -1}\n", 6, "there is no gas of less than nothing"},
    {HEAD "    inflation: {law: area, min: 2, max: 1}\n", 5, "max must be greater than min"},
    {HEAD "camera: {eye: [0, 1, 0], look: [0, 1, 0]}\n", 5, "the camera's eye is where it looks"},
    {HEAD "fails: {at: 1}\n", 5, "a failure is halts: true, or an output"},
    {HEAD "fails: {at: 1, output: balloon0.cy, above: 1, below: 2}\n", 5, "a failure is halts"},
    {HEAD "fails: {at: 1, halts: true, output: balloon0.cy}\n", 5, "a failure is halts: true"},
    {HEAD "things: [{model: box, path: [{at: 1, position: [0, 0, 0]}, {at: 1, position: [0, 0, 1]}]}]\n", 5,
     "things.0: the times of a path must increase"},
    {HEAD "things: [{model: box, path: [{at: 0, position: [0, 0, 0]}, {at: 1, position: [0, 51, 0]}]}]\n", 5,
     "things.0: a path is followed at 50 m/s at most"},
    {HEAD "things: [{model: box, position: [0, 0, 0], path: [{position: [0, 0, 0]}]}]\n", 5,
     "things.0: give position or path, not both"},
    {HEAD "    skin: {springs: {structural: 1}}\n    strings: [{to_knot: 0, stiffness: 1}]\n", 6, "balloons.0: a string leads to nothing: to_balloon must be the number of another balloon, to_knot that of"},
    {HEAD "    skin: {springs: {structural: 1}}\n    strings: [{to_balloon: 0, stiffness: 1}]\n", 6, "to_balloon must be the number of another balloon"},
    {HEAD "    skin: {springs: {structural: 1}}\n    strings: [{to_knot: 0, to: [0, 1, 0], stiffness: 1}]\nknots: [{position: [0, 0, 0]}]\n", 6,
     "a string leads to one end"},
    {HEAD "knots: [{mass: 1}]\n", 5, "knots.0: give its position, or its path"},
    {HEAD "knots: [{mass: 1, path: [{position: [0, 0, 0]}]}]\n", 5, "knots.0: a knot on a path is held"},
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
        char location[96];
        snprintf(location, sizeof location, "%s:%d", scene, wrong_table[i].line);
        must_refuse(wrong_table[i].text, NULL, location, wrong_table[i].words);
    }
}

// "balloons.*.scale" → "balloons.0.scale"; the second balloon is the one of rubber
static void first_of(const char* pattern, char path[128]) {
    snprintf(path, 128, "%s", pattern);
    if (strstr(pattern, "membrane"))
        *strchr(path, '*') = '1';
    for (char* c = path; *c; c++)
        if (*c == '*')
            *c = '0';
}

static void must_be_out_of_range(const char* path, const char* of, double value) {
    char text[192], location[200], words[200], skin[192];
    snprintf(skin, sizeof skin,
             "balloons.1.skin={membrane: {material: %s, young: 1, density: 1, thickness: 1}}", of);
    snprintf(text, sizeof text, "%s=%.17g", path, value);
    snprintf(location, sizeof location, "--set %s", text);
    snprintf(words, sizeof words, "%s must be", path);
    const char* const set[] = {of ? skin : text, text, NULL};
    must_refuse(full, set, location, words);
}

static void out_of_range_is_refused(const char* pattern, const Key* key, void* ranges) {
    const Parameter* range = &key->is;
    if (range->min == -INFINITY && range->max == INFINITY)
        return;
    char path[128];
    first_of(pattern, path);
    if (key->type == KEY_VECTOR)
        strcat(path, ".0");
    *(int*)ranges += 1;
    must_be_out_of_range(path, key->of, range->min - 1e-6);
    must_be_out_of_range(path, key->of, -1e300);
    if (range->min_open)
        must_be_out_of_range(path, key->of, range->min);
    if (range->max < INFINITY)
        must_be_out_of_range(path, key->of, range->max + 1e-6);
}

static void every_range_of_the_table_holds_a_number_of_the_format(void** state) {
    (void)state;
    int ranges = 0;
    key_each(out_of_range_is_refused, &ranges);
    assert_true(ranges >= 47);
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
    assert_string_equal(fault.location, scene);
    assert_string_equal(fault.text, "it is a folder; name a file in it");

    fault = (Fault){0};
    assert_int_equal(mkfifo(scene, 0600), 0);
    assert_false(scene_load(scene, NULL, 0, &def, &fault));
    remove(scene);
    assert_string_equal(fault.text, "it is a pipe or a device; name a file");
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
    assert_string_equal(fault.location, scene);
    assert_string_equal(fault.text, "it cannot be opened: Permission denied");
}

static void scenes_without_measure_are_refused(void** state) {
    (void)state;
    static char text[(1 << 18) + 2];
    char location[96];
    snprintf(location, sizeof location, "%s:2", scene);

    memset(text, '[', 200000);
    text[0] = '\n';
    must_refuse(text, NULL, location, "no scene has so many brackets in each other");

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
            assert_int_equal(strncmp(fault.location, scene, strlen(scene)), 0);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_wrong_is_said_in_one_sentence_with_its_line),
        cmocka_unit_test(every_range_of_the_table_holds_a_number_of_the_format),
        cmocka_unit_test(files_that_are_no_scenes_are_refused),
        cmocka_unit_test(a_file_that_may_not_be_read_is_refused),
        cmocka_unit_test(scenes_without_measure_are_refused),
        cmocka_unit_test(aliases_cannot_ask_for_more_than_a_scene_may_hold),
        cmocka_unit_test(a_mutated_scene_is_loaded_or_refused_in_one_sentence),
    };
    return cmocka_run_group_tests_name("scene_wrong", tests, make_folder, remove_folder);
}
