#include "show/output.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "base/interrupt.h"
#include "base/memory.h"
#include "show/display.h"

// Wall time of a frame for steps of the world. Steps beyond it are dropped, so that the window
// responds on a slow machine. [s]
static const double MAX_STEPS_TIME = 1.0 / 25;
// A frame is never shorter: without it, a driver that does not wait for the screen would spin. [s]
static const double MIN_FRAME_TIME = 1.0 / 250;

// Weight of the last frame in the frame time of the overlay, an exponential average.
static const double SMOOTHING = 0.1;

typedef struct Window {
    GLFWwindow* window;
    bool display_lost;  ///< no function of GLFW may be called any more
    Input input;        ///< collects events until `next` returns it
    double frame_start; ///< time at which the last frame began [s]
    double frame_ms;    ///< smoothed [ms]
    double pointer[2];  ///< [screen coordinates]
    int windowed[4];    ///< x, y, width, height before full screen [screen coordinates]
} Window;

// ---- keys by name, as the key tables write them ----

static const struct KeyName {
    int key;
    const char* name;
} key_name_table[] = {
    {GLFW_KEY_SPACE, "space"},
    {GLFW_KEY_ENTER, "enter"},
    {GLFW_KEY_TAB, "tab"},
    {GLFW_KEY_BACKSPACE, "backspace"},
    {GLFW_KEY_ESCAPE, "escape"},
    {GLFW_KEY_UP, "up"},
    {GLFW_KEY_DOWN, "down"},
    {GLFW_KEY_LEFT, "left"},
    {GLFW_KEY_RIGHT, "right"},
    {GLFW_KEY_PAGE_UP, "page up"},
    {GLFW_KEY_PAGE_DOWN, "page down"},
    {GLFW_KEY_HOME, "home"},
    {GLFW_KEY_END, "end"},
    {GLFW_KEY_F1, "f1"},
    {GLFW_KEY_F11, "f11"},
    {GLFW_KEY_F12, "f12"},
};

/// A letter key has the name that the user's keyboard layout prints or, if that is not ASCII, the
/// name of the key on the American layout.
static void name_key(int key, int scancode, char name[16]) {
    name[0] = 0;
    for (size_t k = 0; k < sizeof key_name_table / sizeof *key_name_table; k++)
        if (key_name_table[k].key == key)
            snprintf(name, 16, "%s", key_name_table[k].name);
    if (name[0])
        return;
    const char* printed = glfwGetKeyName(key, scancode);
    if (printed && printed[0] > ' ' && printed[0] < 127 && !printed[1])
        snprintf(name, 16, "%c", tolower(printed[0]));
    else if (key > ' ' && key < 127)
        snprintf(name, 16, "%c", tolower(key));
}

static float fraction(double position, int size) {
    return (float)fmin(fmax(position / fmax(size, 1), 0), 1);
}

static void add_key(GLFWwindow* handle, const char* name, bool down) {
    Window* window = glfwGetWindowUserPointer(handle);
    Input* input = &window->input;
    if (!name[0] || input->key_count == MAX_FRAME_KEYS)
        return;
    int width, height;
    glfwGetWindowSize(handle, &width, &height);
    KeyEvent* event = &input->key[input->key_count++];
    *event = (KeyEvent){
        .down = down,
        .pointer = {fraction(window->pointer[0], width), fraction(window->pointer[1], height)},
    };
    snprintf(event->name, sizeof event->name, "%s", name);
}

/// On loss of focus GLFW reports every held key as released.
static void on_key(GLFWwindow* handle, int key, int scancode, int action, int modifiers) {
    (void)modifiers;
    if (action == GLFW_REPEAT)
        return;
    char name[16];
    name_key(key, scancode, name);
    add_key(handle, name, action == GLFW_PRESS);
}

// ---- mouse ----

static bool button_down(GLFWwindow* handle, int button) {
    return glfwGetMouseButton(handle, button) == GLFW_PRESS;
}

static bool either_key(GLFWwindow* handle, int left, int right) {
    return glfwGetKey(handle, left) == GLFW_PRESS || glfwGetKey(handle, right) == GLFW_PRESS;
}

static void on_button(GLFWwindow* handle, int button, int action, int modifiers) {
    if (button == GLFW_MOUSE_BUTTON_LEFT)
        add_key(handle, modifiers & GLFW_MOD_CONTROL ? "ctrl+click" : "click",
                action == GLFW_PRESS);
}

