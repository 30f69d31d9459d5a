/// Overrides: store a value in the tree at a path, and add the absent keys on the path.
#include "scene/tree.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory_missing.h"

enum { VALUE_NODES_MAX = 1000 }; ///< a value with aliases to itself has no end

/// A change of the tree, and the location that its faults name.
typedef struct Put {
    SceneTree* tree;
    const char* location; ///< for faults
    const char* path;     ///< the whole path
    yaml_mark_t mark;     ///< of the nodes that are made
    Fault* fault;
} Put;

// A new node may move all others, so the mark is set by number.
static int with_mark(const Put* put, int node) {
    if (node <= 0)
        memory_missing("an override");
    put->tree->document.nodes.start[node - 1].start_mark = put->mark;
    return node;
}

// A path is of any bytes, and libyaml adds scalars of UTF-8 only: the bytes replace an empty one's.
static int make_text(const Put* put, const char* text, size_t length) {
    yaml_document_t* document = &put->tree->document;
    const int node = with_mark(put, yaml_document_add_scalar(document, NULL, (const yaml_char_t*)"",
                                                             0, YAML_ANY_SCALAR_STYLE));
    yaml_char_t* bytes = malloc(length + 1);
    if (!bytes)
        memory_missing("an override");
    memcpy(bytes, text, length);
    bytes[length] = '\0';
    yaml_node_t* made = &document->nodes.start[node - 1];
    free(made->data.scalar.value);
    made->data.scalar.value = bytes;
    made->data.scalar.length = length;
    return node;
}

static int make_mapping(const Put* put) {
    return with_mark(put,
                     yaml_document_add_mapping(&put->tree->document, NULL, YAML_ANY_MAPPING_STYLE));
}

static int make_list(const Put* put) {
    return with_mark(
        put, yaml_document_add_sequence(&put->tree->document, NULL, YAML_ANY_SEQUENCE_STYLE));
}

static void append_pair(const Put* put, int mapping, int key, int value) {
    if (!yaml_document_append_mapping_pair(&put->tree->document, mapping, key, value))
        memory_missing("an override");
}

static void append_item(const Put* put, int list, int item) {
    if (!yaml_document_append_sequence_item(&put->tree->document, list, item))
        memory_missing("an override");
}

// Copy a node of another tree with all below it. `remaining` nodes; below 0: the node has too many.
static int copy(const Put* put, const SceneTree* from, int id, int* remaining) {
    const yaml_node_t* node = tree_node(from, id);
    if (--*remaining < 0)
        return make_text(put, "", 0);
    if (node->type == YAML_SCALAR_NODE)
        return make_text(put, (const char*)node->data.scalar.value, node->data.scalar.length);

    if (node->type == YAML_SEQUENCE_NODE) {
        const int list = make_list(put);
        const yaml_node_item_t* item = node->data.sequence.items.start;
        for (; item < node->data.sequence.items.top; item++)
            append_item(put, list, copy(put, from, *item, remaining));
        return list;
    }
    const int mapping = make_mapping(put);
    const yaml_node_pair_t* pair = node->data.mapping.pairs.start;
    for (; pair < node->data.mapping.pairs.top; pair++) {
        const int key = copy(put, from, pair->key, remaining);
        append_pair(put, mapping, key, copy(put, from, pair->value, remaining));
    }
    return mapping;
}

// A copy of the node with the same children, so that an override does not change other aliases.
static int unshare(const Put* put, int id) {
    const yaml_node_t old = *tree_node(put->tree, id);
    if (old.type == YAML_SCALAR_NODE)
        return id;

    const Put old_mark = {.tree = put->tree, .mark = old.start_mark};
    if (old.type == YAML_SEQUENCE_NODE) {
        const int list = make_list(&old_mark);
        for (const yaml_node_item_t* item = old.data.sequence.items.start;
             item < old.data.sequence.items.top; item++)
            append_item(put, list, *item);
        return list;
    }
    const int mapping = make_mapping(&old_mark);
    for (const yaml_node_pair_t* pair = old.data.mapping.pairs.start;
         pair < old.data.mapping.pairs.top; pair++)
        append_pair(put, mapping, pair->key, pair->value);
    return mapping;
}

static bool may_add(const Put* put, int parent, const char* part, size_t length) {
    const yaml_node_t* node = tree_node(put->tree, parent);
    const int walked = part > put->path ? (int)(part - put->path) - 1 : 0;
    const char* whole = walked ? put->path : "the scene";
    const int whole_length = walked ? walked : (int)strlen(whole);

    if (node->type == YAML_SCALAR_NODE)
        return fault_set(put->fault, put->location, "%.*s is one value and has no keys",
                         whole_length, whole);
    if (node->type == YAML_SEQUENCE_NODE)
        return fault_set(put->fault, put->location,
                         "%.*s has no item '%.*s'; it is a list of %d, counted from 0",
                         whole_length, whole, (int)length, part,
                         (int)(node->data.sequence.items.top - node->data.sequence.items.start));
    if (part[length] == '.' && strchr("0123456789", part[length + 1]) && part[length + 1])
        return fault_set(put->fault, put->location,
                         "there is no list %.*s yet; give all of it, as in %.*s=[…]",
                         (int)(part + length - put->path), put->path,
                         (int)(part + length - put->path), put->path);
    return true;
}

