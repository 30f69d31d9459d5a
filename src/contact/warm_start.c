#include "contact/warm_start.h"

void warm_start_load(WarmStart* warm, Contact* contact, double h) {
    while (warm->next < warm->count) {
        const StoredImpulse* stored = &warm->impulse[warm->next];
        if (stored->pair > contact->pair ||
            (stored->pair == contact->pair && stored->triangle > contact->triangle))
            return;
        warm->next++;
        if (stored->pair == contact->pair && stored->triangle == contact->triangle) {
            const real ratio = (real)(h / warm->h);
            contact->normal_impulse = ratio * stored->normal_impulse;
            contact->tangent_impulse = ratio * stored->tangent_impulse;
            return;
        }
    }
}

void warm_start_store(WarmStart* warm, const Contact* contact, int count, double h) {
    warm->h = h;
    warm->count = warm->next = 0;
    for (int k = 0; k < count; k++) {
        const Contact* c = &contact[k];
        if (c->normal_impulse > 0 && !c->first)
            warm->impulse[warm->count++] =
                (StoredImpulse){c->pair, c->triangle, c->normal_impulse, c->tangent_impulse};
    }
}
