#include <stdio.h>
#include <string.h>

#include "cli/bench_table.h"
#include "cli/open.h"
#include "cli/overwrite.h"
#include "base/interrupt.h"
#include "cli/verb.h"
#include "lab/chart/chart.h"
#include "lab/advice/needs.h"
#include "lab/peer/peer_run.h"
#include "lab/stability/stability.h"
#include "base/paths.h"

static bool read_fit(const char* text, PeerFit* fit, Fault* fault) {
    char rest;
    if (text && sscanf(text, "%lf%c", &fit->spring, &rest) == 1 && fit->spring > 0)
        return true;
    fit->spring = 0;
    const int count =
        text ? sscanf(text, "%lf,%lf,%lf%c", &fit->pressure, &fit->ratio, &fit->step, &rest) : 2;
    return ((count == 2 || count == 3) && fit->pressure >= 0 && fit->ratio >= 0 &&
            fit->step >= 0) ||
           fault_set(fault, "--fit",
                     "'%s' is not a pressure and a volume such as 800,1.33, nor a stiffness", text);
}

bool verb_peer(const Options* options, Fault* fault) {
    World world;
    PeerRun peer = {.time = options->time, .report = options->report, .quiet = options->quiet};
    if (!options->target)
        return fault_set(fault, NULL, "Bullet in which scene? See balloon --help");
    if (options->csv && strcmp(options->csv, "-") != 0)
        return fault_set(fault, "--csv", "a peer prints its numbers; write --csv -");
    interrupt_catch();
    if (!read_fit(options->fit, &peer.fit, fault) || !cli_open_world(options, &world, fault))
        return false;
    const bool good = cli_times(options, &world, &peer.seconds, &peer.fps, fault) &&
                      peer_run(&world, &peer, options->csv ? stdout : NULL, fault);
    if (good && options->hash)
        printf("%016llx\n", (unsigned long long)world_hash(&world));
    world_close(&world);
    return good;
}

bool verb_bench(const Options* options, Fault* fault) {
    const BenchCase* one = options->target ? bench_find(options->target) : NULL;
    if (options->target && !one)
        return fault_set(fault, options->target, "no such bench; see balloon list");
    const char* name = one ? one->name : "all";
    const char* folder = options->out ? options->out : "out";
    Figures figures;
    if (!figures_may_write(name, folder, fault))
        return false;
    figures_open(&figures, name);
    const BenchOptions bench = {
        .quick = options->quick, .only = options->only, .out = folder, .figures = &figures};
    bool good = true;
    for (int k = 0; k < bench_count && good; k++)
        if (one ? one == bench_table[k] : bench_table[k]->timed)
            good = bench_table[k]->run(&bench, fault);
    return figures_close(&figures, name, folder, options->keep, fault) && good;
}

/// A perturbation of 1e-6 needs a state in double precision.
bool verb_stability(const Options* options, Fault* fault) {
    if (sizeof(real) != sizeof(double))
        return cli_other_precision("balloon-double", fault);
    return stability(options->out ? options->out : "out", options->quick, fault);
}

bool verb_chart(const Options* options, Fault* fault) {
    char program[2][512];
    if (!paths_sibling("balloon", program[0], fault) ||
        !paths_sibling("balloon-double", program[1], fault))
        return false;
    const ChartOptions chart = {.out = options->out ? options->out : "out",
                                .only = options->target,
                                .extent = options->all     ? CHART_ALL
                                          : options->quick ? CHART_QUICK
                                                           : CHART_FULL,
                                .program = {program[0], program[1]}};
    return chart_run(&chart, fault);
}

/// Without a scene, list what each scene is about; with --all, measure what each scene needs.
bool verb_needs(const Options* options, Fault* fault) {
    const NeedsOptions needs = {.scene = options->target,
                                .out = options->out,
                                .set = options->set,
                                .set_count = options->set_count,
                                .quick = options->quick};
    if (options->target || options->all)
        return needs_run(&needs, fault);
    needs_list();
    return true;
}

bool verb_advise(const Options* options, Fault* fault) {
    AdviseOptions advise;
    if (!options->target)
        return fault_set(fault, NULL, "advise on which scene? See balloon --help");
    if (!options->error == !options->budget)
        return fault_set(fault, options->target,
                         "say what you ask for: --error 1%% or --budget 4ms");
    return overwrite_allows_scene(options, fault) && cli_open_advice(options, &advise, fault) &&
           advise_run(&advise, fault);
}
