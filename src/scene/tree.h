/// A scene's YAML as a tree of nodes, each of which knows where it came from: a line of the file,
/// or an override. What is wrong is said with that place; overrides are put in here.
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
    const char* file;    ///< what places name
    bool numbered;       ///< the file's lines are those of the text; else places are without
    const SceneSet* set; ///< the overrides, for places
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

/// Refuse a node: a sentence with the node's place. A mapping into which an override put a key is
/// the override's.
bool tree_fault(const SceneTree* tree, int node, Fault* fault, const char* format, ...)
    __attribute__((format(printf, 4, 5)));

/// The tree as YAML again, in a form in which nothing is left to guess: every scalar quoted, every
/// alias written out; or for people, as scenes are written. A zero byte follows. Only for trees
/// that passed validate_scene, which bounds them. The caller frees it.
char* tree_text(const SceneTree* tree, bool for_people, size_t* size);

void tree_free(SceneTree* tree);

#endif
