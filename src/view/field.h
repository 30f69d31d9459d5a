/// Fields: a number at each point of the skins, drawn as a color on a scale that all skins share.
/// The status box prints the ends of the scale.
#ifndef BALLOON_VIEW_FIELD_H
#define BALLOON_VIEW_FIELD_H

#include "view/mode.h"

/// Measure the mode's field on every balloon that has it, round its minimum and maximum to the
/// picture's range, and color the points by their value within that range. If no balloon has the
/// field, the range is 0 to 0.
void field_update(Picture* picture, const World* world, const Mode* mode);

/// The contribution of one element of rubber to the weighted mean at each of its corners.
typedef struct FieldShare {
    double amount;
    double weight; ///< > 0
} FieldShare;
typedef FieldShare ElementField(const Membrane* membrane, const real4* x, int element);

/// out[i] = (sum of amounts) / (sum of weights) over the elements that meet at point i.
void field_of_elements(PictureSkin* skin, const Body* body, ElementField* element, float* out);

/// The nearest number of the series 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times powers of ten that is
/// not below (not above) a positive x, with a tolerance of one part in ten thousand.
double field_above(double x);
double field_below(double x);

#endif
