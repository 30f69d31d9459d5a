/// The cost of contacts: a balloon of some 20,000 triangles is inflated between heavy balls, which
/// hardly move, so that each presses on the skin permanently. A ball weighs a thousand balloons;
/// for the solver any ball much heavier than the patch it touches is equally hard. In the same run,
/// Bullet's own soft body is measured between the same balls. The case without a ball measures the
/// cost of the floor.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "base/median.h"
#include "base/memory.h"
#include "lab/bench/bench.h"
#include "lab/peer/peer_world.h"

static const struct {
    const char* name;
    int spheres;
    double gap;   ///< distance of the balls from the skin at rest [radii of the balloon]
    double limit; ///< maximum cost of contacts alone, a requirement [ms a step]
} case_table[] = {
    {"no ball", 0, 3, 0.05},   {"4 far away", 4, 3, 0.05}, {"16 far away", 16, 3, 0.05},
    {"4 touching", 4, 0, 0.5}, {"16 touching", 16, 0, 2},
};

enum { CASES = sizeof case_table / sizeof *case_table, SETS = 7 };

static const double step_length = 1e-3;   ///< [s]
static const double ball_radius = 0.2;    ///< [m], the balloon's is 1
static const double balls_to_skin = 1000; ///< mass of a ball [balloon masses]
static const int peer_rounds = 1;         ///< Bullet's default and the cheapest

/// A full and a quick run.
static const struct {
    int side; ///< quads a side of the cube-sphere: 41 give 20,172 triangles
    int settle, timed, peer_settle, peer_timed; ///< steps
} size_table[] = {{41, 1500, 200, 300, 100}, {12, 1500, 20, 300, 10}};

/// One case's times [ms a step] and contacts.
typedef struct Cost {
    double step_min, step_median;
    double contacts_min, contacts_median; ///< time of contacts alone; not of the peer
    int touching;                         ///< minimum number of touching balls over the timed steps
    int contacts; ///< contacts with an impulse in the last step; peer: points that touch balls
} Cost;

static double now(void) {
    return 1e3 * clock_seconds(CLOCK_THREAD_CPUTIME_ID);
}

/// Point k of a Fibonacci lattice on the unit sphere: heights at equal distances, longitudes at
/// multiples of the golden angle.
static double4 direction(int k, int count) {
    const double height = 1 - (2 * k + 1.0) / count, angle = 2.399963229728653 * k;
    const double width = sqrt(1 - height * height);
    return (double4){width * cos(angle), height, width * sin(angle), 0};
}

static bool open_case(int c, int side, World* world, Fault* fault) {
    char model[64], step[64];
    snprintf(model, sizeof model, "cube-sphere:%d", side);
    snprintf(step, sizeof step, "step=%.17g", step_length);
    const SceneSet set[SETS] = {{step},
                                {"gravity=0"},
                                {"spheres=[]"},
                                {"balloons.0.strings=[]"},
                                {"balloons.0.helium={base: 0}"},
                                {"balloons.0.damping={rate: 10}"},
                                {"balloons.0.inflation={law: area, amount: 6}"}};
    WorldDef def;
    if (!scene_load(model, set, SETS, &def, fault) || !world_open(world, &def, fault))
        return false;
    const Body* body = &world->balloon[0].body;
    for (int k = 0; k < case_table[c].spheres; k++) {
        const double distance = 1 + ball_radius + case_table[c].gap;
        contacts_add(&world->contacts,
                     &(Sphere){.x = to_real4(distance * direction(k, case_table[c].spheres)),
                               .radius = (real)ball_radius,
                               .mass = (real)balls_to_skin * body->mass[0] * (real)body->count,
                               .friction = (real)0.3});
    }
    return true;
}

/// The parts of world_step for one balloon, so that the time of contacts can be measured
/// separately; this is why it calls the method's row and not system_kick. Returns the time of
/// contacts [ms].
static double timed_step(World* world) {
    Body* body = &world->balloon[0].body;
    double contacts = 0, h = world->step;
    memcpy(world->balloon[0].v_start, body->v, (size_t)body->count * sizeof(real4));
    world->method->kick_body(body, world->balloon[0].workspace, h, &world->balloon[0].stats);
    world->contacts.skins_kicked = true;
    while (h > 0) {
        const double start = now();
        const double pace = contacts_safe_step(&world->contacts, h);
        const double drift = contacts_velocities(&world->contacts, pace);
        contacts_drift(&world->contacts, drift);
        contacts += now() - start;

        world->method->drift(body, drift);
        h -= drift;
    }
    return contacts;
}

