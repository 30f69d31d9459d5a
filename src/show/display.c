#include "show/display.h"

#include <dlfcn.h>
#include <poll.h>
#include <pthread.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/time.h>
#include <unistd.h>

#include <X11/Xlib.h>

// From GLFW/glfw3native.h, which needs further headers of X11. A GLFW for Wayland has no such
// function, and closes its windows when the display goes away.
extern Display* glfwGetX11Display(void) __attribute__((weak));

enum { TIMEOUT = 250000 };     ///< [us]
enum { CRASH_TIMEOUT = 1000 }; ///< [ms]

// of the call under way
static sigjmp_buf call_start;
static pthread_t call_thread;
static volatile sig_atomic_t calling;

static bool is_lost_within(int milliseconds) {
    Display* display = glfwGetX11Display ? glfwGetX11Display() : NULL;
    struct pollfd connection = {.fd = display ? ConnectionNumber(display) : -1};
    // no event is asked for, so only an error is one
    return display && poll(&connection, 1, milliseconds) > 0;
}

bool display_is_lost(void) {
    return is_lost_within(0);
}

/// A crash of the driver with the server gone ends the call; any other one happens again, uncaught.
/// A server that is being killed closes its memory before its connections.
static void crashed(int signal_number) {
    if (!calling || !is_lost_within(CRASH_TIMEOUT)) {
        signal(signal_number, SIG_DFL);
        return;
    }
    if (pthread_equal(pthread_self(), call_thread))
        siglongjmp(call_start, 1);
    pthread_kill(call_thread, SIGALRM);
    for (;;) // a thread of the driver, which ends with the program
        pause();
}

/// A call that takes this long with the server gone does not end by itself.
static void timed_out(int signal_number) {
    if (!calling || !display_is_lost())
        return;
    if (pthread_equal(pthread_self(), call_thread))
        siglongjmp(call_start, 1);
    pthread_kill(call_thread, signal_number);
}

/// Xlib's own handler exits, with a log that has no end.
static int xlib_failed(Display* display) {
    (void)display;
    if (calling)
        siglongjmp(call_start, 1);
    display_abandon(); // Xlib exits when this returns
    return 0;
}

/// GLFW loads Xlib by itself; a Wayland session has none.
static void catch_exit_of_xlib(void) {
    typedef int Handler(Display*);
    void* xlib = dlopen("libX11.so.6", RTLD_LAZY);
    Handler* (*set)(Handler*) = NULL;
    if (xlib)
        *(void**)&set = dlsym(xlib, "XSetIOErrorHandler");
    if (set)
        set(xlib_failed);
}

static void set_timer(int microseconds) {
    const struct timeval interval = {.tv_usec = microseconds};
    setitimer(ITIMER_REAL, &(struct itimerval){interval, interval}, NULL);
}

bool display_call(void (*calls)(void* self), void* self) {
    struct sigaction crash = {.sa_handler = crashed}, alarm = {.sa_handler = timed_out}, before[2];
    volatile bool complete = false;
    static bool is_first = true;
    if (is_first)
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

static void end_at_once(void) {
    fflush(NULL);
    _exit(EXIT_FAILURE);
}

void display_abandon(void) {
    atexit(end_at_once);
} // handlers run from the last to the first