/// Events arrive in order but late, so the position is that of the event, not the present one.
static void on_pointer(GLFWwindow* handle, double x, double y) {
    Window* window = glfwGetWindowUserPointer(handle);
    int width, height;
    glfwGetWindowSize(handle, &width, &height);
    const float dx = (float)((x - window->pointer[0]) / fmax(height, 1));
    const float dy = (float)((y - window->pointer[1]) / fmax(height, 1));
    window->pointer[0] = x;
    window->pointer[1] = y;

    // a left drag orbits; a right or middle one, or left with shift, pans; left with control neither
    const bool left = button_down(handle, GLFW_MOUSE_BUTTON_LEFT) &&
                      !either_key(handle, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    const bool shift = either_key(handle, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    const bool other = button_down(handle, GLFW_MOUSE_BUTTON_RIGHT) ||
                       button_down(handle, GLFW_MOUSE_BUTTON_MIDDLE);
    if (!left && !other)
        return;
    float* drag = other || shift ? window->input.pan : window->input.orbit;
    drag[0] += dx;
    drag[1] += dy;
}

static void on_wheel(GLFWwindow* handle, double x, double y) {
    (void)x;
    ((Window*)glfwGetWindowUserPointer(handle))->input.zoom += (float)y;
}

// ---- the output ----

/// The scale of the overlay's text is the larger of pixels per screen coordinate and the content
/// scale of the window.
static void measure_window(Window* window) {
    Input* input = &window->input;
    int width, height;
    float across, down;
    glfwGetFramebufferSize(window->window, &input->width, &input->height);
    glfwGetWindowSize(window->window, &width, &height);
    glfwGetWindowContentScale(window->window, &across, &down);
    const float ratio = (float)input->height / (float)(height > 0 ? height : 1);
    input->scale = fmaxf(1, fmaxf(ratio, down));
}

static void take_events(void* self) {
    Window* window = self;
    glfwPollEvents();
    measure_window(window);

    // a minimized window has no pixels; the minimum frame time limits a driver that does not wait
    while (!glfwWindowShouldClose(window->window) &&
           (window->input.width == 0 || glfwGetTime() - window->frame_start < MIN_FRAME_TIME) &&
           !display_is_lost() && !interrupt_signal()) {
        glfwWaitEventsTimeout(MIN_FRAME_TIME);
        measure_window(window);
    }
}

static bool next(void* self, Input* input) {
    Window* window = self;
    window->display_lost = display_is_lost() || !display_call(take_events, window);
    if (window->display_lost)
        return false;
    const double now = glfwGetTime();
    window->input.elapsed = now - window->frame_start;
    window->frame_ms += SMOOTHING * (1e3 * window->input.elapsed - window->frame_ms);
    window->input.frame_ms = window->frame_ms;
    window->frame_start = now;

    *input = window->input;
    window->input = (Input){0};
    return !glfwWindowShouldClose(window->window);
}

static bool late(void* self) {
    const Window* window = self;
    return glfwGetTime() - window->frame_start > MAX_STEPS_TIME;
}

typedef struct Showing {
    GLFWwindow* window;
    const Renderer* renderer;
} Showing;

static void show(void* self) {
    const Showing* showing = self;
    renderer_show(showing->renderer);
    glfwSwapBuffers(showing->window);
}

static bool set_lost(Fault* fault) {
    return fault_set(fault, "window", "the display went away");
}

static bool present(void* self, const Renderer* renderer, Fault* fault) {
    Window* window = self;
    Showing showing = {window->window, renderer};
    window->display_lost =
        window->display_lost || display_is_lost() || !display_call(show, &showing);
    return !window->display_lost || set_lost(fault);
}

static bool lost(void* self, Fault* fault) {
    const Window* window = self;
    return window->display_lost && !set_lost(fault);
}

static void full_screen(void* self) {
    Window* window = self;
    int* windowed = window->windowed;
    if (glfwGetWindowMonitor(window->window)) {
        glfwSetWindowMonitor(window->window, NULL, windowed[0], windowed[1], windowed[2],
                             windowed[3], GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : NULL;
    if (!mode)
        return;
    glfwGetWindowPos(window->window, &windowed[0], &windowed[1]);
    glfwGetWindowSize(window->window, &windowed[2], &windowed[3]);
    glfwSetWindowMonitor(window->window, monitor, 0, 0, mode->width, mode->height,
                         mode->refreshRate);
}

static bool close_window(void* self, bool complete, Fault* fault) {
    (void)fault;
    Window* window = self;
    if (window->display_lost) {
        display_abandon();
    } else {
        glfwDestroyWindow(window->window);
        glfwTerminate();
    }
    free(window);
    return complete;
}

static const char* glfw_error(void) {
    const char* text = NULL;
    glfwGetError(&text);
    return text ? text : "no reason given";
}

typedef struct Creation {
    const char* title;
    int width, height;
    Window* window;
    Fault* fault; ///< set where there is no window
} Creation;

static void create(void* self) {
    Creation* creation = self;
    if (!glfwInit()) {
        fault_set(creation->fault, "window",
                  "there is no display here (%s); `balloon render` works without one",
                  glfw_error());
        return;
    }
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0); // the renderer has its own buffers
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    GLFWwindow* handle =
        glfwCreateWindow(creation->width, creation->height, creation->title, NULL, NULL);
    if (!handle) {
        fault_set(creation->fault, "window", "no window with OpenGL 3.3: %s", glfw_error());
        glfwTerminate();
        return;
    }
    Window* window = creation->window;
    *window = (Window){.window = handle, .frame_start = glfwGetTime()};
    glfwGetCursorPos(handle, &window->pointer[0], &window->pointer[1]);
    glfwSetWindowUserPointer(handle, window);
    glfwSetKeyCallback(handle, on_key);
    glfwSetMouseButtonCallback(handle, on_button);
    glfwSetCursorPosCallback(handle, on_pointer);
    glfwSetScrollCallback(handle, on_wheel);
    glfwMakeContextCurrent(handle);
    glfwSwapInterval(1);
}

bool output_window(Output* output, const char* title, int width, int height, Fault* fault) {
    Window* window = new_array(Window, 1);
    Creation creation = {title, width, height, window, fault};
    const bool lost_meanwhile = !display_call(create, &creation);
    if (lost_meanwhile) {
        display_abandon();
        set_lost(fault);
    }
    if (lost_meanwhile || !window->window) {
        free(window);
        return false;
    }
    *output = (Output){.self = window,
                       .next = next,
                       .late = late,
                       .present = present,
                       .full_screen = full_screen,
                       .lost = lost,
                       .close = close_window};
    return true;
}