static int count_touching(const Contacts* contacts, int* pushing) {
    int touching = 0; // balls
    *pushing = 0;     // contacts with an impulse
    for (int s = 0; s < contacts->sphere_count; s++) {
        int pushed = 0;
        for (int k = 0; k < contacts->contact_count; k++)
            pushed += contacts->contact[k].node[0].velocity == &contacts->sphere[s].v &&
                      contacts->contact[k].normal_impulse > 0;
        touching += contacts->pair[s].touching;
        *pushing += pushed;
    }
    return touching;
}

static bool time_ours(int c, int quick, Cost* cost, Fault* fault) {
    World world;
    if (!open_case(c, size_table[quick].side, &world, fault))
        return false;
    for (int n = 0; n < size_table[quick].settle; n++)
        timed_step(&world);

    const int timed = size_table[quick].timed;
    double *step = new_array(double, timed), *contacts = new_array(double, timed);
    *cost = (Cost){.touching = case_table[c].spheres};
    for (int n = 0; n < timed; n++) {
        const double start = now();
        contacts[n] = timed_step(&world);
        step[n] = now() - start;
        const int touching = count_touching(&world.contacts, &cost->contacts);
        cost->touching = touching < cost->touching ? touching : cost->touching;
    }
    cost->step_median = median(step, timed);
    cost->contacts_median = median(contacts, timed);
    cost->contacts_min = contacts[0];
    free(step);
    free(contacts);
    world_close(&world);
    return true;
}

static bool time_peer(int c, int quick, Cost* cost, Fault* fault) {
    World world;
    if (!open_case(c, size_table[quick].side, &world, fault))
        return false;
    Peer* peer = peer_of_world(&world, peer_rounds);
    world_close(&world);
    for (int n = 0; n < size_table[quick].peer_settle; n++)
        peer_step(peer, step_length);

    const int timed = size_table[quick].peer_timed;
    double* step = new_array(double, timed);
    *cost = (Cost){.touching = case_table[c].spheres};
    for (int n = 0; n < timed; n++) {
        const double start = now();
        peer_step(peer, step_length);
        step[n] = now() - start;
        int touching = 0;
        cost->contacts = 0;
        for (int s = 0; s < case_table[c].spheres; s++) {
            const int points = peer_contacts(peer, s);
            touching += points > 0;
            cost->contacts += points;
        }
        cost->touching = touching < cost->touching ? touching : cost->touching;
    }
    cost->step_median = median(step, timed);
    cost->step_min = step[0];
    free(step);
    peer_close(peer);
    return true;
}

static bool measure(const BenchOptions* options, Fault* fault) {
    const int side = size_table[options->quick].side;
    printf("%d triangles, step %g s; CPU time in ms a step\n", 12 * side * side, step_length);
    printf("%-12s | %8s %8s %8s %17s %6s | %30s\n", "", "", "", "all of", "contacts alone", "", "");
    printf("%-12s | %8s %8s %8s %8s %8s %6s | %8s %8s %8s %8s\n", "balls", "touching", "contacts",
           "a step", "minimum", "median", "wanted", "Bullet's", "contacts", "a step", "excess");
    Cost all_ours[CASES], all_peer[CASES];
    for (int c = 0; c < CASES; c++) {
        Cost ours, peer;
        if (!time_ours(c, options->quick, &ours, fault) ||
            !time_peer(c, options->quick, &peer, fault))
            return false;
        const bool touch = case_table[c].gap <= 0;
        if (touch && (ours.touching < case_table[c].spheres || peer.touching == 0))
            return fault_set(fault, "bench contact-cost", "not all of %s did: %d, Bullet's %d",
                             case_table[c].name, ours.touching, peer.touching);
        all_ours[c] = ours;
        all_peer[c] = peer;
        printf("%-12s | %8d %8d %8.3f %8.4f %8.4f %6g | %8d %8d %8.3f %8.3f\n", case_table[c].name,
               ours.touching, ours.contacts, ours.step_median, ours.contacts_min,
               ours.contacts_median, case_table[c].limit, peer.touching, peer.contacts,
               peer.step_median, peer.step_median - all_peer[0].step_median);
        fflush(stdout);
    }
    figures_head(options->figures);
    for (int c = 0; c < CASES; c++) {
        const int n = 6 * side * side + 2;
        figures_add(options->figures, case_table[c].name, n, "contacts", "ms",
                    all_ours[c].contacts_min, all_ours[c].contacts_median, 0);
        figures_add(options->figures, case_table[c].name, n, "Bullet's step", "ms",
                    all_peer[c].step_min, all_peer[c].step_median, 0);
    }
    return true;
}

const BenchCase bench_contact_cost = {
    .name = "contact-cost",
    .about = "time of contacts in a step, beside Bullet's own soft body",
    .timed = true,
    .run = measure,
};
