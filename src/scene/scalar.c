/// Numbers, names, flags and texts of a scene.
#include "scene/validate.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/real.h"
#include "base/table.h"

/// Remember the first number that is in its range, but of no use as a `real`: 1e39 is infinite in
/// float, and 1e-20 has a square of 0.
static void note_beyond(Validator* validator, const Key* key, int id, double value) {
    const real rounded = (real)value;
    if (validator->beyond || (real_holds(value) && key_allows(&key->is, (double)rounded)))
        return;
    validator->beyond = id;
    memcpy(validator->beyond_path, validator->path, sizeof validator->path);
}

static bool store_number(Validator* validator, const Key* key, int id, const char* word,
                         double* number) {
    // digits first: strtod alone would take nan, infinity and hexadecimals
    char* end = NULL;
    errno = 0;
    const bool digits = word[0] && !word[strspn(word, "0123456789+-.eE")];
    const double value = digits ? strtod(word, &end) : 0;
    const char* subject = validate_subject(validator);
    if (!digits || *end)
        return tree_fault(validator->tree, id, validator->fault, "%s must be a number, not '%.64s'",
                          subject, word);
    if (errno == ERANGE || !isfinite(value))
        return tree_fault(validator->tree, id, validator->fault,
                          "%s is %.64s, which is beyond the numbers of this machine", subject,
                          word);
    if (!key_allows(&key->is, value)) {
        char words[96];
        key_range(&key->is, words);
        return tree_fault(validator->tree, id, validator->fault, "%s must be %s, not %.64s",
                          subject, words, word);
    }
    note_beyond(validator, key, id, value);
    *number = value;
    return true;
}

static bool store_optional(Validator* validator, const Key* key, int id, const char* word,
                           double** number) {
    *number = pool_array(validator->pool, 1, sizeof **number);
    return store_number(validator, key, id, word, *number);
}

// The enum of a name is the name's index; enums are ints, as C's constants are.
static bool store_name(Validator* validator, const Key* key, int id, const char* word, int* name) {
    const char* const* row = table_row_of(key->name, key->name_count, sizeof *key->name, word);
    if (row) {
        *name = (int)(row - key->name);
        return true;
    }
    char names[256];
    return tree_fault(
        validator->tree, id, validator->fault, "no %s '%.64s'; there are %s", key->is.name, word,
        table_names_of(key->name, key->name_count, sizeof *key->name, names, sizeof names));
}

static bool store_flag(Validator* validator, int id, const char* word, bool* flag) {
    *flag = strcmp(word, "true") == 0;
    return *flag || strcmp(word, "false") == 0 ||
           tree_fault(validator->tree, id, validator->fault,
                      "%s must be true or false, not '%.64s'", validate_subject(validator), word);
}

static bool store_text(Validator* validator, const Key* key, int id, const char* word,
                       char** text) {
    const size_t length = strlen(word);
    if (length == 0)
        return tree_fault(validator->tree, id, validator->fault, "%s must not be empty",
                          validate_subject(validator));
    if (length > key->longest)
        return tree_fault(validator->tree, id, validator->fault, "%s must be at most %u bytes long",
                          validate_subject(validator), key->longest);
    if (key->table && !table_find(key->table, *key->table_count, word)) {
        char names[256];
        return tree_fault(validator->tree, id, validator->fault, "no %s '%s'; there are %s",
                          key->is.name, word,
                          table_names(key->table, *key->table_count, names, sizeof names));
    }
    *text = pool_array(validator->pool, length + 1, 1);
    memcpy(*text, word, length);
    return true;
}

bool validate_scalar(Validator* validator, const Key* key, int id, void* field) {
    const yaml_node_t* node = tree_node(validator->tree, id);
    if (node->type != YAML_SCALAR_NODE)
        return tree_fault(validator->tree, id, validator->fault, "%s must be one value, not %s",
                          validate_subject(validator),
                          node->type == YAML_MAPPING_NODE ? "keys with values" : "a list");
    const char* word = (const char*)node->data.scalar.value;
    if (strlen(word) != node->data.scalar.length)
        return tree_fault(validator->tree, id, validator->fault, "%s has a zero byte in it",
                          validate_subject(validator));

    if (key->type == KEY_OPTIONAL)
        return store_optional(validator, key, id, word, field);
    if (key->type == KEY_NAME)
        return store_name(validator, key, id, word, field);
    if (key->type == KEY_FLAG)
        return store_flag(validator, id, word, field);
    if (key->type == KEY_TEXT || key->type == KEY_TEXTS)
        return store_text(validator, key, id, word, field);
    return store_number(validator, key, id, word, field);
}
