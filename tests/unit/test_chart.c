/// The plan of the charts, without running it.
#include "law.h"
#include "lab/chart/chart.h"

static ChartPlan plan_of(ChartExtent extent) {
    ChartPlan plan;
    Fault fault = {0};
    if (!chart_plan(&plan,
                    &(ChartOptions){
                        .out = "none", .extent = extent, .program = {"balloon", "balloon-double"}},
                    &fault)) {
        fault_print(&fault, stderr);
        fail();
    }
    return plan;
}

/// Each point has a run; measures of the same scene share it.
static void a_full_chart_has_at_most_420_points(void** state) {
    (void)state;
    int points[3];
    for (int extent = CHART_QUICK; extent <= CHART_ALL; extent++) {
        ChartPlan plan = plan_of((ChartExtent)extent);
        points[extent] = plan.launches;
        chart_plan_free(&plan);
    }
    assert_in_range(points[CHART_FULL], points[CHART_QUICK] + 1, 420);
    assert_less(points[CHART_FULL], points[CHART_ALL]);
}

/// Every case has a line for Bullet, or a reason why not.
static void every_scene_has_its_peer(void** state) {
    (void)state;
    ChartPlan plan = plan_of(CHART_FULL);
    for (int from = 0; from < plan.points; from = chart_end(&plan, from)) {
        bool peer = plan.point[from].chart->peer.none != NULL;
        for (int p = from; p < chart_end(&plan, from); p++)
            peer |= chart_is_peer(&plan.point[p]);
        if (!peer)
            fail_msg("%s has none", plan.point[from].name);
    }
    chart_plan_free(&plan);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_full_chart_has_at_most_420_points),
        cmocka_unit_test(every_scene_has_its_peer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
