/// The median: a few outliers do not change it.
#ifndef BALLOON_BASE_MEDIAN_H
#define BALLOON_BASE_MEDIAN_H

/// value[count / 2] of the values [count >= 1] sorted in place: value[0] is then the minimum.
double median(double* value, int count);

#endif
