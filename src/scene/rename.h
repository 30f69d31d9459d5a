/// Keys by earlier names, Key.old: read as the present ones, and told to the user.
#ifndef BALLOON_SCENE_RENAME_H
#define BALLOON_SCENE_RENAME_H

#include "scene/key.h"
#include "scene/tree.h"

enum { PATH_LONGEST = 256 }; ///< [bytes] of an override's path, with its end

/// Earlier names that were read: "turn is now rotation, …"; each once. [WorldDef.renamed]
typedef struct Renamed {
    char* names;
    size_t size;
} Renamed;

/// Give every key of a scene's tree its present name.
void rename_tree(SceneTree* tree, const Renamed* renamed);

/// The same of an override's path.
void rename_path(char path[PATH_LONGEST], const Renamed* renamed);

#endif
