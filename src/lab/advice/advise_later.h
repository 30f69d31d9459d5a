/// Advice that is measured by a process of its own while a scene is played as it is.
#ifndef BALLOON_LAB_ADVICE_ADVISE_LATER_H
#define BALLOON_LAB_ADVICE_ADVISE_LATER_H

#include "lab/advice/advise.h"
#include "lab/run/launch.h"

typedef struct AdviseLater {
    Launch launch; ///< of `balloon advise --report`, in this program's precision
    bool waiting;  ///< it was begun, and its result was not fetched yet
} AdviseLater;

/// Begin to measure. The process ends with this one.
bool advise_later_begin(AdviseLater* later, const AdviseOptions* options, Fault* fault);

/// True once, when the measurement has ended: the overrides of the advice, none where there is no
/// advice, and a sentence about it.
bool advise_later_ended(AdviseLater* later, Overrides* sets, char* sentence, size_t size);

/// End what goes on.
void advise_later_close(AdviseLater* later);

#endif
