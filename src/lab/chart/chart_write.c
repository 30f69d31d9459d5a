#include <errno.h>
#include <math.h>
#include <string.h>

#include "lab/chart/chart.h"
#include "lab/run/machine.h"
#include "lab/run/result_file.h"
#include "mesh/mesh.h"

static const double good_enough = 0.01; ///< maximum error in the summary [1]

static const char points_head[] = "scene,method,skin,law,vertices,step,precision,ms_per_second,"
                                  "measured,truth,error,stable,hash\n";
static const char fronts_head[] = "scene,method,skin,law,ms_per_second,error\n";
static const char summary_mark[] = "Measured on ";

bool chart_may_write(const char* folder, Fault* fault) {
    return result_file_allowed(folder, "chart.csv", points_head, fault) &&
           result_file_allowed(folder, "front.csv", fronts_head, fault) &&
           result_file_allowed(folder, "chart.md", summary_mark, fault);
}

/// A point whose scene the method refuses has only its name and settings.
static void write_row(const ChartPoint* p, FILE* out) {
    fprintf(out, "%s,%s,%s,%s,%d,%.17g,%s,", p->name, p->method, p->skin, p->law, p->vertices,
            p->step, p->precision);
    if (p->launch == NONE)
        fprintf(out, "-,-,%.17g,-,-,-\n", p->truth);
    else
        fprintf(out, "%.6g,%.17g,%.17g,%.17g,%d,%s\n", p->ms, p->measured, p->truth, p->error,
                p->stable, p->hash);
}

static bool write_csv(const ChartPlan* plan, const char* folder, Fault* fault) {
    FILE* out = result_file_open(folder, "chart.csv", points_head, fault);
    if (!out)
        return false;
    fputs(points_head, out);
    for (int p = 0; p < plan->points; p++)
        write_row(&plan->point[p], out);
    return result_file_close(out, folder, "chart.csv", fault);
}

/// In order of cost, so that a line can join them.
static void write_front(const ChartPlan* plan, int from, int of_line, FILE* out) {
    const ChartPoint* first = &plan->point[from];
    double last = -1;
    for (;;) {
        const ChartPoint* next = NULL;
        for (int p = from; p < chart_end(plan, from); p++) {
            const ChartPoint* point = &plan->point[p];
            if ((of_line ? point->best_of_line && chart_same_line(point, first) : point->best) &&
                point->ms > last && (!next || point->ms < next->ms))
                next = point;
        }
        if (!next)
            return;
        last = next->ms;
        fprintf(out, "%s,%s,%s,%s,%.6g,%.17g\n", next->name, of_line ? next->method : "-",
                of_line ? next->skin : "-", of_line ? next->law : "-", next->ms, next->error);
    }
}

static bool is_first_of_line(const ChartPlan* plan, int from, int p) {
    for (int q = from; q < p; q++)
        if (chart_same_line(&plan->point[q], &plan->point[p]))
            return false;
    return true;
}

static bool write_fronts(const ChartPlan* plan, const char* folder, Fault* fault) {
    FILE* out = result_file_open(folder, "front.csv", fronts_head, fault);
    if (!out)
        return false;
    fputs(fronts_head, out);
    for (int from = 0; from < plan->points; from = chart_end(plan, from)) {
        write_front(plan, from, false, out);
        for (int p = from; p < chart_end(plan, from); p++)
            if (is_first_of_line(plan, from, p))
                write_front(plan, p, true, out);
    }
    return result_file_close(out, folder, "front.csv", fault);
}

/// The cheapest point up to an error, of the peer or of our methods; NULL: none.
static const ChartPoint* cheapest(const ChartPlan* plan, int from, bool peer, double error) {
    const ChartPoint* best = NULL;
    for (int p = from; p < chart_end(plan, from); p++) {
        const ChartPoint* point = &plan->point[p];
        if (point->launch != NONE && !point->apart && point->stable && point->error <= error &&
            chart_is_peer(point) == peer && (!best || point->ms < best->ms))
            best = point;
    }
    return best;
}

/// The smallest error of the peer or of our methods; INFINITY: none.
static double min_error(const ChartPlan* plan, int from, bool peer) {
    double smallest = INFINITY;
    for (int p = from; p < chart_end(plan, from); p++)
        if (plan->point[p].stable && !plan->point[p].apart &&
            chart_is_peer(&plan->point[p]) == peer)
            smallest = fmin(smallest, plan->point[p].error);
    return smallest;
}

