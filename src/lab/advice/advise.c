#include "lab/advice/advise.h"

#include <errno.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "lab/run/refinement.h"

const double ADVISE_MARGIN = 1.5, ADVISE_FPS = 60;

static int outputs_of(const char* scene, const SceneSet* set, int set_count) {
    WorldDef def;
    Fault unused = {0};
    if (!scene_load(scene, set, set_count, &def, &unused))
        return 0;
    const int outputs = (int)scene_outputs(&def);
    scene_free(&def);
    return outputs;
}

bool advise_points(const char* scene, const SceneSet* set, int set_count, bool fresh,
                   Advice* advice, Fault* fault) {
    char* text = scene_text(scene, set, set_count, false, fault);
    if (!text)
        return false;
    const int outputs = outputs_of(scene, set, set_count);
    bool good = !fresh && outputs > 0 && advise_cache_read(text, outputs, advice);
    if (!good) {
        good = advise_measure(scene, set, set_count, advice, fault);
        if (good)
            advise_cache_write(text, advice);
    }
    free(text);
    return good;
}

void advise_free(Advice* advice) {
    free(advice->point);
    *advice = (Advice){0};
}

double advise_promise(const Advice* advice, const AdvicePoint* point) {
    return ADVISE_MARGIN * point->error + advice->floor;
}

/// Promised errors up to this times the smallest within a budget count as equally good, because
/// such points may be much cheaper. [1]
static const double equally_good = 1.1;

const AdvicePoint* advise_pick(const Advice* advice, double error, double ms,
                               const AdvicePoint** nearest) {
    double min_error = INFINITY;
    const AdvicePoint *found = NULL, *near = NULL;
    for (int k = 0; k < advice->count; k++) {
        const AdvicePoint* p = &advice->point[k];
        if (p->ms <= ms)
            min_error = fmin(min_error, advise_promise(advice, p));
        if (isfinite(p->error) &&
            (!near || (error > 0 ? p->error < near->error : p->ms < near->ms)))
            near = p;
    }
    const double max_error = error > 0 ? error : equally_good * min_error;
    for (int k = 0; k < advice->count; k++) {
        const AdvicePoint* p = &advice->point[k];
        if (isfinite(p->error) && advise_promise(advice, p) <= max_error &&
            (error > 0 || p->ms <= ms) && (!found || p->ms < found->ms))
            found = p;
    }
    *nearest = near;
    return found;
}

/// Whether another point is at least as cheap and as accurate; of two equal points the first
/// remains.
static bool is_dominated(const Advice* advice, const AdvicePoint* point) {
    for (int k = 0; k < advice->count; k++) {
        const AdvicePoint* other = &advice->point[k];
        const bool less = other->ms < point->ms || other->error < point->error;
        if (other != point && other->ms <= point->ms && other->error <= point->error &&
            (less || other < point))
            return true;
    }
    return false;
}

int advise_front(const Advice* advice, const AdvicePoint** front) {
    int count = 0;
    for (int k = 0; k < advice->count; k++) {
        const AdvicePoint* point = &advice->point[k];
        if (!isfinite(point->error) || !isfinite(point->ms) || is_dominated(advice, point))
            continue;
        int at = count++;
        for (; at > 0 && front[at - 1]->ms > point->ms; at--)
            front[at] = front[at - 1];
        front[at] = point;
    }
    return count;
}

void advise_sets(const World* world, const AdvicePoint* point, Overrides* sets) {
    overrides_add(sets, "guard=split");
    overrides_add(sets, "method=%s", point->method);
    overrides_add(sets, "step=%.17g", point->step);
    overrides_add(sets, "precision=%s", point->precision);
    if (point->refinement != 0)
        refinement_add(world, point->refinement, sets);
}

// --- the verb ------------------------------------------------------------------------------------

bool advise_is_cached(const AdviseOptions* options) {
    Fault unused = {0};
    Advice advice = {0};
    char* text = scene_text(options->scene, options->set, options->set_count, false, &unused);
    const bool cached =
        text && !options->fresh &&
        advise_cache_read(text, outputs_of(options->scene, options->set, options->set_count),
                          &advice);
    free(text);
    advise_free(&advice);
    return cached;
}

static void remove_other_precisions(Advice* advice, const char* precision) {
    int count = 0;
    for (int k = 0; k < advice->count; k++)
        if (strcmp(advice->point[k].precision, precision) == 0)
            advice->point[count++] = advice->point[k];
    advice->count = count;
}

