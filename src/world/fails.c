#include "world/fails.h"

#include "world/probe.h"

bool fails_seen(const World* world) {
    const FailsDef* fails = world->def.fails;
    double value;
    if (fails->halts || world->blowup.halted)
        return fails->halts && world->blowup.halted;
    return probe_value(world, fails->output, &value) &&
           (fails->above ? value > *fails->above : value < *fails->below);
}

void fails_words(const FailsDef* fails, char* words, size_t size) {
    size_t used;
    if (fails->halts)
        used = (size_t)snprintf(words, size, "by %g s the state goes bad", fails->at);
    else
        used = (size_t)snprintf(words, size, "%s at %g s is %s %g", fails->output, fails->at,
                                fails->above ? "above" : "below",
                                fails->above ? *fails->above : *fails->below);
    if (fails->truth && used < size)
        used += (size_t)snprintf(words + used, size - used, ", not %g", *fails->truth);
    for (unsigned k = 0; k < fails->cure_count && used < size; k++)
        used += (size_t)snprintf(words + used, size - used, "%s %s",
                                 k ? "," : "; cure:", fails->cure[k]);
}
