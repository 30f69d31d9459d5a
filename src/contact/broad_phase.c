#include "contact/broad_phase.h"

#include "base/array.h"
#include "contact/ball_triangle.h"
#include "contact/shared_feature.h"

void broad_phase_open(ContactSkin* skin) {
    if (skin->patches)
        return;
    const Mesh* mesh = skin->body->mesh;
    skin->owners = shared_feature_owners(mesh);
    skin->patches = bullet_skin_open((const int(*)[3])mesh->triangle, mesh->triangle_count,
                                     skin->body->x, mesh->point_count);
}

double broad_phase_max_speed(const Body* body) {
    if (body->asleep)
        return 0;
    real fastest = 0;
    for (int i = 0; i < body->count; i++)
        fastest = real_max(fastest, dot(body->v[i], body->v[i]));
    return sqrt((double)fastest);
}

void broad_phase_refit(ContactSkin* skin) {
    if (skin->path_max == 0)
        return;
    bullet_skin_refit(skin->patches, 0);
    bullet_skin_box(skin->patches, skin->low, skin->high);
    skin->path_max = 0;
}

double broad_phase_box_distance(const ContactSkin* skin, double4 point) {
    double4 away = {0};
    for (int k = 0; k < 3; k++)
        away[k] = fmax(fmax(skin->low[k] - point[k], point[k] - skin->high[k]), 0);
    return dlength(away) - skin->path_max;
}

int broad_phase_triangles(Contacts* contacts, ContactSkin* skin, const Sphere* sphere,
                          double reach) {
    broad_phase_refit(skin);
    const double center[3] = {(double)sphere->x[0], (double)sphere->x[1], (double)sphere->x[2]};
    for (;;) {
        const int capacity = contacts->candidate_capacity;
        const int count =
            bullet_skin_near(skin->patches, center, reach, contacts->candidate, capacity);
        if (count <= capacity)
            return count;
        array_reserve(contacts->candidate, capacity, contacts->candidate_capacity);
    }
}

double broad_phase_distance(Contacts* contacts, ContactSkin* skin, Sphere* sphere, double far) {
    for (double reach = 1.5 * (double)sphere->radius;; reach *= 2) {
        const int count = broad_phase_triangles(contacts, skin, sphere, fmin(reach, far));
        double distance = far;
        for (int k = 0; k < count; k++) {
            Contact contact;
            ball_triangle_contact(&contact, sphere, skin->body, contacts->candidate[k], 1);
            distance = fmin(distance, (double)(contact.gap + sphere->radius));
        }
        if (distance < fmin(reach, far) || !(reach < far)) // far may be NaN
            return distance;
    }
}
