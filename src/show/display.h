/// The connection to the X server under GLFW's windows.
#ifndef BALLOON_SHOW_DISPLAY_H
#define BALLOON_SHOW_DISPLAY_H

#include <stdbool.h>

/// Whether the server closed the connection. Neither GLFW nor the driver says so while frames are
/// drawn.
bool display_is_lost(void);

/// Run calls of GLFW and OpenGL that talk to the server, on the thread that owns the window. False
/// where the server goes away during them: Xlib would exit, and Mesa crashes on a reply that is not
/// there or sends parts of a picture for ever. After that nothing of the two libraries may be called.
bool display_call(void (*calls)(void* self), void* self);

/// End of the program where the display is lost: what the two libraries registered for it would
/// crash, so nothing of it runs, and the exit code is that of a fault.
void display_abandon(void);

#endif
