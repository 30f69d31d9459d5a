/// The measured limit of every method: equal to the theoretical limit, and never below the bound.
#include "worlds.h"

#include "lab/stability/trial.h"

static void open_trial(Trial* trial, const Method* method, const char* const* words) {
    SceneSet set[8];
    int count = 0;
    for (; words[count + 1]; count++)
        set[count].text = words[count + 1];
    const char* refused;
    Fault fault = {0};
    if (!trial_open(trial, words[0], set, count, method, &refused, &fault)) {
        fault_print(&fault, stderr);
        fail();
    }
}
#define OPEN(trial, method, ...)                                                                   \
    open_trial((trial), (method), (const char* const[]){__VA_ARGS__, NULL})

/// truth: w^2 of 50/10/10 on the cube-sphere of 3 x 3 quads a side, and of rubber on icospheres the
/// limits of undamped semi-implicit Euler.
static void fastest_frequency_is_the_known_one(void** state) {
    (void)state;
    Trial trial;
    OPEN(&trial, &method_euler, "limit-springs");
    assert_close(trial.w2, 221899.946, TOLERANCE(1e-5, 1e-8));
    assert_close(trial.gamma, 200.0, TOLERANCE(1e-6, 1e-12));
    trial_close(&trial);

    const double limit[] = {1.40e-3, 6.93e-4, 3.41e-4};
    for (int level = 1; level <= 3; level++) {
        char model[64];
        snprintf(model, sizeof model, "balloons.0.model=icosphere:%d", level);
        OPEN(&trial, &method_euler, "limit-rubber", model);
        assert_close(method_euler.limit(trial.w2, 0), limit[level - 1], 5e-3); // its last digit
        trial_close(&trial);
    }
}

/// truth: the table of section 4, all five dampings, for every method that has a limit.
static void methods_fail_where_theory_says(void** state) {
    (void)state;
    const char* damping[] = {"0", "0.05", "0.2", "1", "2"};
    for (int m = 0; m < method_count; m++)
        for (int d = 0; d < 5; d++) {
            const Method* method = method_table[m];
            const double gamma = strtod(damping[d], NULL) / 1e-3;
            if (method->implicit)
                continue;
            char word[64];
            snprintf(word, sizeof word, "balloons.0.damping.coefficient=%s", damping[d]);
            Trial trial;
            OPEN(&trial, method, "limit-springs", word);
            assert_close(trial_limit(&trial), method->limit(221899.946, gamma), 0.02);
            trial_close(&trial);
        }
}

/// Every force and material, at rest under every inflation: a step as long as the bound holds.
static void no_step_below_the_bound_is_unstable(void** state) {
    (void)state;
    if (sizeof(real) == sizeof(float))
        skip(); // the perturbation's energy is below the rounding of a gas's energy
#define SET(key) "balloons.0." key
    static const char* const springs[] = {SET("skin.springs.law=hooke"),
                                          SET("skin.springs.law=rubber"),
                                          SET("skin.springs.torsion=0.05")};
    static const char* const rubber[] = {
        SET("skin.membrane.material=neo-hookean"), SET("skin.membrane.material=mooney-rivlin"),
        SET("skin.membrane.material=stvk"), SET("skin.membrane.material=stvk-3d")};
    static const char* const blown[] = {
        SET("inflation={law: pressure, amount: 0}"),
        SET("inflation={law: pressure, amount: 20}"), // a sixth of the maximum for these springs
        SET("inflation={law: gas, amount: 1, ambient: 1000}"),
        SET("inflation={law: gas, amount: 2, ambient: 1000}"),
        SET("inflation={law: gas, amount: 5, ambient: 1000}"),
        SET("inflation={law: pressure, amount: 900}"), // the maximum for rubber is 1239
        SET("inflation={law: gas, amount: 2}"),
        SET("inflation={law: gas, amount: 5}"),
    };
#undef SET
    for (int m = 0; m < method_count; m++)
        for (int k = 0; k < 3 * 5 + 4 * 8; k++) {
            if (method_table[m]->implicit)
                continue; // every step is stable: no bound
            const bool paper = k < 3 * 5;
            const char* skin = paper ? springs[k / 5] : rubber[(k - 15) / 8];
            const char* fill = paper ? blown[k % 5] : blown[(k - 15) % 8];
            Trial trial;
            OPEN(&trial, method_table[m], paper ? "limit-springs" : "limit-rubber", skin, fill,
                 paper ? "balloons.0.model=cube-sphere:3" : "balloons.0.model=icosphere:1");
            const double bound = trial_bound(&trial);
            // stvk-3d's thickness changes after each step: the law has no energy, and growth may be
            // marginal
            const Verdict most = strstr(skin, "stvk-3d") ? VERDICT_MARGINAL : VERDICT_STABLE;
            double growth;
            if (isfinite(bound) && bound > 0 && trial_run(&trial, bound, &growth) > most)
                fail_msg("%s, %s, %s: a step of %g s is not stable: %g/s", method_table[m]->name,
                         skin, fill, bound, growth);
            trial_close(&trial);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fastest_frequency_is_the_known_one),
        cmocka_unit_test(methods_fail_where_theory_says),
        cmocka_unit_test(no_step_below_the_bound_is_unstable),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
