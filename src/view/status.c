#include "view/status.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "mesh/measure.h"
#include "world/probe.h"

static const double crossing_seconds = 0.2; ///< [s] simulated, between two counts of crossings

static void title(Overlay* overlay, const World* world) {
    const char* slash = strrchr(world->def.file, '/');
    const char* file = slash ? slash + 1 : world->def.file;
    const char* text = world->def.title ? world->def.title : file;
    overlay_text(overlay->title, sizeof overlay->title, text);
}

static void time_rows(Overlay* overlay, const World* world, const Status* status) {
    char speed[32] = "";
    if (status->paused)
        snprintf(speed, sizeof speed, ", paused");
    else if (status->slowdown > 1)
        snprintf(speed, sizeof speed, ", 1/%d speed", status->slowdown);
    overlay_row(overlay, "time", "%.2f s%s", world_time(world), speed);

    if (world->guard.substeps > 1)
        overlay_row(overlay, "step", "%g ms in %d substeps", 1000 * world->step,
                    world->guard.substeps);
    else
        overlay_row(overlay, "step", "%g ms", 1000 * world->step);
    if (world->guard.taken_back > 0)
        overlay_row(overlay, "taken back", "%ld steps", world->guard.taken_back);
    if (status->frame_ms > 0)
        overlay_row(overlay, "frame", "%.1f ms", status->frame_ms);
}

static void mode_row(Overlay* overlay, const World* world, const Picture* picture,
                     const Mode* mode) {
    if (!mode_fits_any(mode, world))
        overlay_row(overlay, "mode", "%s, which no balloon here has", mode->name);
    else if (mode->measure)
        overlay_row(overlay, "mode", "%s, %g to %g%s", mode->name, (double)picture->range[0],
                    (double)picture->range[1], mode->unit);
    else
        overlay_row(overlay, "mode", "%s", mode->name);
}

static bool gauge_pressure(const World* world, int balloon, double* value) {
    char column[64];
    snprintf(column, sizeof column, "balloon%d.gauge_pressure", balloon);
    return probe_value(world, column, value);
}

static void balloon_row(Overlay* overlay, const World* world, int b) {
    const Balloon* balloon = &world->balloon[b];
    const Inflation* inflation = &balloon->body.inflation;
    char text[OVERLAY_TEXT] = "";
    double pressure;
    size_t used = 0;
    if (inflation->law != INFLATE_NONE)
        used += (size_t)snprintf(text, sizeof text, "amount %.4g", inflation->amount);
    if (gauge_pressure(world, b, &pressure))
        used += (size_t)snprintf(text + used, sizeof text - used, "%spressure %.4g",
                                 used ? ", " : "", pressure);
    if (inflation->first_volume > 0)
        used += (size_t)snprintf(text + used, sizeof text - used, ", volume x %.3g",
                                 measure_volume(&balloon->mesh, balloon->body.x) /
                                     inflation->first_volume);
    if (balloon->strain_limit.on)
        snprintf(text + used, sizeof text - used, "%s%d springs corrected", used ? ", " : "",
                 balloon->strain_limit.corrected);

    char label[32];
    snprintf(label, sizeof label, "balloon %d", b);
    overlay_row(overlay, label, "%s", text);
}

/// A row for the selected balloon only: a row for each of many would cover the picture.
static void balloon_rows(Overlay* overlay, const World* world) {
    if (world->balloon_count == 1)
        balloon_row(overlay, world, 0);
    else if (world->selected != ALL_BALLOONS)
        balloon_row(overlay, world, world->selected);
    else
        overlay_row(overlay, "balloons", "%d, tab selects one", world->balloon_count);
}

/// Balls, and the count of pass-throughs, which must be 0.
static void ball_rows(Overlay* overlay, const World* world, const Thrower* thrower) {
    const Contacts* contacts = &world->contacts;
    if (contacts->sphere_count == 0 && contacts->pass_throughs == 0)
        return;
    overlay_row(overlay, "balls", "%d", contacts->sphere_count);
    if (thrower)
        overlay_row(overlay, "next ball", "mass %g, radius %g, speed %g", thrower->mass,
                    thrower->radius, thrower->speed);
    overlay_row(overlay, "pass-throughs", "%ld", contacts->pass_throughs);
}

/// Crossings of skins that touch, which must be 0 but for those that began crossed. Counted a few
/// times a second: it takes a search through all skins.
static void crossing_row(Overlay* overlay, const World* world) {
    const long interval = lround(crossing_seconds / world->step) + 1;
    if (overlay->crossings_clock == 0 || world->clock < overlay->crossings_clock - 1 ||
        world->clock >= overlay->crossings_clock - 1 + interval) {
        overlay->has_crossings = probe_value(world, "crossings", &overlay->crossings);
        overlay->crossings_clock = world->clock + 1;
    }
    if (overlay->has_crossings)
        overlay_row(overlay, "crossings", "%.0f", overlay->crossings);
}

/// The sentence at the lower edge: a blowup, else the message to the user, else a pass-through.
static void message(Overlay* overlay, const World* world, const char* user_message) {
    const long count = world->contacts.pass_throughs;
    overlay->alarm = world->blowup.halted || (!user_message[0] && count > 0);
    char text[sizeof overlay->message] = "";
    if (overlay->alarm && !world->blowup.halted)
        snprintf(text, sizeof text, "a ball passed through a skin: pass-throughs %ld", count);
    overlay_text(overlay->message, sizeof overlay->message,
                 world->blowup.halted ? world->blowup.text
                 : user_message[0]    ? user_message
                                      : text);
}

void status_fill(Overlay* overlay, const World* world, const Picture* picture,
                 const Status* status) {
    overlay->row_count = 0;
    title(overlay, world);
    time_rows(overlay, world, status);
    mode_row(overlay, world, picture, status->mode);
    balloon_rows(overlay, world);
    ball_rows(overlay, world, status->thrower);
    crossing_row(overlay, world);
    if (status->compared && status->compared[0])
        overlay_row(overlay, "ghost", "%s", status->compared);
    message(overlay, world, status->message);
}
