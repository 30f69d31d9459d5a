#include "draw/depth.h"

enum { DIGIT = 8, BUCKETS = 1 << DIGIT, STEPS = 65535 };

// One stable pass of a radix sort, by the digit of the key that starts at this bit.
static void pass(const uint64_t* from, int count, int bit, uint64_t* to) {
    int start[BUCKETS + 1] = {0};
    for (int i = 0; i < count; i++)
        start[(from[i] >> bit) % BUCKETS + 1]++;
    for (int b = 0; b < BUCKETS; b++)
        start[b + 1] += start[b];
    for (int i = 0; i < count; i++)
        to[start[(from[i] >> bit) % BUCKETS]++] = from[i];
}

void depth_sort(const float* depth, int count, int* order, uint64_t* scratch) {
    if (count == 0)
        return;
    float near = depth[0], far = depth[0];
    for (int i = 1; i < count; i++) {
        near = depth[i] < near ? depth[i] : near;
        far = depth[i] > far ? depth[i] : far;
    }

    // the high word is a 16-bit key, 0 for the farthest; the low word is the index
    const float scale = far > near ? STEPS / (far - near) : 0;
    for (int i = 0; i < count; i++)
        scratch[i] = (uint64_t)(scale * (far - depth[i])) << 32 | (uint64_t)i;

    pass(scratch, count, 32, scratch + count);
    pass(scratch + count, count, 32 + DIGIT, scratch);
    for (int i = 0; i < count; i++)
        order[i] = (int)(scratch[i] & 0xffffffff);
}
