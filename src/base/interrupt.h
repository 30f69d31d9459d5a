/// Ctrl-C and TERM, noted so that a run ends at its next frame or step with whole files. A second one
/// ends the program at once.
#ifndef BALLOON_BASE_INTERRUPT_H
#define BALLOON_BASE_INTERRUPT_H

#include "base/fault.h"

/// From now on SIGINT and SIGTERM are noted; before, they end the program.
void interrupt_catch(void);

/// The signal that was noted, or 0.
int interrupt_signal(void);

/// The fault of a run that a signal ended at this simulated time [s]; false.
bool interrupt_fault(const char* scene, double seconds, Fault* fault);

#endif
