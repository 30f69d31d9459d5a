/// The largest stable step of the two explicit methods, from the fastest mode and the damping.
#include "lab/truth/truth.h"

#include <math.h>

double truth_limit_euler(double w2, double gamma) {
    // the second form: no difference of near numbers under strong damping, no 0/0 of rigid motion
    return 4 / (gamma + sqrt(gamma * gamma + 4 * w2));
}

double truth_limit_forward(double w2, double gamma) {
    // |1 + h z|^2 = 1 - gamma h + w2 h^2 of a swinging mode; 1 + h z > -1 of a creeping one
    const double rest = gamma * gamma - 4 * w2;
    const double fastest = rest < 0 ? gamma / w2 : 4 / (gamma + sqrt(rest));
    return gamma > 0 ? fmin(2 / gamma, fastest) : 0;
}
