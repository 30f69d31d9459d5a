/// Validates a scene's tree by the table of keys (key.h) and stores its values in the structs of
/// scene.h, in one pass: unknown and missing keys, keys given twice, wrong types, unknown names and
/// numbers out of range are refused.
#ifndef BALLOON_SCENE_VALIDATE_H
#define BALLOON_SCENE_VALIDATE_H

#include "scene/key.h"
#include "scene/tree.h"

enum { SCENE_NODES_MAX = 100000 }; ///< some thousand balloons; aliases could ask for more

typedef struct Validator {
    const SceneTree* tree;
    Fault* fault;
    Pool* pool;     ///< of what is stored
    char path[256]; ///< of the present value, "" for the scene itself
    int nodes;      ///< validated so far
    int beyond;     ///< the first node of a number outside the state's type; 0: none
    char beyond_path[256];
} Validator;

/// Fill def->…, whose memory is def->pool's.
bool validate_scene(const SceneTree* tree, WorldDef* def, Fault* fault);

/// Store one scalar in the key's field. In scalar.c.
bool validate_scalar(Validator* validator, const Key* key, int node, void* field);

/// The present value as the subject of a sentence.
const char* validate_subject(const Validator* validator);

#endif
