/// Judges a scene's tree by the schema and the ranges, before libcyaml fills the structs by it:
/// unknown and missing keys, keys given twice, wrong types, unknown names, numbers out of range.
///
/// libcyaml refuses most of these too, but names neither the known keys nor the line of an unknown
/// one, and takes "0.002foo" for a number and any word for true.
#ifndef BALLOON_SCENE_SCENE_JUDGE_H
#define BALLOON_SCENE_SCENE_JUDGE_H

#include "scene/scene_tree.h"

enum { SCENE_NODES_MOST = 100000 }; ///< some thousand balloons; aliases could ask for more

bool judge_scene(const SceneTree* tree, Fault* fault);

#endif
