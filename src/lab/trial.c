#include "lab/trial.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/random.h"
#include "force/tangent.h"

const double trial_precision = 1e-3;

const char* const verdict_name[VERDICTS] = {"stable", "wobbling", "exploded"};

// --- of the definition ---
static const double push_size =
    sizeof(real) == sizeof(double) ? 1e-6 : 1e-4; ///< [balloon's size]; float rounds to 6e-8
enum { TRIAL_STEPS = 2000 };
static const double explosion = 10; ///< [first energy]
/// Just below its limit, euler's undamped energy beats with the amplitude 1/(1 - h w/2), which is
/// no growth: a search for the limit goes on to here. [first energy]
static const double beyond = 1e4;

// --- of the measurement ---
/// What still moves in a long step is at rest. [push]
static const double still = 1e-4;
/// Every mode has more than this of the first energy: what is left then decays too. [1]
static const double spent = 1e-4;
/// Growth of ln e in the fitted half that is not told from zero, and the part of its variance that
/// a line must explain: undamped modes beat without growing. [1]
static const double told = 0.1, line = 0.5;
/// [steps] of a run that looks for the limit. Damped, the fastest mode leaves the unit circle in
/// proportion to what the step is too long by (`forward`: a hundredth of gamma h for each per
/// cent); undamped, with its square root.
enum { DAMPED_STEPS = 40000, UNDAMPED_STEPS = 4000, SAMPLE_EVERY = 10 };

enum { RELAX_MOST = 400, ROUNDS_MOST = 4000, SETS_MOST = 16 };

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

static bool open_world(World* world, const char* scene, const SceneSet* set, int set_count,
                       const char* method, Fault* fault) {
    char word[64];
    SceneSet all[SETS_MOST + 4] = {{"guard='off'"}, {"gravity=0"}, {"solver.tolerance=1e-12"}};
    snprintf(word, sizeof word, "method=%s", method);
    int count = 3;
    all[count++].text = word;
    ASSERT(set_count <= SETS_MOST, "more overrides than a case of the lab has");
    for (int k = 0; k < set_count; k++)
        all[count++] = set[k];
    WorldDef def;
    return scene_load(scene, all, count, &def, fault) && world_open(world, &def, fault);
}

/// Long steps of backward Euler, each from rest, so that not even a spin is left: the world comes
/// to where no net force is left.
static bool relax(World* world, Fault* fault) {
    const Body* body = &world->balloon[0].body;
    world->step = 0.1;
    for (int n = 0; n < RELAX_MOST && !world->blowup.halted; n++) {
        world_step(world);
        double most = 0;
        for (int i = 0; i < body->count; i++)
            most = fmax(most, (double)length(body->v[i]));
        memset(body->v, 0, (size_t)body->count * sizeof *body->v);
        if (most * world->step <= still * push_size * body->size)
            return true;
    }
    return fault_set(fault, world->def.file, "the balloon does not come to rest");
}

/// Largest eigenvalue of M^-1 K at the present positions, by power iteration until it stands still.
static double fastest(Body* body) {
    Tangent tangent;
    tangent_open(&tangent, body);
    tangent_ready(&tangent, body, 1, false);
    const int n = body->count;
    real4* mode = new_array(real4, n);
    real4* image = new_array(real4, n);
    Random random = {7};
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++)
            mode[i][k] = (real)(random_next(&random) - 0.5);

    double w2 = 0, last = -1;
    for (int round = 0; round < ROUNDS_MOST && fabs(w2 - last) > 1e-14 * w2; round++) {
        double norm = 0;
        for (int i = 0; i < n; i++)
            norm += (double)body->mass[i] * ddot(to_double4(mode[i]), to_double4(mode[i]));
        for (int i = 0; i < n; i++)
            mode[i] *= (real)(1 / sqrt(norm));
        tangent_multiply(&tangent, body, 1, mode, image);
        last = w2;
        w2 = 0;
        for (int i = 0; i < n; i++) {
            w2 += ddot(to_double4(mode[i]), to_double4(image[i]));
            mode[i] = image[i] * body->inverse_mass[i];
        }
    }
    tangent_close(&tangent);
    free(mode);
    free(image);
    return w2;
}

