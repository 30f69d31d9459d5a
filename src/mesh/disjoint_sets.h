/// Disjoint sets of the items 0 … count - 1. The root of a set is its smallest item.
#ifndef BALLOON_MESH_DISJOINT_SETS_H
#define BALLOON_MESH_DISJOINT_SETS_H

#include "base/memory.h"

/// Every item in a set of its own; freed with free().
static inline int* disjoint_make(int count) {
    int* parent = new_array(int, count);
    for (int i = 0; i < count; i++)
        parent[i] = i;
    return parent;
}

static inline int disjoint_root(int* parent, int i) {
    while (parent[i] != i) {
        parent[i] = parent[parent[i]]; // path halving
        i = parent[i];
    }
    return i;
}

static inline void disjoint_join(int* parent, int i, int j) {
    const int a = disjoint_root(parent, i);
    const int b = disjoint_root(parent, j);
    parent[a > b ? a : b] = a < b ? a : b;
}

#endif
