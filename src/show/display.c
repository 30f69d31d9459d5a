#include "show/display.h"

#include <dlfcn.h>
#include <poll.h>
#include <pthread.h>
#include <setjmp.h>
#include <signal.h>
#include <sys/time.h>

#include <X11/Xlib.h>

// From GLFW/glfw3native.h, which needs further headers of X11. A GLFW for Wayland has no such
// function, and closes its windows when the display goes away.
extern Display* glfwGetX11Display(void) __attribute__((weak));

enum { TIMEOUT = 250000 }; ///< [us]

// of the call under way
static sigjmp_buf call_start;
static pthread_t call_thread;
static volatile sig_atomic_t calling;

bool display_is_lost(void) {
    Display* display = glfwGetX11Display ? glfwGetX11Display() : NULL;
    struct pollfd connection = {.fd = display ? ConnectionNumber(display) : -1};
    return poll(&connection, 1, 0) > 0; // no event is asked for, so only an error is one
}

/// A crash of the driver with the server gone ends the call; any other one happens again, uncaught.
static void crashed(int signal_number) {
    if (pthread_equal(pthread_self(), call_thread) && display_is_lost())
        siglongjmp(call_start, 1);
    signal(signal_number, SIG_DFL);
}

/// A call that takes this long with the server gone does not end by itself.
static void timed_out(int signal_number) {
    if (!calling || !display_is_lost())
        return;
    if (pthread_equal(pthread_self(), call_thread))
        siglongjmp(call_start, 1);
    pthread_kill(call_thread, signal_number);
}

static void exit_of_xlib(Display* display, void* self) {
    (void)display, (void)self;
    if (calling) // else the present function of Xlib fails
        siglongjmp(call_start, 1);
}

/// GLFW loads Xlib by itself; a Wayland session has none.
static void catch_exit_of_xlib(void) {
    typedef void SetHandler(Display*, void (*)(Display*, void*), void*);
    Display* display = glfwGetX11Display ? glfwGetX11Display() : NULL;
    void* xlib = display ? dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD) : NULL;
    SetHandler* set = NULL;
    if (xlib)
        *(void**)&set = dlsym(xlib, "XSetIOErrorExitHandler");
    if (set)
        set(display, exit_of_xlib, NULL);
}

static void set_timer(int microseconds) {
    const struct timeval interval = {.tv_usec = microseconds};
    setitimer(ITIMER_REAL, &(struct itimerval){interval, interval}, NULL);
}

bool display_call(void (*calls)(void* self), void* self) {
    struct sigaction crash = {.sa_handler = crashed}, alarm = {.sa_handler = timed_out}, before[2];
    volatile bool complete = false;
    static bool is_first = true;
    if (is_first) // GLFW opens one display, and keeps it
        catch_exit_of_xlib();
    is_first = false;
    call_thread = pthread_self();
    sigaction(SIGSEGV, &crash, &before[0]);
    sigaction(SIGALRM, &alarm, &before[1]);
    set_timer(TIMEOUT);
    calling = 1;
    if (sigsetjmp(call_start, 1) == 0) {
        calls(self);
        complete = true;
    }
    calling = 0;
    set_timer(0);
    sigaction(SIGSEGV, &before[0], NULL);
    sigaction(SIGALRM, &before[1], NULL);
    return complete && !display_is_lost();
}
