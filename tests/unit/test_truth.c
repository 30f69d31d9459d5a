/// The closed forms of the spherical balloon at rest, against values computed by separate programs
/// and against physical laws. Golden numbers have the digits to which they were derived to.
#include "truths.h"

/// Standard E, h0 and R0: mu h0/R0 [Pa].
static const double mu_share = 1e6 / 3 * 3e-4 / 0.1;

// --- laws --------------------------------------------------------------------------------------

/// Central differences: error step^2, and rounding over the step; both below 1e-8 of E.
static void stress_is_the_slope_of_energy_and_tangent_that_of_stress(void** state) {
    (void)state;
    const double d = 1e-5;
    for (int i = 0; i < truth_law_count; i++) {
        const TruthLaw* law = &truth_law_table[i];
        const TruthBalloon b = balloon_of(law->name);
        assert_near(law->energy(&b, 1), 0, 1e-9 * b.modulus);
        assert_near(law->stress(&b, 1), 0, 1e-12 * b.modulus);
        for (double l = 0.8; l < 3.2; l += 0.15) {
            const double slope = (law->energy(&b, l + d) - law->energy(&b, l - d)) / (2 * d);
            const double tangent = (law->stress(&b, l + d) - law->stress(&b, l - d)) / (2 * d);
            const double scale = 1e-8 * (b.modulus + fabs(law->tangent(&b, l)));
            assert_near(slope, law->stress(&b, l), scale);
            assert_near(tangent, law->tangent(&b, l), scale);
        }
    }
    assert_null(truth_law_find("glass"));
}

static void pressures_are_those_of_the_closed_forms(void** state) {
    (void)state;
    const double share = 3e-4 / 0.1, nu = 0.45, c = 0.1;
    const double first = 1e6 * nu / ((1 + nu) * (1 - 2 * nu)), mu = 1e6 / (2 * (1 + nu));
    for (double l = 1; l < 3; l += 0.1) {
        const double rubber = 1 / l - pow(l, -7), e = (l * l - 1) / 2, g = (pow(l, -4) - 1) / 2;
        const double s11 = 2 * mu * e + first * (2 * e + g);
        const double want[] = {
            2 * mu_share * rubber,
            4 * share * rubber * (1 + c * l * l) * 1e6 / (6 * (1 + c)),
            share * 1e6 / (1 - nu) * (l * l - 1) / l,
            2 * share * s11 / l,
            4 * share * 1e6 * (l - 1) / (l * l), // a = 2 B/R0, B = 2 E h0
            2 * mu_share * rubber,
        };
        for (int i = 0; i < truth_law_count; i++) {
            const TruthBalloon b = balloon_of(truth_law_table[i].name);
            assert_near(truth_pressure(&b, l), want[i], 1e-11 * (1 + want[i]));
        }
    }
}

static void only_rubber_and_springs_have_a_peak(void** state) {
    (void)state;
    const struct {
        const char* law;
        double l, share; // share: of mu h0/R0
    } peak[] = {
        {"neo-hookean", 1.3830875543, 1.2394629024},
        {"rubber", pow(7, 1.0 / 6), 1.2394629024},
        {"hooke", 2, 3}, // a/4, a = 4 E h0/R0 = 12 mu h0/R0
        {"stvk", 0, 0},
        {"stvk-3d", 0, 0},
    };
    for (int i = 0; i < 5; i++) {
        const TruthBalloon b = balloon_of(peak[i].law);
        double l, p;
        assert_int_equal(truth_peak(&b, &l, &p), peak[i].l > 0);
        if (peak[i].l > 0) {
            assert_near(l, peak[i].l, last(10));
            assert_near(p / mu_share, peak[i].share, last(10));
        }
    }
}

/// Where the maximum and the valley of Mooney-Rivlin meet, C2/C1 = (l^6-7)/(l^8+5 l^2) is largest:
/// l^12 - 38 l^6 - 35 = 0.
static void mooney_rivlin_loses_its_peak_at_the_critical_ratio(void** state) {
    (void)state;
    const double l6 = 19 + sqrt(19 * 19 + 35), l2 = cbrt(l6);
    const double critical = (l6 - 7) / (l2 * (l6 + 5));
    assert_near(critical, 0.21445835, last(8));
    TruthBalloon b = balloon_of("mooney-rivlin");
    double l, p;
    b.mooney = critical - 1e-8;
    assert_true(truth_peak(&b, &l, &p));
    b.mooney = critical + 1e-8;
    assert_false(truth_peak(&b, &l, &p));
    b.mooney = 0;
    assert_true(truth_peak(&b, &l, &p));
    assert_close(l, pow(7, 1.0 / 6), 1e-12);
}

