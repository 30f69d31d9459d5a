/// The scene format as a table: which key is which field of scene.h, and what type it has.
///
/// libcyaml fills the structs by it, scene_judge.c refuses by it what does not fit, and the known
/// keys that a sentence lists are its rows.
#ifndef BALLOON_SCENE_SCENE_SCHEMA_H
#define BALLOON_SCENE_SCENE_SCHEMA_H

#include <cyaml/cyaml.h>

/// The schema of a whole scene, a WorldDef.
const cyaml_schema_value_t* scene_schema(void);

#endif
