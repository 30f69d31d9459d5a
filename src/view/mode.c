#include "view/mode.h"

#include "base/table.h"

const Mode mode_skin = {
    .name = "skin",
    .about = "glossy rubber, see-through at its rim, lighter where it is stretched",
    .paint = PAINT_RUBBER,
};

const Mode* const mode_table[] = {&mode_skin,      &mode_quads,        &mode_springs,
                                  &mode_forces,    &mode_pressure,     &mode_stretch,
                                  &mode_thickness, &mode_volume_ratio, &mode_normals};
const int mode_count = sizeof mode_table / sizeof *mode_table;

const Mode* mode_find(const char* name) {
    return table_find(mode_table, mode_count, name);
}

bool mode_fits(const Mode* mode, const Balloon* balloon) {
    return !mode->fits || mode->fits(balloon);
}

bool mode_fits_any(const Mode* mode, const World* world) {
    for (int b = 0; b < world->balloon_count; b++)
        if (mode_fits(mode, &world->balloon[b]))
            return true;
    return false;
}

const Mode* mode_after(const Mode* mode, const World* world) {
    int m = 0;
    while (mode_table[m] != mode)
        m++;
    do
        m = (m + 1) % mode_count;
    while (!mode_fits_any(mode_table[m], world));
    return mode_table[m];
}

const char* mode_names(void) {
    static char names[256];
    return table_names(mode_table, mode_count, names, sizeof names);
}
