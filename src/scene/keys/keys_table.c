/// Keys that other tables bring to a balloon: the parameters of forces and of materials.
#include "scene/key.h"

#include <math.h>

#include "force/material.h"

bool key_of_force(int index, Key* key) {
    for (int k = 0; k < force_count; k++) {
        const Force* force = force_table[k];
        if (force->parameter_count == 0 || index-- > 0)
            continue;
        *key = (Key){.is = {force->name, NO_NUMBER, force->about},
                     .type = KEY_POINTER,
                     .offset = offsetof(BalloonDef, force) + (size_t)k * sizeof(double*),
                     .parameter = force->parameters,
                     .parameter_count = force->parameter_count};
        return true;
    }
    return false;
}

bool key_of_material(int index, Key* key) {
    for (int m = 0; m < material_count; m++) {
        const Material* material = material_table[m];
        if (index >= material->parameter_count) {
            index -= material->parameter_count;
            continue;
        }
        *key = (Key){.is = material->parameters[index],
                     .type = KEY_NUMBER,
                     .of = material->name,
                     .offset = offsetof(MembraneDef, parameter) + (size_t)index * sizeof(double)};
        return true;
    }
    return false;
}
