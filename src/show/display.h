/// The connection to the X server under GLFW's windows.
#ifndef BALLOON_SHOW_DISPLAY_H
#define BALLOON_SHOW_DISPLAY_H

#include <stdbool.h>

/// Whether the server closed the connection. Neither GLFW nor the driver says so while frames are
/// drawn.
bool display_is_lost(void);

#endif
