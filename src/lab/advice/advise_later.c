#include "lab/advice/advise_later.h"

#include <string.h>
#include <sys/wait.h>

#include "base/paths.h"

bool advise_later_begin(AdviseLater* later, const AdviseOptions* options, Fault* fault) {
    char program[512];
    *later = (AdviseLater){0};
    if (!paths_sibling(sizeof(real) == sizeof(double) ? "balloon-double" : "balloon", program,
                       fault))
        return false;
    Launch* launch = &later->launch;
    launch_add(launch, "%s", program);
    launch_add(launch, "advise");
    launch_add(launch, "%s", options->scene);
    launch_add(launch, "--report");
    if (options->error > 0)
        launch_add(launch, "--error=%.17g", options->error);
    else
        launch_add(launch, "--budget=%.17g", options->ms);
    if (options->fresh)
        launch_add(launch, "--fresh");
    for (int k = 0; k < options->set_count; k++)
        launch_add(launch, "--set=%s", options->set[k].text);
    later->waiting = launch_begin(launch, fault);
    return later->waiting;
}

/// The lines of `balloon advise --report`: "set KEY=VALUE", and "says SENTENCE".
static void read_lines(const char* text, Overrides* sets, char* sentence, size_t size) {
    while (*text) {
        const int length = (int)strcspn(text, "\n");
        if (strncmp(text, "set ", 4) == 0 && sets->count < MAX_OVERRIDES)
            overrides_add(sets, "%.*s", length - 4, text + 4);
        else if (strncmp(text, "says ", 5) == 0)
            snprintf(sentence, size, "%.*s", length - 5, text + 5);
        text += length + (text[length] == '\n');
    }
}

bool advise_later_ended(AdviseLater* later, Overrides* sets, char* sentence, size_t size) {
    const Launch* launch = &later->launch;
    sets->count = 0;
    if (!later->waiting || !launch_has_ended(&later->launch))
        return false;
    later->waiting = false;
    if (WIFEXITED(launch->status) && WEXITSTATUS(launch->status) == 0)
        read_lines(launch->out, sets, sentence, size);
    else
        snprintf(sentence, size, "no advice: %.*s", (int)strcspn(launch->err, "\n"), launch->err);
    return true;
}

void advise_later_close(AdviseLater* later) {
    launch_free(&later->launch);
    later->waiting = false;
}
