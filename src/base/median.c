#include "base/median.h"

#include <stdlib.h>

static int rising(const void* a, const void* b) {
    const double x = *(const double*)a, y = *(const double*)b;
    return (x > y) - (x < y);
}

double median(double* value, int count) {
    qsort(value, (size_t)count, sizeof *value, rising);
    return value[count / 2];
}
