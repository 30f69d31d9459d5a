/// A scene's YAML as a tree of nodes, each of which knows where it came from: a line of the file,
/// or an override. Faults name that location. Overrides change the tree.
///
/// Nodes are libyaml's, by number; the root is node 1.
#ifndef BALLOON_SCENE_TREE_H
#define BALLOON_SCENE_TREE_H

#include <yaml.h>

#include "scene/scene.h"

enum {
    TREE_ROOT = 1,
    TREE_SET_LINE = 1 << 30, ///< a node of line TREE_SET_LINE + i came with override i
};

typedef struct SceneTree {
    const char* file;    ///< that locations name
    bool numbered;       ///< the file's lines are those of the text; else locations have no line
    const SceneSet* set; ///< the overrides, for locations
    yaml_document_t document;
} SceneTree;

/// Parse a text of one YAML document, which may be empty. tree->file and numbered are set before.
/// tree_free it also when this fails.
bool tree_parse(SceneTree* tree, const char* text, size_t size, Fault* fault);

/// NULL if there is no such node; the pointer holds until a node is added.
const yaml_node_t* tree_node(const SceneTree* tree, int node);

/// Where a mapping or a list keeps the number of its child: at a key or at an item's number,
/// `length` bytes long. NULL if there is none.
int* tree_slot(const SceneTree* tree, int parent, const char* part, size_t length);

/// The node at a path as in "balloons.0.scale", or the last on the way that there is.
int tree_find(const SceneTree* tree, const char* path);

/// The path of the override set[index], before its "=", and its value. In override.c.
bool tree_set_path(const SceneTree* tree, int index, char path[256], const char** value,
                   Fault* fault);

/// Put the value of the override set[index] in at a path. In override.c.
bool tree_set(SceneTree* tree, int index, const char* path, const char* value, Fault* fault);

/// Give key number `pair` of a mapping another name. In override.c.
void tree_set_key(SceneTree* tree, int mapping, int pair, const char* name);

/// Put a text in at a path as it is, not read as YAML. In override.c.
bool tree_set_text(SceneTree* tree, const char* path, const char* text, Fault* fault);

/// A fault about a node, with the node's location: the override's, for a mapping into which one
/// put a key.
bool tree_fault(const SceneTree* tree, int node, Fault* fault, const char* format, ...)
    __attribute__((format(printf, 4, 5)));

/// The tree as YAML again, with every scalar quoted and every alias written out, or laid out
/// for people. A zero byte follows. Only for trees
/// that passed validate_scene, which bounds them. The caller frees it. NULL if a text is not UTF-8.
char* tree_text(const SceneTree* tree, bool for_people, size_t* size);

void tree_free(SceneTree* tree);

#endif
