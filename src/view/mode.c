#include "view/mode.h"

#include <string.h>

const Mode mode_skin = {
    .name = "skin",
    .about = "glossy rubber, see-through at its rim, lighter where it is stretched",
    .paint = PAINT_RUBBER,
};

const Mode* const mode_table[] = {&mode_skin,   &mode_quads,   &mode_springs,
                                  &mode_forces, &mode_stretch, &mode_normals};
const int mode_count = sizeof mode_table / sizeof *mode_table;

const Mode* mode_find(const char* name) {
    for (int m = 0; m < mode_count; m++)
        if (strcmp(mode_table[m]->name, name) == 0)
            return mode_table[m];
    return NULL;
}

const Mode* mode_after(const Mode* mode) {
    for (int m = 0; m + 1 < mode_count; m++)
        if (mode_table[m] == mode)
            return mode_table[m + 1];
    return mode_table[0];
}

const char* mode_names(void) {
    static char names[256];
    names[0] = 0;
    for (int m = 0; m < mode_count; m++) {
        strncat(names, m ? ", " : "", sizeof names - strlen(names) - 1);
        strncat(names, mode_table[m]->name, sizeof names - strlen(names) - 1);
    }
    return names;
}
