/// The scene reference: a Markdown table of all keys, from the rows of key.h.
#ifndef BALLOON_SCENE_REFERENCE_H
#define BALLOON_SCENE_REFERENCE_H

#include <stdio.h>

void scene_reference(FILE* out);

#endif
