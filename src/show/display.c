#include "show/display.h"

#include <poll.h>

#include <X11/Xlib.h>

// From GLFW/glfw3native.h, which needs further headers of X11. A GLFW for Wayland has no such
// function, and closes its windows when the display goes away.
extern Display* glfwGetX11Display(void) __attribute__((weak));

bool display_is_lost(void) {
    Display* display = glfwGetX11Display ? glfwGetX11Display() : NULL;
    struct pollfd connection = {.fd = display ? ConnectionNumber(display) : -1};
    return poll(&connection, 1, 0) > 0; // no event is asked for, so only an error is one
}
