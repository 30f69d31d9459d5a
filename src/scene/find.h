/// What a name on the command line means: a scene's file, or a mesh that gets a default scene.
#ifndef BALLOON_SCENE_FIND_H
#define BALLOON_SCENE_FIND_H

#include "base/fault.h"

typedef struct SceneSource {
    char file[512];  ///< the scene's file, or the mesh itself
    char model[512]; ///< of a bare mesh: its balloon's model; "" for a scene's file
} SceneSource;

/// The scene of a bare mesh, as YAML; its balloon's model is to be put in.
extern const char mesh_scene[];

/// Names of scenes in assets/scenes, paths of scenes and meshes, names of shapes. The fault names
/// the paths tried and what there is.
bool scene_find(const char* name, SceneSource* source, Fault* fault);

#endif
