#include "contact/ball_start.h"

#include "contact/ball_triangle.h"

/// Moving away from one triangle may bring another nearer: then from that one, too.
enum { MOVES_MAX = 16 };

/// Overlap of a start that is let be, and what is left of one that was moved. [of the radius]
static const real overlap_allowed = (real)0.5, overlap_left = (real)1e-3;

/// The contact of the deepest overlap with any skin; returns that skin's number, NONE if it has no
/// triangles.
static int deepest(Sphere* sphere, const Contacts* contacts, Contact* found) {
    int skin = NONE;
    for (int b = 0; b < contacts->skin_count; b++) {
        Body* body = contacts->skin[b].body;
        for (int t = 0; t < body->mesh->triangle_count; t++) {
            Contact contact;
            ball_triangle_contact(&contact, sphere, body, t, 1);
            if (skin != NONE && contact.gap >= found->gap)
                continue;
            *found = contact;
            skin = b;
        }
    }
    return skin;
}

int ball_start_clear(Sphere* sphere, const Contacts* contacts) {
    Contact contact;
    const int first = deepest(sphere, contacts, &contact);
    if (first == NONE || !(contact.gap < -overlap_allowed * sphere->radius))
        return NONE;
    for (int move = 0; move < MOVES_MAX && contact.gap < -overlap_left * sphere->radius; move++) {
        sphere->x -= contact.gap * contact.normal;
        deepest(sphere, contacts, &contact);
    }
    return first;
}
