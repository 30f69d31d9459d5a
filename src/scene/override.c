/// Overrides: put a value into the tree at a path, making the keys on the way that are absent.
#include "scene/tree.h"

#include <string.h>

enum { VALUE_NODES_MOST = 1000 }; ///< a value with aliases to itself has no end

/// What is put in, and where it is said to come from.
typedef struct Put {
    SceneTree* tree;
    const char* place; ///< for faults
    const char* path;  ///< the whole path
    yaml_mark_t mark;  ///< of the nodes that are made
    Fault* fault;
} Put;

// A new node may move all others, so the mark is set by number.
static int made(const Put* put, int node) {
    ASSERT(node > 0, "there is memory for an override");
    put->tree->document.nodes.start[node - 1].start_mark = put->mark;
    return node;
}

static int make_text(const Put* put, const char* text, size_t length) {
    return made(put, yaml_document_add_scalar(&put->tree->document, NULL, (const yaml_char_t*)text,
                                              (int)length, YAML_ANY_SCALAR_STYLE));
}

static int make_mapping(const Put* put) {
    return made(put, yaml_document_add_mapping(&put->tree->document, NULL, YAML_ANY_MAPPING_STYLE));
}

static int make_list(const Put* put) {
    return made(put,
                yaml_document_add_sequence(&put->tree->document, NULL, YAML_ANY_SEQUENCE_STYLE));
}

static void append_pair(const Put* put, int mapping, int key, int value) {
    const bool good = yaml_document_append_mapping_pair(&put->tree->document, mapping, key, value);
    ASSERT(good, "there is memory for an override");
}

static void append_item(const Put* put, int list, int item) {
    const bool good = yaml_document_append_sequence_item(&put->tree->document, list, item);
    ASSERT(good, "there is memory for an override");
}

// Copy a node of another tree with all below it. `left` goes below 0 when there is too much.
static int copy(const Put* put, const SceneTree* from, int id, int* left) {
    const yaml_node_t* node = tree_node(from, id);
    if (--*left < 0)
        return make_text(put, "", 0);
    if (node->type == YAML_SCALAR_NODE)
        return make_text(put, (const char*)node->data.scalar.value, node->data.scalar.length);

    if (node->type == YAML_SEQUENCE_NODE) {
        const int list = make_list(put);
        const yaml_node_item_t* item = node->data.sequence.items.start;
        for (; item < node->data.sequence.items.top; item++)
            append_item(put, list, copy(put, from, *item, left));
        return list;
    }
    const int mapping = make_mapping(put);
    const yaml_node_pair_t* pair = node->data.mapping.pairs.start;
    for (; pair < node->data.mapping.pairs.top; pair++) {
        const int key = copy(put, from, pair->key, left);
        append_pair(put, mapping, key, copy(put, from, pair->value, left));
    }
    return mapping;
}

// A node of its own with the same children: what an alias shares is changed for this path only.
static int unshare(const Put* put, int id) {
    const yaml_node_t old = *tree_node(put->tree, id);
    if (old.type == YAML_SCALAR_NODE)
        return id;

    const Put as_it_was = {.tree = put->tree, .mark = old.start_mark};
    if (old.type == YAML_SEQUENCE_NODE) {
        const int list = make_list(&as_it_was);
        for (const yaml_node_item_t* item = old.data.sequence.items.start;
             item < old.data.sequence.items.top; item++)
            append_item(put, list, *item);
        return list;
    }
    const int mapping = make_mapping(&as_it_was);
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
        return fault_set(put->fault, put->place, "%.*s is one value and has no keys", whole_length,
                         whole);
    if (node->type == YAML_SEQUENCE_NODE)
        return fault_set(put->fault, put->place, "%.*s has no item '%.*s'; it has %d, from 0",
                         whole_length, whole, (int)length, part,
                         (int)(node->data.sequence.items.top - node->data.sequence.items.start));
    if (part[length] == '.' && strchr("0123456789", part[length + 1]) && part[length + 1])
        return fault_set(put->fault, put->place,
                         "there is no list %.*s yet; give all of it, as in %.*s=[…]",
                         (int)(part + length - put->path), put->path,
                         (int)(part + length - put->path), put->path);
    return true;
}

static void take_out(const Put* put, int mapping, const int* slot) {
    yaml_node_t* node = put->tree->document.nodes.start + mapping - 1;
    yaml_node_pair_t* pair = node->data.mapping.pairs.start;
    while (&pair->value != slot)
        pair++;
    for (; pair + 1 < node->data.mapping.pairs.top; pair++)
        *pair = pair[1];
    node->data.mapping.pairs.top--;
}

/// Take the key at the path out; one that is not there stays away.
static bool remove_node(const Put* put) {
    int parent = TREE_ROOT;
    for (const char* part = put->path;;) {
        const size_t length = strcspn(part, ".");
        int* slot = tree_slot(put->tree, parent, part, length);
        if (!slot)
            return true;
        if (part[length] == '\0') {
            if (tree_node(put->tree, parent)->type == YAML_SEQUENCE_NODE)
                return fault_set(put->fault, put->place,
                                 "items of a list stay; give all of it, as in %.*s=[…]",
                                 (int)(part - put->path) - 1, put->path);
            take_out(put, parent, slot);
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
    SceneTree value = {.file = put->place};
    int left = VALUE_NODES_MOST;
    int node = 0;
    if (tree_parse(&value, text, strlen(text), put->fault))
        node = tree_node(&value, TREE_ROOT) ? copy(put, &value, TREE_ROOT, &left)
                                            : make_text(put, "", 0);
    tree_free(&value);
    if (left >= 0)
        return node;
    fault_set(put->fault, put->place, "this value is too large");
    return 0;
}

enum { FAULT_PLACE = sizeof((Fault*)0)->place };

static void place_of(const SceneTree* tree, int index, char place[FAULT_PLACE]) {
    snprintf(place, FAULT_PLACE, "--set %s", tree->set[index].text);
}

bool tree_set_path(const SceneTree* tree, int index, char path[256], const char** value,
                   Fault* fault) {
    const char* text = tree->set[index].text;
    char place[FAULT_PLACE];
    place_of(tree, index, place);
    const char* equals = strchr(text, '=');
    if (!equals || equals == text)
        return fault_set(fault, place, "this is not KEY=VALUE, as in step=0.001");
    if (snprintf(path, 256, "%.*s", (int)(equals - text), text) >= 256)
        return fault_set(fault, place, "there is no key as long as this");
    *value = equals + 1;
    return true;
}

bool tree_set(SceneTree* tree, int index, const char* path, const char* value, Fault* fault) {
    char place[FAULT_PLACE];
    place_of(tree, index, place);
    const Put put = {.tree = tree,
                     .place = place,
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
    const Put put = {.tree = tree, .place = tree->file, .path = path, .fault = fault};
    return put_node(&put, make_text(&put, text, strlen(text)));
}
