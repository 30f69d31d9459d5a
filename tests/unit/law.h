/// Common to all unit tests: cmocka, and comparisons that print got, want and tolerance.
#ifndef BALLOON_TESTS_LAW_H
#define BALLOON_TESTS_LAW_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/real.h"

/// |got - want| <= tolerance
static inline void near_at(double got, double want, double tolerance, const char* what,
                           const char* file, int line) {
    if (fabs(got - want) <= tolerance)
        return;
    print_error("%s: got %.17g, want %.17g, off by %.3g, tolerance %.3g\n", what, got, want,
                fabs(got - want), tolerance);
    _fail(file, line);
}

/// |got - want| <= tolerance |want|
#define assert_close(got, want, tolerance)                                                         \
    near_at((got), (want), (tolerance)*fabs(want), #got, __FILE__, __LINE__)
#define assert_near(got, want, tolerance)                                                          \
    near_at((got), (want), (tolerance), #got, __FILE__, __LINE__)

/// A tolerance for each precision: float's with the reason beside it where it is used.
#define TOLERANCE(of_float, of_double) (sizeof(real) == sizeof(double) ? (of_double) : (of_float))

/// got < than, strictly.
#define assert_less(got, than)                                                                     \
    do {                                                                                           \
        const double law_got = (got), law_than = (than);                                           \
        if (!(law_got < law_than)) {                                                               \
            print_error("%s: got %.17g, want less than %.17g\n", #got, law_got, law_than);         \
            _fail(__FILE__, __LINE__);                                                             \
        }                                                                                          \
    } while (0)

#endif
