#include "lab/advice/advise.h"

#include <errno.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "lab/run/refinement.h"

const double ADVISE_MARGIN = 1.5, ADVISE_FPS = 60;

bool advise_points(const char* scene, const SceneSet* set, int set_count, bool fresh,
                   Advice* advice, Fault* fault) {
    char* text = scene_text(scene, set, set_count, false, fault);
    if (!text)
        return false;
    bool good = !fresh && advise_recall(text, advice);
    if (!good)
        good = advise_measure(scene, set, set_count, advice, fault) &&
               advise_keep(text, advice, fault);
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

/// Errors this near to the least within a budget are as good, and may be much cheaper. [1]
static const double as_good = 1.1;

const AdvicePoint* advise_pick(const Advice* advice, double error, double ms,
                               const AdvicePoint** best) {
    double least = INFINITY;
    const AdvicePoint *found = NULL, *near = NULL;
    for (int k = 0; k < advice->count; k++) {
        const AdvicePoint* p = &advice->point[k];
        if (p->ms <= ms)
            least = fmin(least, advise_promise(advice, p));
        if (isfinite(p->error) &&
            (!near || (error > 0 ? p->error < near->error : p->ms < near->ms)))
            near = p;
    }
    const double wanted = error > 0 ? error : as_good * least;
    for (int k = 0; k < advice->count; k++) {
        const AdvicePoint* p = &advice->point[k];
        if (isfinite(p->error) && advise_promise(advice, p) <= wanted &&
            (error > 0 || p->ms <= ms) && (!found || p->ms < found->ms))
            found = p;
    }
    *best = near;
    return found;
}

static bool is_beaten(const Advice* advice, const AdvicePoint* point) {
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
        if (!isfinite(point->error) || !isfinite(point->ms) || is_beaten(advice, point))
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
    if (point->level != 0)
        refinement_add(world, point->level, sets);
}

// --- the verb ------------------------------------------------------------------------------------

/// The point that is asked for, or with `anyway` what comes nearest, as overrides.
static bool advise(const AdviseOptions* options, bool anyway, Advice* advice, AdvicePoint* point,
                   Overrides* sets, Fault* fault) {
    WorldDef def;
    World world;
    if (!advise_points(options->scene, options->set, options->set_count, options->fresh, advice,
                       fault) ||
        !scene_load(options->scene, options->set, options->set_count, &def, fault) ||
        !world_open(&world, &def, fault))
        return false;
    scene_say_renamed(&world.def);
    const AdvicePoint* best;
    const AdvicePoint* found = advise_pick(advice, options->error, options->ms, &best);
    bool good = true;
    if (!best)
        good = fault_set(fault, world.def.file, "no method comes to the end of this scene");
    else if (!found && !anyway)
        good = fault_set(fault, world.def.file, "the best here is %.2g %%, for %.2g ms a frame",
                         100 * advise_promise(advice, best), best->ms);
    if (good) {
        *point = found ? *found : *best;
        advise_sets(&world, point, sets);
    }
    world_close(&world);
    return good;
}

/// The scene's overrides, then those of the advice.
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
    fprintf(out,
            ": at most %.2g %% off, for %.2g ms of CPU time a frame (1/%g s).\n# What was put in "
            "its place:",
            100 * advise_promise(advice, point), point->ms, ADVISE_FPS);
    for (int k = 0; k < sets->count; k++)
        fprintf(out, "%s %s", k ? "," : "", sets->text[k]);
    fputc('\n', out);
}

bool advise_run(const AdviseOptions* options, Fault* fault) {
    Advice advice = {0};
    AdvicePoint point;
    Overrides sets = {.count = 0};
    SceneSet* all = new_array(SceneSet, options->set_count + MAX_OVERRIDES);
    char* text = NULL;
    if (advise(options, false, &advice, &point, &sets, fault)) {
        const int count = join(options, &sets, all);
        text = scene_text(options->scene, all, count, true, fault);
    }
    FILE* out = !text ? NULL : options->out ? fopen(options->out, "w") : stdout;
    bool good = out != NULL;
    if (text && !out)
        fault_set(fault, options->out, "cannot be written: %s", strerror(errno));
    if (out) {
        write_head(options, &advice, &point, &sets, out);
        fputs(text, out);
        good = !ferror(out) && fflush(out) == 0;
        if (options->out)
            good = fclose(out) == 0 && good;
        if (!good)
            fault_set(fault, options->out, "could not be written to its end");
    }
    free(text);
    free(all);
    advise_free(&advice);
    return good;
}

bool advise_auto(const AdviseOptions* options, Overrides* sets, Fault* fault) {
    Advice advice = {0};
    AdvicePoint point;
    const bool good = advise(options, true, &advice, &point, sets, fault);
    if (good)
        fprintf(stderr, "balloon: %s, %s, step %.3g s: at most %.2g %% off, for %.2g ms a frame\n",
                point.method, point.precision, point.step, 100 * advise_promise(&advice, &point),
                point.ms);
    advise_free(&advice);
    return good;
}
