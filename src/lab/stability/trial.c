#include "lab/stability/trial.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/random.h"
#include "force/damping.h"
#include "force/tangent.h"

const double trial_precision = 1e-3;

const char* const verdict_name[VERDICTS] = {"stable", "marginal", "exploded"};

// --- of the definition ---
static const double push_size =
    sizeof(real) == sizeof(double) ? 1e-6 : 1e-4; ///< [balloon's size]; float rounds to 6e-8
enum { TRIAL_STEPS = 2000 };
static const double explosion = 10; ///< [start energy]
/// Just below its limit, euler's undamped energy beats with the amplitude 1/(1 - h w/2) without
/// growing. So the search for the limit runs on up to this energy. [start energy]
static const double search_explosion = 1e4;

// --- of the measurement ---
/// A balloon is at rest if it moves less in a long step; in float this is above rounding. [push]
static const double rest_motion = sizeof(real) == sizeof(double) ? 1e-4 : 5e-2;
/// Every mode has a larger share of the start energy, so below this all modes have decayed. [1]
static const double decayed = 1e-4;
/// Growth of ln e in the fitted half that counts as zero, and the share of the variance that the
/// line must explain (R^2): undamped modes beat without growing. [1]
static const double growth_min = 0.1, explained_min = 0.5;
/// Steps of a run in the search for the limit. With damping, the distance of the eigenvalue outside
/// the unit circle is proportional to the excess of the step (`forward`: gamma h / 100 for each
/// percent); without damping, to its square root.
enum { DAMPED_STEPS = 40000, UNDAMPED_STEPS = 4000, SAMPLE_EVERY = 10 };

enum { MAX_RELAX = 400, MAX_ROUNDS = 4000, ROUNDS = 64, MAX_SETS = 16 };

static double potential(const Body* body) {
    double sum = 0;
    for (int k = 0; k < force_count; k++)
        if (force_table[k]->energy && force_table[k]->present(body))
            sum += force_table[k]->energy(body);
    return sum;
}

static double kinetic(const Body* body) {
    double sum = 0;
    for (int i = 0; i < body->count; i++)
        sum += 0.5 * (double)body->mass[i] * ddot(to_double4(body->v[i]), to_double4(body->v[i]));
    return sum;
}

static bool load(WorldDef* def, const char* scene, const SceneSet* set, int set_count,
                 const char* method, Fault* fault) {
    char word[64];
    SceneSet all[MAX_SETS + 4] = {{"guard='off'"}, {"gravity=0"}, {"solver.tolerance=1e-12"}};
    snprintf(word, sizeof word, "method=%s", method);
    int count = 3;
    all[count++].text = word;
    ASSERT(set_count <= MAX_SETS, "more overrides than a case of the lab has");
    for (int k = 0; k < set_count; k++)
        all[count++] = set[k];
    return scene_load(scene, all, count, def, fault);
}

/// Relaxation: a long step of backward Euler, then all velocities are set to zero, until the net
/// forces vanish.
static bool relax(Trial* trial, Fault* fault) {
    World* world = &trial->calm;
    const Body* body = &world->balloon[0].body;
    world->step = 0.1;
    world_step(world);
    double fastest_speed = 0;
    for (int i = 0; i < body->count; i++)
        fastest_speed = fmax(fastest_speed, (double)length(body->v[i]));
    memset(body->v, 0, (size_t)body->count * sizeof *body->v);
    trial->rested = fastest_speed * world->step <= rest_motion * push_size * body->size;
    if (trial->rested || (++trial->done < MAX_RELAX && !world->blowup.halted))
        return true;
    return fault_set(fault, world->def.file, "the balloon does not come to rest");
}

static void begin_fastest(Trial* trial) {
    Body* body = &trial->calm.balloon[0].body;
    tangent_open(&trial->tangent, body);
    tangent_update(&trial->tangent, body, 1, false);
    trial->mode = new_array(real4, body->count);
    trial->image = new_array(real4, body->count);
    Random random = {7};
    for (int i = 0; i < body->count; i++)
        for (int k = 0; k < 3; k++)
            trial->mode[i][k] = (real)(random_next(&random) - 0.5);
    trial->w2 = 0;
    trial->done = 0;
}

