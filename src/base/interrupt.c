#include "base/interrupt.h"

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t noted;

static void note(int number) {
    noted = number;
}

void interrupt_catch(void) {
    struct sigaction action = {.sa_handler = note, .sa_flags = SA_RESTART | (int)SA_RESETHAND};
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

int interrupt_signal(void) {
    return noted;
}

bool interrupt_fault(const char* scene, double seconds, Fault* fault) {
    return fault_set(fault, scene, "ended at %g s by %s", seconds,
                     noted == SIGINT ? "an interrupt" : "a request to end");
}
