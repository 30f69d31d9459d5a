/// Writes a picture as a PNG file, which has a temporary name until it is complete.
#ifndef BALLOON_SHOW_PNG_H
#define BALLOON_SHOW_PNG_H

#include "base/fault.h"

/// rgb: [height * width * 3], top row first.
bool png_write_rgb(const char* file, const unsigned char* rgb, int width, int height, Fault* fault);

#endif