/// A round of power iteration for the largest eigenvalue of M^-1 K at the present positions. True:
/// it has converged.
static bool fastest(Trial* trial) {
    const Body* body = &trial->calm.balloon[0].body;
    real4 *mode = trial->mode, *image = trial->image;
    double norm = 0;
    for (int i = 0; i < body->count; i++)
        norm += (double)body->mass[i] * ddot(to_double4(mode[i]), to_double4(mode[i]));
    for (int i = 0; i < body->count; i++)
        mode[i] *= (real)(1 / sqrt(norm));
    tangent_multiply(&trial->tangent, body, 1, mode, image);
    const double last = trial->done == 0 ? -1 : trial->w2;
    trial->w2 = 0;
    for (int i = 0; i < body->count; i++) {
        trial->w2 += ddot(to_double4(mode[i]), to_double4(image[i]));
        mode[i] = image[i] * body->inverse_mass[i];
    }
    return ++trial->done == MAX_ROUNDS || !(fabs(trial->w2 - last) > 1e-14 * trial->w2);
}

static void end_preparation(Trial* trial) {
    if (trial->mode)
        tangent_close(&trial->tangent);
    free(trial->mode);
    free(trial->image);
    trial->mode = trial->image = NULL;
    world_close(&trial->calm);
}

static double damping_rate(const Body* body) {
    double rate = 0;
    for (int i = 0; i < body->count; i++)
        rate = fmax(rate, damping_drag(body, i) * (double)body->inverse_mass[i]);
    return rate;
}

bool trial_begin(Trial* trial, WorldDef* calm, WorldDef* def, Fault* fault) {
    *trial = (Trial){0};
    const bool good =
        world_open(&trial->calm, calm, fault) && world_open(&trial->world, def, fault);
    scene_free(def);
    if (!good)
        trial_close(trial);
    return good;
}

bool trial_prepare(Trial* trial, bool* prepared, Fault* fault) {
    *prepared = false;
    if (!trial->rested) {
        if (!relax(trial, fault))
            return false;
        if (trial->rested)
            begin_fastest(trial);
        return true;
    }
    for (int round = 0; round < ROUNDS && !*prepared; round++)
        *prepared = fastest(trial);
    if (!*prepared)
        return true;

    Body* body = &trial->calm.balloon[0].body;
    trial->rest = new_array(real4, body->count);
    memcpy(trial->rest, body->x, (size_t)body->count * sizeof *body->x);
    trial->potential = potential(body);
    trial->gamma = damping_rate(body);
    end_preparation(trial);
    return true;
}

bool trial_open(Trial* trial, const char* scene, const SceneSet* set, int set_count,
                const Method* method, const char** refused, Fault* fault) {
    WorldDef calm, def;
    *trial = (Trial){0};
    *refused = NULL;
    bool good = load(&calm, scene, set, set_count, method_newton.name, fault) &&
                world_open(&trial->calm, &calm, fault);
    if (good)
        *refused = method_refuses(method, &trial->calm.balloon[0].body);
    good = good && !*refused && load(&def, scene, set, set_count, method->name, fault) &&
           world_open(&trial->world, &def, fault);
    bool prepared = false;
    while (good && !prepared)
        good = trial_prepare(trial, &prepared, fault);
    if (!good)
        trial_close(trial);
    return good;
}

/// The state that every run begins with.
static void push(Trial* trial, double h) {
    World* world = &trial->world;
    world_reset(world);
    world->step = h;
    Body* body = &world->balloon[0].body;
    Random random = {12345};
    const double far = push_size * body->size;
    const double fast = trial->gamma > 0 ? far * sqrt(trial->w2) : 0;
    for (int i = 0; i < body->count; i++)
        for (int k = 0; k < 3; k++) {
            body->x[i][k] = trial->rest[i][k] + (real)(far * (2 * random_next(&random) - 1));
            body->v[i][k] = (real)(fast * (2 * random_next(&random) - 1));
        }
}

