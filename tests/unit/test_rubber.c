/// Balloons of rubber: runs known to ten digits, closed forms of a sphere, invariants.
/// The values come from programs and formulas that share no code with this one.
#include "bodies.h"
#include "force/tangent.h"
#include "force/inflation.h"
#include "lab/truth/truth.h"
#include "mesh/measure.h"
#include "standard.h"
#include "worlds.h"

/// nRT = p_atm V0 (1 + 0.05 min(k, 10)) at step k = 1 … 20 of 1 ms, fully converged backward Euler.
static void known_runs_are_met(void** state) {
    (void)state;
    static const struct {
        const char *material, *rest;
        double volume, pressure, radius, square;
    } run[] = {
        {"neo-hookean", "volume=local", 1.4857260267, 973.470423, 0.114097472986, 2.108957165807},
        {"stvk", "poisson=0.5", 1.4768535110, 1588.050525, 0.113870386262, 2.100570392462},
        {"stvk-3d", "volume=global", 1.4699667237, 2070.197691, 0.113693733509, 2.094057736916},
    };
    for (size_t k = 0; k < sizeof run / sizeof *run; k++) {
        char material[96], rest[96];
        snprintf(material, sizeof material, "balloons.0.skin.membrane.material=%s",
                 run[k].material);
        snprintf(rest, sizeof rest, "balloons.0.skin.membrane.%s", run[k].rest);
        World world;
        WORLD_OF(&world, standard, material, rest, "solver={tolerance: 1e-12}",
                 "balloons.0.inflation.fill={to: 1.5, seconds: 0.01}");
        const double first = probe(&world, "balloon0.volume");
        run_for(&world, 0.02);
        const Body* body = &world.balloon[0].body;
        double radius = 0, square = 0;
        for (int i = 0; i < body->count; i++) {
            const double r = dlength(to_double4(body->x[i]));
            radius += r / body->count;
            square += r * r;
        }
        // float: the solver stops at 2e-6 of the forces, and the gauge pressure is their small
        // difference
        assert_close(probe(&world, "balloon0.volume") / first, run[k].volume,
                     TOLERANCE(2e-5, 1e-9));
        assert_close(probe(&world, "balloon0.gauge_pressure"), run[k].pressure,
                     TOLERANCE(3e-3, 1e-8));
        assert_close(radius, run[k].radius, TOLERANCE(2e-5, 1e-9));
        assert_close(square, run[k].square, TOLERANCE(4e-5, 1e-9));
        assert_near(probe(&world, "balloon0.rubber_volume"), 1.0, TOLERANCE(1e-6, 1e-11));
        world_close(&world);
    }
}

/// Gauge pressure at rest of a closed gas in an icosphere of this refinement.
static double settled_pressure(const char* sphere, double amount) {
    char model[64], filled[64];
    snprintf(model, sizeof model, "balloons.0.model=%s", sphere);
    snprintf(filled, sizeof filled, "balloons.0.inflation.amount=%.17g", amount);
    World world;
    WORLD_OF(&world, standard, "step=0.05", "balloons.0.damping.rate=200", model, filled);
    run_for(&world, 1);
    const double pressure = probe(&world, "balloon0.gauge_pressure");
    world_close(&world);
    return pressure;
}

static void closed_gas_has_the_pressure_of_the_closed_form(void** state) {
    (void)state;
    const TruthBalloon balloon = truth_balloon_default();
    static const double amount[] = {1.05, 1.5, 2, 3, 5};
    for (size_t k = 0; k < sizeof amount / sizeof *amount; k++) {
        const double want = truth_pressure(&balloon, truth_stretch_gas(&balloon, amount[k]));
        assert_close(settled_pressure("icosphere:4", amount[k]), want, 5e-3);
    }
}

/// The error falls by four with each refinement, and the values of independent runs are matched.
static void order_in_space_is_two(void** state) {
    (void)state;
    static const double want[] = {1490.64, 1259.16, 1204.05, 1190.36, 1186.94};
    const double truth = 1185.797827;
    for (int level = 0; level < 4; level++) {
        char model[32];
        snprintf(model, sizeof model, "icosphere:%d", level);
        assert_near(settled_pressure(model, 2), want[level], TOLERANCE(0.3, 0.01));
        if (level >= 2)
            assert_near((want[level] - truth) / (want[level + 1] - truth), 4, 0.3);
    }
}

