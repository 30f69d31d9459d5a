/// What a scene's keys must be to each other, as a table of rules on the loaded structs.
#ifndef BALLOON_SCENE_RULES_H
#define BALLOON_SCENE_RULES_H

#include "scene/tree.h"

/// False with the place and sentence of the first rule that the scene breaks.
bool rules_hold(const WorldDef* def, const SceneTree* tree, Fault* fault);

#endif
