#include "scene/rename.h"

#include <string.h>

#include "base/table.h"

enum { NODES_MAX = 100000 }; ///< aliases could ask for more

/// The row whose earlier name this is; false where there is none, or a present key has that name.
static bool find_old(const KeyGroup* group, const char* name, Key* key) {
    if (key_find(group, NULL, name, key))
        return false;
    for (int i = 0; key_at(group, i, key); i++)
        if (key->old && strcmp(key->old, name) == 0)
            return true;
    return false;
}

static void note(const Renamed* renamed, const Key* key) {
    char words[2 * WORD_LONGEST];
    snprintf(words, sizeof words, "%s is now %s", key->old, key->is.name);
    if (!strstr(renamed->names, words))
        table_add_name(renamed->names, renamed->size, words);
}

typedef struct Renaming {
    SceneTree* tree;
    const Renamed* renamed;
    int nodes; ///< visited so far
} Renaming;

static void rename_group(Renaming* renaming, const KeyGroup* group, int mapping);

static void rename_value(Renaming* renaming, const Key* key, int id) {
    const KeyGroup group = key_group(key);
    const yaml_node_t* node = tree_node(renaming->tree, id);
    if (key->type != KEY_LIST) {
        rename_group(renaming, &group, id);
        return;
    }
    if (node->type != YAML_SEQUENCE_NODE)
        return;
    const long count = node->data.sequence.items.top - node->data.sequence.items.start;
    for (long i = 0; i < count && renaming->nodes < NODES_MAX; i++)
        rename_group(renaming, &group, tree_node(renaming->tree, id)->data.sequence.items.start[i]);
}

/// Nodes move when one is added, so that every access is by number.
static void rename_group(Renaming* renaming, const KeyGroup* group, int mapping) {
    SceneTree* tree = renaming->tree;
    if (tree_node(tree, mapping)->type != YAML_MAPPING_NODE)
        return;
    const yaml_node_t* node = tree_node(tree, mapping);
    const long count = node->data.mapping.pairs.top - node->data.mapping.pairs.start;
    for (long i = 0; i < count && ++renaming->nodes < NODES_MAX; i++) {
        const yaml_node_pair_t pair = tree_node(tree, mapping)->data.mapping.pairs.start[i];
        const yaml_node_t* word = tree_node(tree, pair.key);
        Key key;
        if (word->type != YAML_SCALAR_NODE)
            continue;
        const char* name = (const char*)word->data.scalar.value;
        if (find_old(group, name, &key)) {
            note(renaming->renamed, &key);
            tree_set_key(tree, mapping, (int)i, key.is.name);
        } else if (!key_find(group, NULL, name, &key)) {
            continue;
        }
        rename_value(renaming, &key, pair.value);
    }
}

void rename_tree(SceneTree* tree, const Renamed* renamed) {
    Renaming renaming = {.tree = tree, .renamed = renamed};
    if (tree_node(tree, TREE_ROOT))
        rename_group(&renaming, &scene_keys, TREE_ROOT);
}

void rename_path(char path[PATH_LONGEST], const Renamed* renamed) {
    char present[PATH_LONGEST] = "";
    KeyGroup group = scene_keys;
    bool item = false; ///< the next part is a list's number
    size_t length = 0;
    for (const char* part = path; *part;) {
        char name[PATH_LONGEST];
        const size_t size = strcspn(part, ".");
        snprintf(name, sizeof name, "%.*s", (int)size, part);
        part += size + (part[size] == '.');
        Key key = {.type = KEY_NUMBER};
        if (!item && find_old(&group, name, &key)) {
            note(renamed, &key);
            snprintf(name, sizeof name, "%s", key.is.name);
        }
        length += (size_t)snprintf(present + length, sizeof present - length, "%s%s",
                                   length ? "." : "", name);
        if (length >= sizeof present)
            return; // too long by its present name: it stays, and is refused
        if (!item && key_find(&group, NULL, name, &key))
            group = key_group(&key);
        item = !item && key.type == KEY_LIST;
    }
    snprintf(path, PATH_LONGEST, "%s", present);
}
