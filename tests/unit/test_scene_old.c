/// Earlier names of keys are read, in files and in overrides, with a message.
#include "scenes.h"

/// `full` with one key by its earlier name; false if no line begins with the key.
static bool with_old_name(const Key* key, char text[sizeof full + 16]) {
    char name[64];
    snprintf(name, sizeof name, "%s: ", key->is.name);
    const char* at = strstr(full, name);
    while (at && at > full && !strchr(" \n{", at[-1]))
        at = strstr(at + 1, name);
    if (!at)
        return false;
    snprintf(text, sizeof full + 16, "%.*s%s: %s", (int)(at - full), full, key->old,
             at + strlen(name));
    return true;
}

static char* text_of(const char* text, const char* set) {
    Fault fault = {0};
    write_bytes(scene, text, strlen(text));
    char* read = scene_text(scene, &(SceneSet){set}, set ? 1 : 0, false, &fault);
    if (!read)
        fail_msg("%s: %s", fault.location, fault.text);
    return read;
}

static void must_read_the_same(const char* text, const char* set, const char* old_text,
                               const char* old_set, const Key* key) {
    char* now = text_of(text, set);
    char* before = text_of(old_text, old_set);
    assert_string_equal(now, before);
    free(now);
    free(before);

    char words[160];
    WorldDef def;
    must_load(old_text, (const char* const[]){old_set, NULL}, &def);
    snprintf(words, sizeof words, "%s is now %s", key->old, key->is.name);
    assert_string_equal(def.renamed, words);
    scene_free(&def);
}

static void old_name_is_read(const char* pattern, const Key* key, void* count) {
    char text[sizeof full + 16], path[128], set[192], old_set[192];
    if (!key->old)
        return;
    *(int*)count += 1;
    assert_true(with_old_name(key, text));
    must_read_the_same(full, NULL, text, NULL, key);

    // an override by either name sets the same key, also if the file uses the other name
    snprintf(path, sizeof path, "%s", pattern);
    for (char* c = path; *c; c++)
        if (*c == '*')
            *c = '0';
    const char* value = key->type == KEY_POINTER  ? "{}"
                        : key->type == KEY_VECTOR ? "[0.75, 0, 0]"
                                                  : "0.75";
    const int parent = (int)(strlen(path) - strlen(key->is.name));
    snprintf(set, sizeof set, "%s=%s", path, value);
    snprintf(old_set, sizeof old_set, "%.*s%s=%s", parent, path, key->old, value);
    must_read_the_same(full, set, full, old_set, key);
    must_read_the_same(full, set, text, set, key);
}

static void every_earlier_name_of_a_key_is_read_and_told(void** state) {
    (void)state;
    int count = 0;
    key_each(old_name_is_read, &count);
    assert_true(count >= 5);
}

static void a_scene_of_present_names_tells_nothing(void** state) {
    (void)state;
    WorldDef def;
    must_load(full, (const char* const[]){"balloons.0.rotation=3", NULL}, &def);
    assert_string_equal(def.renamed, "");
    scene_free(&def);
}

static void an_earlier_name_below_an_override_is_read(void** state) {
    (void)state;
    WorldDef def;
    must_load(smallest,
              (const char* const[]){"balloons=[{model: cube, turn: 5, mass: "
                                    "{per_particle: 1}}]",
                                    NULL},
              &def);
    assert_true(def.balloons->rotation == 5);
    assert_string_equal(def.renamed, "turn is now rotation");
    scene_free(&def);
}

static void both_names_at_once_are_refused(void** state) {
    (void)state;
    char location[96];
    snprintf(location, sizeof location, "%s:6", scene);
    must_refuse(HEAD "    rotation: 1\n    turn: 2\n", NULL, location, "'rotation' stands twice");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_earlier_name_of_a_key_is_read_and_told),
        cmocka_unit_test(a_scene_of_present_names_tells_nothing),
        cmocka_unit_test(an_earlier_name_below_an_override_is_read),
        cmocka_unit_test(both_names_at_once_are_refused),
    };
    return cmocka_run_group_tests_name("scene_old", tests, make_folder, remove_folder);
}
