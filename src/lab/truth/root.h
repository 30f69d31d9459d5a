/// A root of a function of one variable, to rounding.
#ifndef BALLOON_LAB_TRUTH_ROOT_H
#define BALLOON_LAB_TRUTH_ROOT_H

/// A function of x with its parameters `self`.
typedef double (*RootFunction)(const void* self, double x);

/// The x between low and high where f changes sign, by bisection until no double lies between the
/// two ends: about 55 evaluations, without a tolerance or an initial guess. f(low) and f(high) must
/// have different signs, or one of them is zero.
static inline double root_between(RootFunction f, const void* self, double low, double high) {
    const int falls = f(self, low) > f(self, high);
    for (;;) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high)
            return middle;
        if ((f(self, middle) > 0) == falls)
            low = middle;
        else
            high = middle;
    }
}

#endif
