#include "contact/warm_start.h"

#include "base/array.h"

/// Whether a stored impulse comes before a contact in the order of the list: < 0, 0 or > 0.
static int compare(const StoredImpulse* stored, const Contact* contact) {
    if (stored->row != contact->row)
        return stored->row - contact->row;
    if (stored->pair != contact->pair)
        return stored->pair - contact->pair;
    return (stored->feature > contact->feature) - (stored->feature < contact->feature);
}

void warm_start_load(WarmStart* warm, Contact* contact, double h) {
    for (; warm->next < warm->count; warm->next++) {
        const StoredImpulse* stored = &warm->impulse[warm->next];
        const int order = compare(stored, contact);
        if (order > 0)
            return;
        if (order == 0) {
            const real ratio = (real)(h / warm->h);
            contact->normal_impulse = ratio * stored->normal_impulse;
            contact->tangent_impulse = ratio * stored->tangent_impulse;
        }
    }
}

void warm_start_store(WarmStart* warm, const Contact* contact, int count, double h) {
    warm->h = h;
    warm->count = warm->next = 0;
    for (int k = 0; k < count; k++) {
        const Contact* c = &contact[k];
        if (c->normal_impulse <= 0 || c->first)
            continue;
        array_reserve(warm->impulse, warm->count, warm->capacity);
        warm->impulse[warm->count++] =
            (StoredImpulse){c->row, c->pair, c->feature, c->normal_impulse, c->tangent_impulse};
    }
}
