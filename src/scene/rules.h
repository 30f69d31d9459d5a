/// Rules between the keys of a scene, as a table of checks on the loaded structs.
#ifndef BALLOON_SCENE_RULES_H
#define BALLOON_SCENE_RULES_H

#include "scene/tree.h"

/// False with the location and sentence of the first rule that the scene breaks.
bool rules_hold(const WorldDef* def, const SceneTree* tree, Fault* fault);

#endif