static void write_error(const ChartPoint* point, FILE* out) {
    if (point->measure->unit)
        fprintf(out, "%.2g %s", point->error, point->measure->unit);
    else
        fprintf(out, "%.2g %%", 100 * point->error);
}

static void write_best(const ChartPoint* point, FILE* out) {
    if (point) {
        fprintf(out, "%s, %s, %d vertices, %g s, %s | %.3g | ", point->method, point->law,
                point->vertices, point->step, point->precision, point->ms);
        write_error(point, out);
        fprintf(out, " |");
    } else
        fprintf(out, "- | - | - |");
}

/// Rows of a list of resolutions within an extent.
static int resolutions(const ChartResolution* at, ChartExtent extent) {
    int count = 0;
    for (; at && at->model; at++)
        count += at->extent <= extent;
    return count;
}

/// The line of a peer without a stable point: the reason, and which part of the chart was tried.
static void write_fallen(const ChartPlan* plan, const ChartCase* chart, FILE* out) {
    const ChartPeer* peer = &chart->peer;
    const int total = resolutions(peer->resolution, CHART_FULL);
    const int tried = resolutions(peer->resolution, plan->extent);
    if (peer->none || total == 0)
        fprintf(out, " %s | - |\n", peer->none ? peer->none : "-");
    else if (tried == 0)
        fprintf(out, " not tried: 0 of %d resolutions | - |\n", total);
    else if (tried < total)
        fprintf(out, " fell in the %d of %d resolutions tried | - |\n", tried, total);
    else
        fprintf(out, " fell | - |\n");
}

/// The rows of the cases and measures that the planned extent leaves out.
static void write_extent(const ChartPlan* plan, FILE* out) {
    if (plan->extent != CHART_QUICK)
        return;
    int tried = 0, total = 0;
    for (int from = 0; from < plan->points; from = chart_end(plan, from)) {
        const ChartCase* chart = plan->point[from].chart;
        for (int s = 0; s <= CHART_SKINS; s++) {
            const ChartResolution* at =
                s < CHART_SKINS ? chart->skin[s].resolution : chart->peer.resolution;
            tried += resolutions(at, CHART_QUICK);
            total += resolutions(at, CHART_FULL);
        }
    }
    fprintf(
        out,
        "\nQuick: %d of the chart's %d resolutions were tried. An error is the best of those, and "
        "\"fell\" says nothing of the others.\n",
        tried, total);
}

/// For each scene the cheapest point below 1 %, or the most accurate one, and the peer's best.
static void write_table(const ChartPlan* plan, FILE* out) {
    fprintf(out,
            "| | scene | measured | cheapest below 1 %% error | ms per s | error | Bullet's best "
            "error | ms per s |\n|---|---|---|---|---|---|---|---|\n");
    for (int from = 0; from < plan->points; from = chart_end(plan, from)) {
        const ChartPoint* first = &plan->point[from];
        const ChartPoint* ours = cheapest(plan, from, false, good_enough);
        const ChartPoint* peer = cheapest(plan, from, true, min_error(plan, from, true));
        fprintf(out, "| %s | %s | %s | ", first->chart->letter, first->name, first->measure->about);
        if (!ours)
            fprintf(out, "none; nearest: ");
        write_best(ours ? ours : cheapest(plan, from, false, min_error(plan, from, false)), out);
        if (peer) {
            fprintf(out, " ");
            write_error(peer, out);
            fprintf(out, " | %.3g |\n", peer->ms);
        } else
            write_fallen(plan, first->chart, out);
    }
    write_extent(plan, out);
}

static bool write_summary(const ChartPlan* plan, const char* folder, Fault* fault) {
    FILE* out = result_file_open(folder, "chart.md", summary_mark, fault);
    if (!out)
        return false;
    fprintf(out, "%s%s: CPU time of stepping per simulated second, one thread.\n\n", summary_mark,
            machine_name());
    write_table(plan, out);
    write_table(plan, stdout);
    return result_file_close(out, folder, "chart.md", fault);
}

bool chart_write(const ChartPlan* plan, const char* folder, Fault* fault) {
    return write_csv(plan, folder, fault) && write_fronts(plan, folder, fault) &&
           write_summary(plan, folder, fault);
}
