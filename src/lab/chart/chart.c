#include "lab/chart/chart.h"

#include <string.h>

#include "lab/run/result_file.h"

const char chart_peer_name[] = "bullet";

bool chart_is_peer(const ChartPoint* point) {
    return strcmp(point->method, chart_peer_name) == 0;
}

bool chart_same_line(const ChartPoint* a, const ChartPoint* b) {
    return strcmp(a->method, b->method) == 0 && strcmp(a->skin, b->skin) == 0 &&
           strcmp(a->law, b->law) == 0;
}

int chart_end(const ChartPlan* plan, int from) {
    int to = from;
    while (to < plan->points && strcmp(plan->point[to].name, plan->point[from].name) == 0)
        to++;
    return to;
}

bool chart_run(const ChartOptions* options, Fault* fault) {
    ChartPlan plan = {0};
    const bool good = result_folder(options->out, fault) && chart_may_write(options->out, fault) &&
                      chart_plan(&plan, options, fault) && chart_measure(&plan, fault) &&
                      chart_write(&plan, options->out, fault) &&
                      chart_draw(&plan, options->out, fault);
    chart_plan_free(&plan);
    return good;
}
