/// Where the program's own files are, from any working folder and after an install: beside the
/// program in the build tree (../assets, ../shaders), or in PREFIX/share/balloon.
#ifndef BALLOON_BASE_PATHS_H
#define BALLOON_BASE_PATHS_H

#include "base/fault.h"

/// Path of `file` in one of our folders: paths_own("assets/scenes", "party.yaml", …).
/// False, with a sentence that names the places tried, when it is not there.
bool paths_own(const char* folder, const char* file, char path[512], Fault* fault);

/// The other build of this program beside this one ("balloon-double", "balloon").
bool paths_sibling(const char* name, char path[512], Fault* fault);

#endif