static double damping_rate(const Body* body) {
    double rate = 0;
    for (int i = 0; i < body->count; i++)
        rate = fmax(rate, body_drag(body, i) * (double)body->inverse_mass[i]);
    return rate;
}

bool trial_open(Trial* trial, const char* scene, const SceneSet* set, int set_count,
                const Method* method, bool* refused, Fault* fault) {
    *trial = (Trial){0};
    *refused = false;
    World calm = {0};
    if (!open_world(&calm, scene, set, set_count, method_newton.name, fault))
        return false;
    Body* body = &calm.balloon[0].body;
    *refused = method->refuses && method->refuses(body);
    const bool good = !*refused && relax(&calm, fault) &&
                      open_world(&trial->world, scene, set, set_count, method->name, fault);
    if (good) {
        trial->rest = new_array(real4, body->count);
        memcpy(trial->rest, body->x, (size_t)body->count * sizeof *body->x);
        trial->potential = potential(body);
        trial->w2 = fastest(body);
        trial->gamma = damping_rate(body);
    }
    world_close(&calm);
    return good;
}

static void start(Trial* trial, double h) {
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

/// A straight line through points (n, ln e) that come one by one.
typedef struct Fit {
    double count, n, n2, y, y2, ny;
} Fit;

static void fit_add(Fit* fit, double n, double y) {
    fit->count++;
    fit->n += n;
    fit->n2 += n * n;
    fit->y += y;
    fit->y2 += y * y;
    fit->ny += n * y;
}

/// Slope of the line, and the part of the points' variance that it explains.
static double fit_slope(const Fit* fit, double* explained) {
    const double nn = fit->count * fit->n2 - fit->n * fit->n,
                 yy = fit->count * fit->y2 - fit->y * fit->y,
                 ny = fit->count * fit->ny - fit->n * fit->y;
    *explained = ny * ny / (nn * yy);
    return ny / nn;
}

/// Follow the energy to `most` times what it was at first.
static Verdict follow(Trial* trial, double h, int steps, double most, double* growth) {
    start(trial, h);
    World* world = &trial->world;
    const Body* body = &world->balloon[0].body;
    const double first = kinetic(body) + potential(body) - trial->potential;
    Fit later = {0};
    for (int n = 1; n <= steps; n++) {
        world_step(world);
        if (n % SAMPLE_EVERY && !world->blowup.halted)
            continue;
        const double now = kinetic(body) + potential(body) - trial->potential;
        const bool grown = world->blowup.halted || !(now < most * first);
        if (grown || now < spent * first) {
            *growth = log(fabs(now / first)) / (n * h);
            return grown ? VERDICT_EXPLODED : VERDICT_STABLE;
        }
        if (n > steps / 2)
            fit_add(&later, n, log(now / first));
    }
    double explained;
    const double slope = fit_slope(&later, &explained);
    *growth = slope / h;
    const bool grows = slope * (steps / 2) > told && explained > line;
    return grows ? VERDICT_WOBBLING : VERDICT_STABLE;
}

Verdict trial_run(Trial* trial, double h, double* growth) {
    return follow(trial, h, TRIAL_STEPS, explosion, growth);
}

static bool is_stable(Trial* trial, double h) {
    double growth;
    const int steps = trial->gamma > 0 ? DAMPED_STEPS : UNDAMPED_STEPS;
    return follow(trial, h, steps, beyond, &growth) == VERDICT_STABLE;
}

double trial_limit(Trial* trial) {
    const double scale = 2 / sqrt(trial->w2), least = scale / 100, most = scale * 100;
    if (!is_stable(trial, least))
        return 0;
    double stable = least, wild = least;
    do {
        stable = wild;
        wild = 4 * stable;
        if (wild > most)
            return INFINITY;
    } while (is_stable(trial, wild));
    while (wild - stable > trial_precision * stable) {
        const double middle = (stable + wild) / 2;
        *(is_stable(trial, middle) ? &stable : &wild) = middle;
    }
    return stable;
}

double trial_theory(const Trial* trial) {
    return trial->world.method->limit(trial->w2, trial->gamma);
}

double trial_bound(Trial* trial) {
    start(trial, trial->world.step);
    return method_bound(trial->world.method, &trial->world.balloon[0].body);
}

void trial_close(Trial* trial) {
    world_close(&trial->world);
    free(trial->rest);
    *trial = (Trial){0};
}
