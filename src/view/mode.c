#include "view/mode.h"

#include "base/table.h"

const Mode mode_skin = {
    .name = "skin",
    .about = "glossy rubber, see-through at its rim, lighter where it is stretched",
    .paint = PAINT_RUBBER,
};

const Mode* const mode_table[] = {&mode_skin,   &mode_quads,   &mode_springs,
                                  &mode_forces, &mode_stretch, &mode_normals};
const int mode_count = sizeof mode_table / sizeof *mode_table;

const Mode* mode_find(const char* name) {
    return table_find(mode_table, mode_count, name);
}

const Mode* mode_after(const Mode* mode) {
    for (int m = 0; m + 1 < mode_count; m++)
        if (mode_table[m] == mode)
            return mode_table[m + 1];
    return mode_table[0];
}

const char* mode_names(void) {
    static char names[256];
    return table_names(mode_table, mode_count, names, sizeof names);
}
