#include "contact/warm.h"

void warm_give(Warm* warm, Contact* contact, double h) {
    while (warm->next < warm->count) {
        const Push* push = &warm->push[warm->next];
        if (push->pair > contact->pair ||
            (push->pair == contact->pair && push->triangle > contact->triangle))
            return;
        warm->next++;
        if (push->pair == contact->pair && push->triangle == contact->triangle) {
            const real longer = (real)(h / warm->h);
            contact->push = longer * push->push;
            contact->rub = longer * push->rub;
            return;
        }
    }
}

void warm_keep(Warm* warm, const Contact* contact, int count, double h) {
    warm->h = h;
    warm->count = warm->next = 0;
    for (int k = 0; k < count; k++) {
        const Contact* c = &contact[k];
        if (c->push > 0 && !c->first)
            warm->push[warm->count++] = (Push){c->pair, c->triangle, c->push, c->rub};
    }
}