/// w^2 of the breathing mode, from the tangent: d . K d / d . M d along the radius.
static double breathing(const Inflation* inflation, double l) {
    Mesh mesh;
    Body body;
    mesh_of("icosphere:4", &mesh);
    body_make(&body, &mesh, &(Placement){.scale = 0.1}, 1);
    rubber_on(&body, &material_neo_hookean, 3e-4, 1e6, 1000);
    body_inflate(&body, inflation);
    real4 *d = new_array(real4, body.count), *out = new_array(real4, body.count);
    for (int i = 0; i < body.count; i++) {
        d[i] = body.x[i];
        body.x[i] *= (real)l;
    }
    Tangent tangent;
    tangent_open(&tangent, &body);
    tangent_update(&tangent, &body, 1, false);
    tangent_multiply(&tangent, &body, 1, d, out);
    tangent_close(&tangent);
    double stiff = 0, inert = 0;
    for (int i = 0; i < body.count; i++) {
        stiff += (double)dot(d[i], out[i]);
        inert += (double)(body.mass[i] * dot(d[i], d[i]));
    }
    free(d);
    free(out);
    body_free(&body);
    mesh_free(&mesh);
    return sqrt(stiff / inert);
}

static void breathing_has_its_frequency(void** state) {
    (void)state;
    const InflationLaw none = INFLATE_NONE, constant = INFLATE_PRESSURE, gas = INFLATE_GAS;
    static const double ambient = 101325;
    const struct {
        InflationLaw law;
        double amount, l, want;
    } row[] = {{none, 0, 1, 632.455532},
               {constant, 1108.503372, 1.2, 299.364420},
               {gas, 1, 1, 3245.381},
               {gas, 1.5, 1.1411258752, 3437.523},
               {gas, 2, 1.2550441340, 3594.204},
               {gas, 5, 1.7036887496, 4172.153}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const Inflation inflation = {.law = row[k].law,
                                     .amount = row[k].amount,
                                     .unit = ambient,
                                     .ambient = ambient,
                                     .temperature = 1};
        assert_close(breathing(&inflation, row[k].l), row[k].want, 0.01);
    }
}

/// After 1 s at h = 0.01: -9.81 m/s, and from x^n the paper's way -0.098.
static void newton_falls_freely(void** state) {
    (void)state;
    const char* start[] = {"solver.start=inertia", "solver.start=rest"};
    const double want[] = {-9.81, -0.0981};
    for (int k = 0; k < 2; k++) {
        World world;
        WORLD_OF(&world, standard, "step=0.01", "gravity=9.81", "balloons.0.damping.rate=0",
                 "balloons.0.inflation={law: none}", "solver={tolerance: 1e-12}", start[k]);
        const double y = probe(&world, "balloon0.cy");
        run_for(&world, 1);
        const Body* body = &world.balloon[0].body;
        for (int i = 0; i < body->count; i++)
            // float: solved to the rounding of the skin's own forces
            assert_close((double)body->v[i][1], want[k], TOLERANCE(3e-4, 1e-9));
        if (k == 0) // x_n = -g h^2 n (n + 1) / 2
            assert_close(probe(&world, "balloon0.cy") - y, -9.81 * 1e-4 * 100 * 101 / 2,
                         TOLERANCE(3e-4, 1e-9));
        world_close(&world);
    }
}

/// l at 0.02 s after a sudden 800 Pa, against the same mesh at a much smaller step.
static double sudden(const char* method, double h) {
    char how[32], step[48];
    snprintf(how, sizeof how, "method=%s", method);
    snprintf(step, sizeof step, "step=%.17g", h);
    World world;
    WORLD_OF(&world, standard, how, step, "balloons.0.damping.rate=0", "guard=off",
             "balloons.0.inflation={law: pressure, amount: 800}");
    const double first = probe(&world, "balloon0.volume");
    run_for(&world, 0.02);
    const double l = cbrt(probe(&world, "balloon0.volume") / first);
    world_close(&world);
    return l;
}

static void order_in_time_is_one(void** state) {
    (void)state;
    const double converged = 2 * sudden("euler", 1.25e-5) - sudden("euler", 2.5e-5);
    const char* method[] = {"euler", "newton"};
    const double coarse[] = {2e-4, 5e-5};
    for (int m = 0; m < 2; m++) {
        const double first = sudden(method[m], coarse[m]) - converged;
        const double second = sudden(method[m], coarse[m] / 2) - converged;
        assert_near(first / second, 2, 0.2);
    }
    // the mesh's own error stays
    assert_near(converged, 1.2025606445, 0.02);
}

