/// Common to the tests of closed forms.
#ifndef BALLOON_TESTS_TRUTHS_H
#define BALLOON_TESTS_TRUTHS_H

#include "lab/truth/truth.h"
#include "law.h"

/// Half a unit of the last of `digits` decimals, and rounding.
static inline double last(int digits) {
    return 0.5001 * pow(10, -digits);
}

/// The standard balloon of another law.
static inline TruthBalloon balloon_of(const char* law) {
    TruthBalloon balloon = truth_balloon_default();
    balloon.law = truth_law_find(law);
    assert_non_null(balloon.law);
    return balloon;
}

#endif