static void fit_add(TrialFit* fit, double n, double y) {
    fit->count++;
    fit->n += n;
    fit->n2 += n * n;
    fit->y += y;
    fit->y2 += y * y;
    fit->ny += n * y;
}

/// Slope of the line, and the share of the points' variance that it explains (R^2).
static double fit_slope(const TrialFit* fit, double* explained) {
    const double nn = fit->count * fit->n2 - fit->n * fit->n,
                 yy = fit->count * fit->y2 - fit->y * fit->y,
                 ny = fit->count * fit->ny - fit->n * fit->y;
    *explained = ny * ny / (nn * yy);
    return ny / nn;
}

static double perturbation_energy(const Trial* trial) {
    const Body* body = &trial->world.balloon[0].body;
    return kinetic(body) + potential(body) - trial->potential;
}

static void start(Trial* trial, double h, int steps, double max) {
    push(trial, h);
    trial->h = h;
    trial->steps = steps;
    trial->max = max;
    trial->steps_done = 0;
    trial->start_energy = perturbation_energy(trial);
    trial->later = (TrialFit){0};
}

void trial_start(Trial* trial, double h) {
    start(trial, h, TRIAL_STEPS, explosion);
}

/// Step until the energy has grown by the factor `max`, has decayed, or the run ends.
bool trial_follow(Trial* trial, int steps, Verdict* verdict, double* growth) {
    World* world = &trial->world;
    const double start_energy = trial->start_energy, h = trial->h;
    for (int k = 0; k < steps && trial->steps_done < trial->steps; k++) {
        world_step(world);
        const int n = ++trial->steps_done;
        if (n % SAMPLE_EVERY && !world->blowup.halted)
            continue;
        const double now = perturbation_energy(trial);
        const bool grown = world->blowup.halted || !(now < trial->max * start_energy);
        if (grown || now < decayed * start_energy) {
            *growth = log(fabs(now / start_energy)) / (n * h);
            *verdict = grown ? VERDICT_EXPLODED : VERDICT_STABLE;
            return true;
        }
        if (n > trial->steps / 2)
            fit_add(&trial->later, n, log(now / start_energy));
    }
    if (trial->steps_done < trial->steps)
        return false;
    double explained;
    const double slope = fit_slope(&trial->later, &explained);
    *growth = slope / h;
    const int half = trial->steps / 2;
    const bool grows = slope * half > growth_min && explained > explained_min;
    *verdict = grows ? VERDICT_MARGINAL : VERDICT_STABLE;
    return true;
}

static Verdict follow(Trial* trial, double* growth) {
    Verdict verdict = VERDICT_STABLE;
    while (!trial_follow(trial, trial->steps, &verdict, growth))
        ;
    return verdict;
}

Verdict trial_run(Trial* trial, double h, double* growth) {
    trial_start(trial, h);
    return follow(trial, growth);
}

static bool is_stable(Trial* trial, double h) {
    double growth;
    start(trial, h, trial->gamma > 0 ? DAMPED_STEPS : UNDAMPED_STEPS, search_explosion);
    return follow(trial, &growth) == VERDICT_STABLE;
}

double trial_limit(Trial* trial) {
    const double scale = 2 / sqrt(trial->w2), min = scale / 100, max = scale * 100;
    if (!is_stable(trial, min))
        return 0;
    double stable = min, unstable = min;
    do {
        stable = unstable;
        unstable = 4 * stable;
        if (unstable > max)
            return INFINITY;
    } while (is_stable(trial, unstable));
    while (unstable - stable > trial_precision * stable) {
        const double middle = (stable + unstable) / 2;
        *(is_stable(trial, middle) ? &stable : &unstable) = middle;
    }
    return stable;
}

double trial_theory(const Trial* trial) {
    return method_limit(trial->world.method, trial->w2, trial->gamma);
}

double trial_bound(Trial* trial) {
    push(trial, trial->world.step);
    return method_bound(trial->world.method, &trial->world.balloon[0].body);
}

void trial_close(Trial* trial) {
    end_preparation(trial);
    world_close(&trial->world);
    free(trial->rest);
    *trial = (Trial){0};
}