/// In the atmosphere, a uniform thickness does not change the shape at equal volume.
static void uniform_thickness_does_not_change_the_shape(void** state) {
    (void)state;
    double side[2][3];
    const char* thickness[] = {"balloons.0.skin.membrane.thickness=3e-4",
                               "balloons.0.skin.membrane.thickness=1e-4"};
    for (int k = 0; k < 2; k++) {
        World world;
        WORLD_OF(&world, standard, thickness[k], "balloons.0.model=torus:24x12", "step=0.02",
                 "balloons.0.damping.rate=200", "balloons.0.inflation.amount=2");
        run_for(&world, 2);
        const Body* body = &world.balloon[0].body;
        for (int c = 0; c < 3; c++) {
            double low = INFINITY, high = -INFINITY;
            for (int i = 0; i < body->count; i++) {
                low = fmin(low, (double)body->x[i][c]);
                high = fmax(high, (double)body->x[i][c]);
            }
            side[k][c] = (high - low) / cbrt(probe(&world, "balloon0.volume"));
        }
        world_close(&world);
    }
    for (int c = 0; c < 3; c++)
        assert_close(side[0][c], side[1][c], 1e-3);
}

/// Figure 7 of the thin-shell paper: without the atmosphere, the same gas swells a thinner skin
/// more.
static void thinner_skin_swells_more(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "thickness");
    const double first = probe(&world, "balloon0.volume");
    run_for(&world, 5);
    const double thick = probe(&world, "balloon0.volume") / first;
    const double middle = probe(&world, "balloon1.volume") / first;
    const double thin = probe(&world, "balloon2.volume") / first;
    assert_less(1.2, thick);
    assert_less(thick, middle);
    assert_less(middle, thin);
    world_close(&world);
}

/// A thin bottom swells into a pear.
static void a_thin_part_swells_more(void** state) {
    (void)state;
    World world;
    WORLD_OF(
        &world, standard, "step=0.02", "balloons.0.damping.rate=200",
        "balloons.0.skin.membrane.patches=[{at: [0, -0.1, 0], radius: 0.15, thickness: 1.5e-4}]",
        "balloons.0.inflation.amount=3");
    run_for(&world, 2);
    const Membrane* membrane = &world.balloon[0].body.membrane;
    const real4* x = world.balloon[0].body.x;
    double low = 0, high = 0, thick = 0, thin = 1;
    for (int e = 0; e < membrane->count; e++) {
        const double y = (double)(x[membrane->corner[e][0]][1]);
        const double l = membrane_stretch(membrane, x, e);
        if (y < 0)
            low = fmax(low, l);
        else
            high = fmax(high, l);
        thick = fmax(thick, (double)membrane->first[e]);
        thin = fmin(thin, (double)membrane->first[e]);
    }
    assert_less(1.1 * high, low);
    assert_close(thick, 3e-4, TOLERANCE(1e-5, 1e-12));
    assert_less(thin, 1.7e-4);
    world_close(&world);
}

/// If a method cannot solve a step, the last good state is restored and the sentence names the
/// step.
static void a_step_that_is_not_solved_is_named_and_survived(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, standard, "solver={iterations: 1, tolerance: 1e-5}", "step=0.05",
             "balloons.0.inflation.amount=40");
    run_for(&world, 1);
    assert_true(is_finite(&world));
    if (world.blowup.halted)
        assert_non_null(strstr(world.blowup.text, "did not solve"));
    world_close(&world);

    WORLD_OF(&world, standard, "balloons.0.inflation.amount=1e-9", "method=euler", "guard=off",
             "step=0.002");
    run_for(&world, 1);
    assert_true(world.blowup.halted);
    assert_true(is_finite(&world));
    world_close(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_runs_are_met),
        cmocka_unit_test(closed_gas_has_the_pressure_of_the_closed_form),
        cmocka_unit_test(order_in_space_is_two),
        cmocka_unit_test(breathing_has_its_frequency),
        cmocka_unit_test(newton_falls_freely),
        cmocka_unit_test(order_in_time_is_one),
        cmocka_unit_test(uniform_thickness_does_not_change_the_shape),
        cmocka_unit_test(thinner_skin_swells_more),
        cmocka_unit_test(a_thin_part_swells_more),
        cmocka_unit_test(a_step_that_is_not_solved_is_named_and_survived),
    };
    return cmocka_run_group_tests(tests, write_standard, remove_standard);
}
