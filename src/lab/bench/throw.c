#include "lab/bench/throw.h"

static const struct {
    double from[3], off[3];
} aim_table[THROW_AIMS] = {
    {{1, 0, 0}, {0, 0, 0}},                 // the center of a patch
    {{0.577, 0.577, 0.577}, {0, 0, 0}},     // a corner of valence 3
    {{-0.36, 0.48, 0.8}, {0.2, -0.1, 0.3}}, // a general direction, off center
    {{0, 1, 0}, {0.85, 0, 0}},              // grazing
};

enum { SETS = 7 };

bool throw_open(const Throw* t, World* world, Fault* fault) {
    const double* from = aim_table[t->aim].from;
    const double* off = aim_table[t->aim].off;
    const double away = 1.6 + t->radius, balloon = 1e-3 * (6 * t->side * t->side + 2);
    double x[3], v[3];
    for (int k = 0; k < 3; k++) {
        x[k] = away * from[k] + off[k];
        v[k] = -t->speed * from[k];
    }
    char model[64], step[64], ball[512];
    snprintf(model, sizeof model, "cube-sphere:%d", t->side);
    snprintf(step, sizeof step, "step=%.17g", 1 / t->rate);
    snprintf(ball, sizeof ball,
             "spheres=[{position: [%.17g, %.17g, %.17g], velocity: [%.17g, %.17g, %.17g], "
             "radius: %.17g, mass: %.17g, restitution: %.17g, friction: %.17g}]",
             x[0], x[1], x[2], v[0], v[1], v[2], t->radius, t->mass * balloon, t->restitution,
             t->friction);
    const SceneSet set[SETS] = {{step},
                                {ball},
                                {"gravity=0"},
                                {"balloons.0.strings=[]"},
                                {"balloons.0.helium={base: 0}"},
                                {"balloons.0.damping={coefficient: 0}"},
                                {"balloons.0.inflation={law: area, amount: 2}"}};
    WorldDef def;
    if (!scene_load(model, set, SETS, &def, fault) || !world_open(world, &def, fault))
        return false;
    world->contacts.plane_count = 0; // the scene of a mesh has a floor, far below
    return true;
}

long throw_steps(const Throw* t) {
    return lround(fmin(1, 6 / t->speed + 0.1) * t->rate);
}
