/// Files that the program is about to write over.
///
/// A file that it made itself, which its first bytes or its comment show, is written anew without a
/// question; so is an empty one, and a device. One that it did not make, or that the same command
/// reads, is written over only with --overwrite. Two outputs never go to one file.
#ifndef BALLOON_CLI_OVERWRITE_H
#define BALLOON_CLI_OVERWRITE_H

#include "cli/options.h"

/// Whether the CSV, the skins and the input log may be written; else a fault names the option.
bool overwrite_allowed(const Options* options, Fault* fault);

/// Whether the scene that advice writes may.
bool overwrite_allows_scene(const Options* options, Fault* fault);

/// Whether the pictures may: a film, a picture, or the frames of a folder.
bool overwrite_allows_pictures(const Options* options, const char* out, Fault* fault);

#endif
