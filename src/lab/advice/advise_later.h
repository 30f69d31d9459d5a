/// Advice measured by another process while the scene is played with its own settings.
#ifndef BALLOON_LAB_ADVICE_ADVISE_LATER_H
#define BALLOON_LAB_ADVICE_ADVISE_LATER_H

#include "lab/advice/advise.h"
#include "lab/run/launch.h"

typedef struct AdviseLater {
    Launch launch; ///< of `balloon advise --report`, in this program's precision
    bool waiting;  ///< the process was started, and its result was not read yet
} AdviseLater;

/// Start the measurement. Its process ends with this one.
bool advise_later_begin(AdviseLater* later, const AdviseOptions* options, Fault* fault);

/// Returns true once, when the measurement has ended. sets: the overrides of the advice, none if it
/// failed; sentence: its promise, or why it failed.
bool advise_later_ended(AdviseLater* later, Overrides* sets, char* sentence, size_t size);

/// End a measurement that still runs.
void advise_later_close(AdviseLater* later);

#endif
