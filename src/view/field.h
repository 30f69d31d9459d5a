/// Fields: a number at each point of the skins, shown as a colour on a scale that all skins share.
/// The status box says what the scale's ends are.
#ifndef BALLOON_VIEW_FIELD_H
#define BALLOON_VIEW_FIELD_H

#include "view/mode.h"

/// Measure the mode's field on every balloon that has it, round its least and largest number to the
/// picture's range, and colour the points by their place within it. A range of 0 to 0 is left where
/// no balloon has the field.
void field_update(Picture* picture, const World* world, const Mode* mode);

/// What an element of rubber adds to the mean at its corners.
typedef struct FieldShare {
    double amount;
    double weight; ///< > 0
} FieldShare;
typedef FieldShare ElementField(const Membrane* membrane, const real4* x, int element);

/// out[i] = the sum of amounts over the sum of weights of the elements that meet at point i.
void field_of_elements(PictureSkin* skin, const Body* body, ElementField* element, float* out);

/// The nearest number of the series 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times powers of ten that is
/// not below (not above) a positive x, but for a part in ten thousand.
double field_above(double x);
double field_below(double x);

#endif
