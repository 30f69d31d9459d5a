#include "show/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "base/interrupt.h"
#include "base/memory.h"
#include "base/stream.h"
#include "lab/run/report_line.h"
#include "show/pacer.h"
#include "show/session.h"
#include "world/fails.h"
#include "world/probe.h"

/// Update the maximum number of substeps of a step.
static void count_substeps(ReportLine* line, const World* world) {
    if (world->guard.substeps > line->substeps)
        line->substeps = world->guard.substeps;
}

/// Step until the world's clock reads `until` or a blowup; add the CPU time to `spent`.
static bool advance(Session* session, long until, bool quiet, double* spent, ReportLine* line,
                    Fault* fault) {
    World* world = session->world;
    const double start = clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
    bool good = true;
    while (good && world->clock < until && !world->blowup.halted && !world->notice[0] &&
           !interrupt_signal()) {
        good = session_step(session, fault);
        count_substeps(line, world);
    }
    *spent += clock_seconds(CLOCK_PROCESS_CPUTIME_ID) - start;
    if (session->ghost) // without the ghost's steps
        *spent = session->ghost->spent;

    if (world->notice[0] && !quiet)
        fprintf(stderr, "balloon: %s\n", world->notice);
    world->notice[0] = 0;
    return good;
}

static bool write_skins(const World* world, const char* path, Fault* fault) {
    FILE* out = stream_create(path, fault);
    if (!out)
        return false;
    fputs(RUN_OBJ_MARK, out);
    probe_obj(world, out);
    return stream_close(out, path, fault);
}

/// The next step in from < step < until at which an output of the scene's `about` or `fails` is due,
/// else `until`.
static long next_about(const World* world, long from, long until) {
    for (unsigned k = 0; k < scene_outputs(&world->def); k++) {
        const long at = pacer_steps(world->def.about[k].at, world->step);
        if (at > from && at < until)
            until = at;
    }
    if (world->def.fails) {
        const long at = pacer_steps(world->def.fails->at, world->step);
        if (at > from && at < until)
            until = at;
    }
    return until;
}

/// Measure the outputs of `about` that are due now; print: for people, too.
static void measure_about(const World* world, ReportLine* line, bool print) {
    for (int k = 0; k < line->outputs; k++) {
        const AboutDef* about = &world->def.about[k];
        if (pacer_steps(about->at, world->step) == world->clock &&
            probe_value(world, about->output, &line->output[k]) && print)
            printf("%s at %g s: %.9g\n", about->output, about->at, line->output[k]);
    }
}

static void print_fails(const World* world) {
    const FailsDef* fails = world->def.fails;
    double value;
    if (fails && fails->output && pacer_steps(fails->at, world->step) == world->clock &&
        probe_value(world, fails->output, &value)) {
        char words[512];
        fails_words(fails, words, sizeof words);
        printf("%s at %g s: %.9g, which %s: %s\n", fails->output, fails->at, value,
               fails_seen(world) ? "fails as said" : "does not fail as said", words);
    }
}

static void csv_header(const Session* session, FILE* csv) {
    probe_csv_header(session->world, csv);
    fputs(session->ghost ? ",ghost.distance,cost,ghost.cost\n" : "\n", csv);
}

static void csv_row(const Session* session, FILE* csv) {
    const World* world = session->world;
    const Ghost* ghost = session->ghost;
    probe_csv_row(world, csv);
    if (ghost)
        fprintf(csv, ",%.17g,%.6g,%.6g", ghost_distance(ghost, world),
                ghost_cost(ghost, world, false), ghost_cost(ghost, world, true));
    fputc('\n', csv);
}

/// Step to the end or to a blowup, writing rows of the CSV.
static bool simulate(Session* session, const RunOptions* options, FILE* csv, double* spent,
                     ReportLine* line, Fault* fault) {
    World* world = session->world;
    const long frames = pacer_steps(options->seconds, 1 / options->fps);
    const long steps = pacer_steps(options->seconds, world->step);
    if (csv) {
        csv_header(session, csv);
        csv_row(session, csv);
    }
    for (long k = 1; k <= frames + 1; k++) {
        const long until = k <= frames ? pacer_steps((double)k / options->fps, world->step) : steps;
        while (world->clock < until && !world->blowup.halted) {
            const long stop = next_about(world, world->clock, until);
            if (!advance(session, stop, options->quiet, spent, line, fault))
                return false;
            if (interrupt_signal())
                return interrupt_fault(world->def.file, world_time(world), fault);
            measure_about(world, line, !options->quiet && !csv);
            if (!options->quiet && !csv)
                print_fails(world);
        }
        if (world->blowup.halted)
            return fault_set(fault, world->def.file, "%s", world->blowup.text);
        if (csv && k <= frames)
            csv_row(session, csv);
        if (csv && ferror(csv)) // what the disk does not take need not be computed
            return false;
    }
    return true;
}

/// Print the report of a run that ended or blew up; after another fault there are no results.
static void print_report(const World* world, bool good, double spent, ReportLine* line) {
    if (!good && !world->blowup.halted)
        return;
    line->ended = good;
    line->steps = world->clock;
    line->seconds = world_time(world);
    line->cpu_ms = line->seconds > 0 ? 1e3 * spent / line->seconds : (double)NAN;
    count_substeps(line, world);
    snprintf(line->hash, sizeof line->hash, "%016llx", (unsigned long long)world_hash(world));
    report_line_print(line, stdout);
}

bool run(World* world, const RunOptions* options, Fault* fault) {
    Session session;
    FILE* csv = NULL;
    double spent = 0;
    ReportLine line = {.outputs = (int)scene_outputs(&world->def)};
    if (!session_open(&session, world, options->input, options->record, fault))
        return false;

    line.output = new_array(double, line.outputs + 1);
    for (int k = 0; k < line.outputs; k++)
        line.output[k] = (double)NAN;
    session_compare(&session, options->ghost);
    bool good = !options->csv || (csv = stream_create(options->csv, fault)) != NULL;
    good = good && simulate(&session, options, csv, &spent, &line, fault);
    if (csv) // rows before a blowup are valid
        good = stream_close(csv, options->csv, fault) && good;
    if (good && options->obj)
        good = write_skins(world, options->obj, fault);
    const double simulated = world->blowup.halted ? world_time(world) : options->seconds;
    if (options->time && simulated > 0 && (good || world->blowup.halted)) // until a blowup, too
        printf("stepping %.6f s of CPU time for %g s: %.6f ms per simulated second\n", spent,
               simulated, 1e3 * spent / simulated);
    if (good && options->ghost && !options->quiet) {
        char words[200];
        ghost_summary(options->ghost, world, words, sizeof words);
        fprintf(csv == stdout ? stderr : stdout, "%s\n", words);
    }
    if (options->report)
        print_report(world, good, spent, &line);
    free(line.output);
    return session_close(&session, fault) && good;
}
