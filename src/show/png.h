/// Writes a picture as a PNG file. It appears under its name only when it is whole.
#ifndef BALLOON_SHOW_PNG_H
#define BALLOON_SHOW_PNG_H

#include "base/fault.h"

/// rgb: [height * width * 3], upper row first.
bool png_write_rgb(const char* file, const unsigned char* rgb, int width, int height, Fault* fault);

#endif
