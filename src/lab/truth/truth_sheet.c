/// Springs on a grid as a membrane, and the string that holds a balloon.
#include "lab/truth/truth.h"

TruthSheet truth_sheet(double structural, double shear, double flexion) {
    // energy per cell of side a under strains xx, yy, xy: structural springs k a^2 xx^2/2, flexion
    // springs of length 2 a four times that, diagonals k a^2 ((xx + yy)/2 +- xy)^2
    const double c11 = structural + 4 * flexion + shear, c12 = shear, c66 = shear;
    return (TruthSheet){
        .c11 = c11,
        .c12 = c12,
        .biaxial = c11 + c12,
        .along = c11 - c12 * c12 / c11,
        .diagonal = 4 / (2 / (c11 + c12) + 1 / c66),
    };
}

double truth_tether(int count, double mass, double lift, double gravity) {
    return count * mass * (lift - gravity);
}
