#include "scene/validate.h"

#include <math.h>
#include <string.h>

#include "base/real.h"

static bool validate_value(Validator* validator, const Key* key, int node, char* at);

const char* validate_subject(const Validator* validator) {
    return validator->path[0] ? validator->path : "a scene";
}

/// Append a key or an item's number to the path; the length to go back to.
static size_t enter(Validator* validator, const char* part) {
    const size_t length = strlen(validator->path);
    snprintf(validator->path + length, sizeof validator->path - length, "%s%s", length ? "." : "",
             part);
    return length;
}

static void leave(Validator* validator, size_t length) {
    validator->path[length] = '\0';
}

// A scene has at most SCENE_NODES_MAX values.
static bool count_node(Validator* validator, int node) {
    return ++validator->nodes <= SCENE_NODES_MAX ||
           tree_fault(validator->tree, node, validator->fault,
                      "this scene is too large; at most %d values, please", SCENE_NODES_MAX);
}

static bool has_required(Validator* validator, const KeyGroup* group, int node) {
    Key key;
    for (int i = 0; key_at(group, i, &key); i++) {
        const char* name = key.is.name;
        if (key.required && !tree_slot(validator->tree, node, name, strlen(name)))
            return tree_fault(validator->tree, node, validator->fault, "%s needs the key '%s'",
                              validate_subject(validator), name);
    }
    return true;
}

/// The row of a key of a mapping whose selector is `of`; false with a fault where there is none.
static bool known_key(Validator* validator, const KeyGroup* group, const char* of, int mapping,
                      const yaml_node_pair_t* pair, Key* key) {
    const yaml_node_t* word = tree_node(validator->tree, pair->key);
    const char* subject = validate_subject(validator);
    if (word->type != YAML_SCALAR_NODE)
        return tree_fault(validator->tree, pair->key, validator->fault,
                          "a key in %s must be a word", subject);
    const char* name = (const char*)word->data.scalar.value;
    const size_t length = strlen(name);
    if (length != word->data.scalar.length || !key_find(group, of, name, key)) {
        char names[512];
        key_names(group, of, names, sizeof names);
        return tree_fault(validator->tree, pair->key, validator->fault,
                          "no key '%.64s' in %s%s%s; there are %s", name, subject, of ? " of " : "",
                          of ? of : "", names);
    }
    return tree_slot(validator->tree, mapping, name, length) == &pair->value ||
           tree_fault(validator->tree, pair->key, validator->fault, "'%s' stands twice in %s", name,
                      subject);
}

/// Store the default of each number that has one.
static void store_defaults(const KeyGroup* group, const char* of, char* filled) {
    Key key;
    for (int i = 0; key_at(group, i, &key); i++)
        if (key.type == KEY_NUMBER && isfinite(key.is.default_value) && key_is_of(&key, of))
            memcpy(filled + key.offset, &key.is.default_value, sizeof(double));
        else if (key.type == KEY_MAPPING)
            store_defaults(key.group, NULL, filled + key.offset);
}

/// The word of the group's selector, NULL where it has none. False where it is no row's name.
static bool read_selector(Validator* validator, const KeyGroup* group, int mapping, char* filled,
                          const char** of) {
    *of = NULL;
    const char* name = group->selector;
    const int* slot = name ? tree_slot(validator->tree, mapping, name, strlen(name)) : NULL;
    Key key;
    if (!slot || !key_find(group, NULL, name, &key))
        return true;
    const size_t length = enter(validator, name);
    if (!validate_value(validator, &key, *slot, filled))
        return false;
    leave(validator, length);
    memcpy(of, filled + key.offset, sizeof *of);
    return true;
}

/// Fill the struct of a group from a mapping.
static bool validate_group(Validator* validator, const KeyGroup* group, int id, char* filled) {
    const yaml_node_t* node = tree_node(validator->tree, id);
    if (!count_node(validator, id))
        return false;
    if (node->type != YAML_MAPPING_NODE) {
        char names[512];
        key_names(group, NULL, names, sizeof names);
        return tree_fault(validator->tree, id, validator->fault,
                          "%s must be keys with values; there are %s", validate_subject(validator),
                          names);
    }
    const char* of;
    if (!read_selector(validator, group, id, filled, &of))
        return false;
    store_defaults(group, of, filled);
    const yaml_node_pair_t* pair = node->data.mapping.pairs.start;
    for (; pair < node->data.mapping.pairs.top; pair++) {
        Key key;
        if (!known_key(validator, group, of, id, pair, &key))
            return false;
        const size_t length = enter(validator, key.is.name);
        if (!validate_value(validator, &key, pair->value, filled))
            return false;
        leave(validator, length);
    }
    return has_required(validator, group, id);
}

