#include <stdio.h>

#include "cli/open.h"
#include "base/interrupt.h"
#include "cli/overwrite.h"
#include "cli/verb.h"
#include "show/run.h"
#include "show/show.h"

enum { SIDE_MIN = 16, SIDE_MAX = 16384 }; ///< of a picture [pixels]

static bool show_options(const Options* options, const Sets* sets, const World* world, Ghost* ghost,
                         ShowOptions* show, Fault* fault) {
    *show = show_options_default();
    show->out = options->out ? options->out : "out";
    show->input = options->input;
    show->record = options->record;
    show->mode = options->mode;
    show->set = sets->set;
    show->set_count = sets->count;
    show->quiet = options->quiet;
    show->time = options->time;
    show->overlay = options->overlay;
    show->compare = options->compare;
    show->ghost = options->compare ? ghost : NULL;
    show->lab = options->lab;
    char rest;
    if (options->size &&
        (sscanf(options->size, "%5dx%5d%c", &show->width, &show->height, &rest) != 2 ||
         show->width < SIDE_MIN || show->height < SIDE_MIN || show->width > SIDE_MAX ||
         show->height > SIDE_MAX))
        return fault_set(fault, "--size",
                         "'%s' is not a size such as 1280x720; each side is %d to %d pixels",
                         options->size, SIDE_MIN, SIDE_MAX);
    return cli_times(options, world, &show->seconds, &show->fps, fault);
}

/// Print the hash with --hash; close the world and its ghost.
static bool print_hash_and_close(const Options* options, World* world, Ghost* ghost, bool good) {
    if (good && options->hash)
        printf("%016llx\n", (unsigned long long)world_hash(world));
    world_close(world);
    world_close(&ghost->world);
    return good;
}

/// Measure beside the window what --auto asks for.
static bool begin_advice(const Options* options, AdviseLater* advice, Fault* fault) {
    AdviseOptions advise;
    return cli_open_advice(options, &advise, fault) && advise_later_begin(advice, &advise, fault);
}

static bool show_pair(const Options* options, bool window, AdviseLater* advice, Fault* fault) {
    World world;
    ShowOptions show;
    Ghost ghost = {0};
    Sets sets;
    interrupt_catch();
    if (!overwrite_allowed(options, fault) ||
        (!window &&
         !overwrite_allows_pictures(options, options->out ? options->out : "out", fault)))
        return false;
    Options now = *options;
    now.advised = options->advised && !advice;
    if (!cli_open_pair(&now, &sets, &world, &ghost, fault))
        return false;
    bool good = show_options(options, &sets, &world, &ghost, &show, fault) &&
                (!advice || begin_advice(options, advice, fault));
    show.advice = advice;
    if (window) {
        show.overlay = true;
        if (!options->seconds) // until it is closed
            show.seconds = 0;
    }
    good = good && (window ? show_play : show_render)(&world, &show, fault);
    return print_hash_and_close(options, &world, &ghost, good);
}

/// A window opens at once: what takes time to measure is measured meanwhile.
bool verb_play(const Options* options, Fault* fault) {
    AdviseOptions advise;
    AdviseLater later = {0};
    if (!options->advised)
        return show_pair(options, true, NULL, fault);
    if (!cli_open_advice(options, &advise, fault))
        return false;
    const bool kept = advise_is_cached(&advise);
    const bool good = show_pair(options, true, kept ? NULL : &later, fault);
    advise_later_close(&later);
    return good;
}

bool verb_render(const Options* options, Fault* fault) {
    return show_pair(options, false, NULL, fault);
}

/// Whether nothing would tell that a run has ended: no result was asked for, and the scene is about
/// no output at a time that the run reached.
static bool prints_nothing(const Options* options, const World* world, double seconds) {
    for (unsigned k = 0; k < scene_outputs(&world->def); k++)
        if (world->def.about[k].at <= seconds)
            return false;
    return !options->csv && !options->mesh && !options->record && !options->hash &&
           !options->time && !options->report && !options->compare && !options->quiet;
}

bool verb_run(const Options* options, Fault* fault) {
    World world;
    Ghost ghost = {0};
    Sets sets;
    RunOptions run_options = {.csv = options->csv,
                              .obj = options->mesh,
                              .input = options->input,
                              .record = options->record,
                              .time = options->time,
                              .report = options->report,
                              .ghost = options->compare ? &ghost : NULL,
                              .quiet = options->quiet};
    interrupt_catch();
    if (!overwrite_allowed(options, fault) || !cli_open_pair(options, &sets, &world, &ghost, fault))
        return false;
    const bool good = cli_times(options, &world, &run_options.seconds, &run_options.fps, fault) &&
                      run(&world, &run_options, fault);
    if (good && prints_nothing(options, &world, run_options.seconds))
        printf("%s: %g s simulated; --report, --hash, --time, --csv FILE or --mesh FILE give "
               "results\n",
               world.def.file, run_options.seconds);
    return print_hash_and_close(options, &world, &ghost, good);
}
