#include "view/status.h"

#include <stdio.h>
#include <string.h>

#include "mesh/measure.h"
#include "world/probe.h"

static void title(Panel* panel, const World* world) {
    const char* slash = strrchr(world->def.file, '/');
    const char* file = slash ? slash + 1 : world->def.file;
    const char* text = world->def.title ? world->def.title : file;
    panel_text(panel->title, sizeof panel->title, text);
}

static void time_rows(Panel* panel, const World* world, const Status* status) {
    char speed[32] = "";
    if (status->paused)
        snprintf(speed, sizeof speed, ", paused");
    else if (status->slow > 1)
        snprintf(speed, sizeof speed, ", 1/%d speed", status->slow);
    panel_row(panel, "time", "%.2f s%s", world_time(world), speed);

    if (world->substeps > 1)
        panel_row(panel, "step", "%g ms in %d parts", 1000 * world->step, world->substeps);
    else
        panel_row(panel, "step", "%g ms", 1000 * world->step);
    if (status->frame_ms > 0)
        panel_row(panel, "frame", "%.1f ms", status->frame_ms);
}

static void mode_row(Panel* panel, const World* world, const Picture* picture, const Mode* mode) {
    if (!mode_fits_any(mode, world))
        panel_row(panel, "shown", "%s, which nothing here has", mode->name);
    else if (mode->measure)
        panel_row(panel, "shown", "%s, %g to %g%s", mode->name, (double)picture->range[0],
                  (double)picture->range[1], mode->unit);
    else
        panel_row(panel, "shown", "%s", mode->name);
}

static bool gauge_pressure(const World* world, int balloon, double* value) {
    char column[64];
    snprintf(column, sizeof column, "balloon%d.gauge_pressure", balloon);
    return probe_value(world, column, value);
}

static void balloon_row(Panel* panel, const World* world, int b) {
    const Balloon* balloon = &world->balloon[b];
    const Inflation* inflation = &balloon->body.inflation;
    char text[PANEL_TEXT] = "";
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
    if (balloon->correct.on)
        snprintf(text + used, sizeof text - used, "%s%d springs corrected", used ? ", " : "",
                 balloon->correct.corrected);

    char label[32];
    snprintf(label, sizeof label, "balloon %d", b);
    panel_row(panel, label, "%s", text);
}

/// The balloon that keys act on. Rows for all of many would hide them.
static void balloon_rows(Panel* panel, const World* world) {
    if (world->balloon_count == 1)
        balloon_row(panel, world, 0);
    else if (world->selected != ALL_BALLOONS)
        balloon_row(panel, world, world->selected);
    else
        panel_row(panel, "balloons", "%d, tab selects one", world->balloon_count);
}

/// Balls, and what they are never to do: pass through a skin.
static void ball_rows(Panel* panel, const World* world, const Hand* hand) {
    const Contacts* contacts = &world->contacts;
    if (contacts->sphere_count == 0 && contacts->pass_throughs == 0)
        return;
    panel_row(panel, "balls", "%d", contacts->sphere_count);
    if (hand)
        panel_row(panel, "next ball", "mass %g, radius %g, speed %g", hand->mass, hand->radius,
                  hand->speed);
    panel_row(panel, "pass-throughs", "%ld", contacts->pass_throughs);
}

/// The sentence at the lower rim: the state that went bad, else what the user is told just now,
/// else what must not be.
static void message(Panel* panel, const World* world, const char* told) {
    const long count = world->contacts.pass_throughs;
    panel->alarm = world->blowup.halted || (!told[0] && count > 0);
    char text[sizeof panel->message] = "";
    if (panel->alarm && !world->blowup.halted)
        snprintf(text, sizeof text, "a ball passed through a skin: pass-throughs %ld", count);
    panel_text(panel->message, sizeof panel->message,
               world->blowup.halted ? world->blowup.text
               : told[0]            ? told
                                    : text);
}

void status_take(Panel* panel, const World* world, const Picture* picture, const Status* status) {
    panel->row_count = 0;
    title(panel, world);
    time_rows(panel, world, status);
    mode_row(panel, world, picture, status->mode);
    balloon_rows(panel, world);
    ball_rows(panel, world, status->hand);
    if (status->compared && status->compared[0])
        panel_row(panel, "ghost", "%s", status->compared);
    message(panel, world, status->message);
}