static void laws_of_springs_stand_off_rubber_as_computed(void** state) {
    (void)state;
    const TruthBalloon rubber = truth_balloon_default(), hooke = truth_springs_fitted(&rubber, 1.1);
    const double l[] = {1.5, 2, 3}, off[] = {0.75, 1.43, 2.20};
    assert_close(truth_pressure(&hooke, 1.1), truth_pressure(&rubber, 1.1), 1e-14);
    for (int i = 0; i < 3; i++)
        assert_near(truth_pressure(&hooke, l[i]) / truth_pressure(&rubber, l[i]) - 1, off[i],
                    last(2));
    // the ratio of rubber's law itself, which is replaced by Hooke's in compression
    const double steep = rubber.law->tangent(&rubber, 0.8) / rubber.law->tangent(&rubber, 1);
    assert_near(steep, 3.3, last(1));
    const TruthBalloon springs = balloon_of("rubber");
    assert_close(springs.law->tangent(&springs, 0.8), springs.law->tangent(&springs, 1), 1e-15);
}

static void stvk_starts_too_soft_and_becomes_too_stiff(void** state) {
    (void)state;
    // slope h0/R0 W'' at l = 1 over mu h0/R0, mu = E/(2 (1+nu)): 4 as the paper reads it, 12 of
    // rubber
    const TruthBalloon paper = balloon_of("stvk-3d"), rubber = truth_balloon_default();
    const double mu = paper.modulus / (2 * (1 + paper.poisson));
    assert_close(paper.law->tangent(&paper, 1) / mu, 4.0, 1e-12);
    assert_close(rubber.law->tangent(&rubber, 1) / (rubber.modulus / 3), 12.0, 1e-12);
    // far too stiff later
    assert_less(10 * truth_pressure(&rubber, 2), truth_pressure(&paper, 2));
}

// --- at rest -----------------------------------------------------------------------------------

static void closed_gas_rests_where_computed(void** state) {
    (void)state;
    const struct {
        double amount, l, volume, pressure;
    } row[] = {
        {1.05, 1.0158058472, 1.04817096, 176.809903}, {1.5, 1.1411258752, 1.48593790, 958.884217},
        {2, 1.2550441340, 1.97686492, 1185.797827},   {3, 1.4364425559, 2.96390848, 1233.834808},
        {5, 1.7036887496, 4.94505090, 1125.917051},
    };
    const TruthBalloon b = truth_balloon_default();
    for (int i = 0; i < 5; i++) {
        const double l = truth_stretch_gas(&b, row[i].amount);
        assert_near(l, row[i].l, last(10));
        assert_near(l * l * l, row[i].volume, last(8));
        assert_near(truth_pressure(&b, l), row[i].pressure, last(6));
    }
    assert_near(2 / pow(truth_stretch_gas(&b, 2), 3) - 1, 0.012, last(3)); // V = N V0
    assert_near(truth_stretch_gas(&b, 1), 1, 1e-15);
}

static void constant_pressure_finds_the_stable_branch(void** state) {
    (void)state;
    const TruthBalloon b = truth_balloon_default();
    assert_near(truth_pressure(&b, 1.2), 1108.503372, last(6));
    assert_near(truth_stretch_pressure(&b, 1108.503372), 1.2, 1e-9);
    assert_near(truth_stretch_pressure(&b, 0), 1, 1e-15);
    double l, most;
    assert_true(truth_peak(&b, &l, &most));
    assert_near(most, 1239.46, last(2)); // the static limit
    assert_true(isinf(truth_stretch_pressure(&b, most + 1e-6)));
    for (int i = 0; i < truth_law_count; i++) {
        const TruthBalloon other = balloon_of(truth_law_table[i].name);
        const double stretch = truth_stretch_pressure(&other, 1000);
        assert_close(truth_pressure(&other, stretch), 1000.0, 1e-12);
        assert_less(1000, truth_pressure(&other, stretch + 1e-3));
    }
    const TruthBalloon stiff =
        balloon_of("stvk"); // far above the range in which a maximum is searched
    assert_close(truth_stretch_pressure(&stiff, truth_pressure(&stiff, 50)), 50.0, 1e-12);
}

static void breathing_has_the_computed_frequencies(void** state) {
    (void)state;
    const TruthBalloon b = truth_balloon_default();
    assert_near(truth_breath_pressure(&b, 1), 632.455532, last(6));
    assert_near(truth_breath_pressure(&b, 1.2), 299.364420, last(6));
    // the period grows without limit toward the maximum; beyond it there is no oscillation
    const double peak = pow(7, 1.0 / 6);
    assert_less(truth_breath_pressure(&b, peak - 1e-9), 0.1);
    assert_true(isnan(truth_breath_pressure(&b, peak + 1e-6)));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stress_is_the_slope_of_energy_and_tangent_that_of_stress),
        cmocka_unit_test(pressures_are_those_of_the_closed_forms),
        cmocka_unit_test(only_rubber_and_springs_have_a_peak),
        cmocka_unit_test(mooney_rivlin_loses_its_peak_at_the_critical_ratio),
        cmocka_unit_test(laws_of_springs_stand_off_rubber_as_computed),
        cmocka_unit_test(stvk_starts_too_soft_and_becomes_too_stiff),
        cmocka_unit_test(closed_gas_rests_where_computed),
        cmocka_unit_test(constant_pressure_finds_the_stable_branch),
        cmocka_unit_test(breathing_has_the_computed_frequencies),
    };
    return cmocka_run_group_tests_name("truth", tests, NULL, NULL);
}