/// The requested point and its overrides; with `or_nearest` the nearest point where none meets the
/// request.
static bool advise(const AdviseOptions* options, bool or_nearest, Advice* advice,
                   AdvicePoint* point, Overrides* sets, Fault* fault) {
    WorldDef def;
    World world;
    if (!advise_points(options->scene, options->set, options->set_count, options->fresh, advice,
                       fault) ||
        !scene_load(options->scene, options->set, options->set_count, &def, fault) ||
        !world_open(&world, &def, fault))
        return false;
    scene_say_renamed(&world.def);
    if (options->precision)
        remove_other_precisions(advice, options->precision);
    const AdvicePoint* nearest;
    const AdvicePoint* found = advise_pick(advice, options->error, options->ms, &nearest);
    bool good = true;
    if (!nearest)
        good = fault_set(fault, world.def.file, "no method comes to the end of this scene");
    else if (!found && !or_nearest)
        good = fault_set(fault, world.def.file, "the best here is %.2g %%, for %.2g ms a frame",
                         100 * advise_promise(advice, nearest), nearest->ms);
    if (good) {
        *point = found ? *found : *nearest;
        advise_sets(&world, point, sets);
    }
    world_close(&world);
    return good;
}

/// The scene's overrides, then those of the advice. Returns their number.
static int join(const AdviseOptions* options, const Overrides* sets, SceneSet* all) {
    int count = 0;
    for (int k = 0; k < options->set_count; k++)
        all[count++] = options->set[k];
    for (int k = 0; k < sets->count; k++)
        all[count++].text = sets->text[k];
    return count;
}

static void write_head(const AdviseOptions* options, const Advice* advice, const AdvicePoint* point,
                       const Overrides* sets, FILE* out) {
    fprintf(out, "# %s, ", options->scene);
    if (options->error > 0)
        fprintf(out, "as cheap as %g %% can be had", 100 * options->error);
    else
        fprintf(out, "as close as %g ms a frame can be", options->ms);
    fprintf(out, ": at most %.2g %% off, for %.2g ms of CPU time a frame (1/%g s).\n" ADVISE_MARK,
            100 * advise_promise(advice, point), point->ms, ADVISE_FPS);
    for (int k = 0; k < sets->count; k++)
        fprintf(out, "%s %s", k ? "," : "", sets->text[k]);
    fputc('\n', out);
}

static void describe(const Advice* advice, const AdvicePoint* point, char* text, size_t size) {
    snprintf(text, size, "%s, %s, step %.3g s: at most %.2g %% off, for %.2g ms a frame",
             point->method, point->precision, point->step, 100 * advise_promise(advice, point),
             point->ms);
}

/// Write the advised scene, or with `report` lines for programs.
static bool write_advice(const AdviseOptions* options, const Advice* advice,
                         const AdvicePoint* point, const Overrides* sets, FILE* out, Fault* fault) {
    if (options->report) {
        char text[160];
        for (int k = 0; k < sets->count; k++)
            fprintf(out, "set %s\n", sets->text[k]);
        describe(advice, point, text, sizeof text);
        fprintf(out, "says %s\n", text);
        return true;
    }
    SceneSet* all = new_array(SceneSet, options->set_count + MAX_OVERRIDES);
    const int count = join(options, sets, all);
    char* text = scene_text(options->scene, all, count, true, fault);
    const bool good = text != NULL;
    if (good) {
        write_head(options, advice, point, sets, out);
        fputs(text, out);
    }
    free(all);
    free(text);
    return good;
}

bool advise_run(const AdviseOptions* options, Fault* fault) {
    Advice advice = {0};
    AdvicePoint point;
    Overrides sets = {.count = 0};
    bool good = advise(options, options->report, &advice, &point, &sets, fault);
    FILE* out = !good ? NULL : options->out ? fopen(options->out, "w") : stdout;
    if (good && !out)
        good = fault_set(fault, options->out, "cannot be written: %s", strerror(errno));
    if (out) {
        good = write_advice(options, &advice, &point, &sets, out, fault);
        bool complete = !ferror(out) && fflush(out) == 0;
        if (options->out)
            complete = fclose(out) == 0 && complete;
        if (good && !complete)
            good = fault_set(fault, options->out, "could not be written to its end");
    }
    advise_free(&advice);
    return good;
}

bool advise_auto(const AdviseOptions* options, Overrides* sets, Fault* fault) {
    Advice advice = {0};
    AdvicePoint point;
    const bool good = advise(options, true, &advice, &point, sets, fault);
    if (good) {
        char text[160];
        describe(&advice, &point, text, sizeof text);
        fprintf(stderr, "balloon: %s\n", text);
    }
    advise_free(&advice);
    return good;
}