/// A list's length, or -1 with a fault.
static long list_length(Validator* validator, const Key* key, int id) {
    const yaml_node_t* node = tree_node(validator->tree, id);
    const char* subject = validate_subject(validator);
    const bool vector = key->type == KEY_VECTOR;
    const long count = node->type == YAML_SEQUENCE_NODE
                           ? node->data.sequence.items.top - node->data.sequence.items.start
                           : -1;
    if (count < 0 && vector)
        tree_fault(validator->tree, id, validator->fault,
                   "%s must be a list of 3 numbers, as in [0, 1, 0]", subject);
    else if (count < 0)
        tree_fault(validator->tree, id, validator->fault, "%s must be a list", subject);
    else if (vector && count != 3)
        tree_fault(validator->tree, id, validator->fault, "%s must be 3 numbers, not %ld", subject,
                   count);
    else if (count < key->shortest)
        tree_fault(validator->tree, id, validator->fault, "%s needs at least %u", subject,
                   key->shortest);
    else
        return count;
    return -1;
}

static size_t item_size(const Key* key) {
    return key->group ? key->group->size : key->type == KEY_TEXTS ? sizeof(char*) : sizeof(double);
}

/// Fill an array from a list: of numbers, texts or mappings.
static bool validate_list(Validator* validator, const Key* key, int id, char* filled) {
    const long count = count_node(validator, id) ? list_length(validator, key, id) : -1;
    if (count < 0)
        return false;
    char* item = pool_array(validator->pool, (size_t)count, item_size(key));
    memcpy(filled + key->offset, &item, sizeof item);
    if (key->count_offset)
        *(unsigned*)(void*)(filled + key->count_offset) = (unsigned)count;

    for (long i = 0; i < count; i++, item += item_size(key)) {
        const int node = tree_node(validator->tree, id)->data.sequence.items.start[i];
        char number[24];
        snprintf(number, sizeof number, "%ld", i);
        const size_t length = enter(validator, number);
        if (key->group
                ? !validate_group(validator, key->group, node, item)
                : !count_node(validator, node) || !validate_scalar(validator, key, node, item))
            return false;
        leave(validator, length);
    }
    return true;
}

/// Store the value of a key in the struct of its group.
static bool validate_value(Validator* validator, const Key* key, int node, char* filled) {
    char* field = filled + key->offset;
    if (key->type == KEY_MAPPING)
        return validate_group(validator, key->group, node, field);
    if (key->type == KEY_POINTER) {
        const KeyGroup group = key_group(key);
        char* below = pool_array(validator->pool, 1, group.size);
        memcpy(field, &below, sizeof below);
        return validate_group(validator, &group, node, below);
    }
    if (key->type == KEY_LIST || key->type == KEY_VECTOR || key->type == KEY_TEXTS)
        return validate_list(validator, key, node, filled);
    return count_node(validator, node) && validate_scalar(validator, key, node, field);
}

bool validate_scene(const SceneTree* tree, WorldDef* def, Fault* fault) {
    Validator validator = {.tree = tree, .fault = fault, .pool = &def->pool};
    if (!validate_group(&validator, &scene_keys, TREE_ROOT, (char*)def))
        return false;

    // a scene for the other precision is read before its program is called
    const bool is_double = sizeof(real) == sizeof(double);
    const bool is_other = def->precision == (is_double ? PRECISION_FLOAT : PRECISION_DOUBLE);
    if (!validator.beyond || is_other)
        return true;
    const yaml_node_t* node = tree_node(tree, validator.beyond);
    return tree_fault(tree, validator.beyond, fault,
                      "%s is %.64s, which is out of range in a state of " REAL_NAME,
                      validator.beyond_path, (const char*)node->data.scalar.value);
}
