/// The middle one of some values, which a few outliers do not move.
#ifndef BALLOON_BASE_MEDIAN_H
#define BALLOON_BASE_MEDIAN_H

/// value[count / 2] of the values [count >= 1] sorted in place: value[0] is then the least of them.
double median(double* value, int count);

#endif