static void remove_pair(const Put* put, int mapping, const int* slot) {
    yaml_node_t* node = put->tree->document.nodes.start + mapping - 1;
    yaml_node_pair_t* pair = node->data.mapping.pairs.start;
    while (&pair->value != slot)
        pair++;
    for (; pair + 1 < node->data.mapping.pairs.top; pair++)
        *pair = pair[1];
    node->data.mapping.pairs.top--;
}

/// Remove the key at the path, if it is there.
static bool remove_node(const Put* put) {
    int parent = TREE_ROOT;
    for (const char* part = put->path;;) {
        const size_t length = strcspn(part, ".");
        int* slot = tree_slot(put->tree, parent, part, length);
        if (!slot)
            return true;
        if (part[length] == '\0') {
            if (tree_node(put->tree, parent)->type == YAML_SEQUENCE_NODE)
                return fault_set(put->fault, put->location,
                                 "items of a list stay; give all of it, as in %.*s=[…]",
                                 (int)(part - put->path) - 1, put->path);
            remove_pair(put, parent, slot);
            return true;
        }
        const int child = unshare(put, *slot);
        *tree_slot(put->tree, parent, part, length) = child;
        parent = child;
        part += length + 1;
    }
}

static bool put_node(const Put* put, int value) {
    int parent = TREE_ROOT;
    for (const char* part = put->path;;) {
        const size_t length = strcspn(part, ".");
        const bool last = part[length] == '\0';
        int* slot = tree_slot(put->tree, parent, part, length);
        if (!slot && !may_add(put, parent, part, length))
            return false;

        const int child = last ? value : slot ? unshare(put, *slot) : make_mapping(put);
        if (slot)
            *slot = child;
        else
            append_pair(put, parent, make_text(put, part, length), child);
        if (last)
            return true;
        parent = child;
        part += length + 1;
    }
}

// Make the node of an override's value, read as YAML. 0 with a fault if it cannot be read.
static int make_value(const Put* put, const char* text) {
    SceneTree value = {.file = put->location};
    int remaining = VALUE_NODES_MAX;
    int node = 0;
    if (tree_parse(&value, text, strlen(text), put->fault))
        node = tree_node(&value, TREE_ROOT) ? copy(put, &value, TREE_ROOT, &remaining)
                                            : make_text(put, "", 0);
    tree_free(&value);
    if (remaining >= 0)
        return node;
    fault_set(put->fault, put->location, "this value is too large");
    return 0;
}

enum { LOCATION_SIZE = sizeof((Fault*)0)->location };

static void location_of(const SceneTree* tree, int index, char location[LOCATION_SIZE]) {
    snprintf(location, LOCATION_SIZE, "--set %s", tree->set[index].text);
}

bool tree_set_path(const SceneTree* tree, int index, char path[256], const char** value,
                   Fault* fault) {
    const char* text = tree->set[index].text;
    char location[LOCATION_SIZE];
    location_of(tree, index, location);
    const char* equals = strchr(text, '=');
    if (!equals || equals == text)
        return fault_set(fault, location, "this is not KEY=VALUE, as in step=0.001");
    if (snprintf(path, 256, "%.*s", (int)(equals - text), text) >= 256)
        return fault_set(fault, location, "there is no key as long as this");
    *value = equals + 1;
    return true;
}

bool tree_set(SceneTree* tree, int index, const char* path, const char* value, Fault* fault) {
    char location[LOCATION_SIZE];
    location_of(tree, index, location);
    const Put put = {.tree = tree,
                     .location = location,
                     .path = path,
                     .mark = {.line = TREE_SET_LINE + (size_t)index},
                     .fault = fault};
    if (strcmp(value, "~") == 0)
        return remove_node(&put);
    const int node = make_value(&put, value);
    return node && put_node(&put, node);
}

void tree_set_key(SceneTree* tree, int mapping, int pair, const char* name) {
    const int before = tree_node(tree, mapping)->data.mapping.pairs.start[pair].key;
    const Put put = {.tree = tree, .mark = tree_node(tree, before)->start_mark};
    const int key = make_text(&put, name, strlen(name));
    tree->document.nodes.start[mapping - 1].data.mapping.pairs.start[pair].key = key;
}

bool tree_set_text(SceneTree* tree, const char* path, const char* text, Fault* fault) {
    const Put put = {.tree = tree, .location = tree->file, .path = path, .fault = fault};
    return put_node(&put, make_text(&put, text, strlen(text)));
}
