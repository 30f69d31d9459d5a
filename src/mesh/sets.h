/// Disjoint sets of 0 … count - 1: what has been joined has one root, the smallest of its items.
#ifndef BALLOON_MESH_SETS_H
#define BALLOON_MESH_SETS_H

#include "base/memory.h"

/// Every item alone; freed with free().
static inline int* sets_make(int count) {
    int* parent = new_array(int, count);
    for (int i = 0; i < count; i++)
        parent[i] = i;
    return parent;
}

static inline int sets_root(int* parent, int i) {
    while (parent[i] != i) {
        parent[i] = parent[parent[i]]; // halve the path for whoever comes next
        i = parent[i];
    }
    return i;
}

static inline void sets_join(int* parent, int i, int j) {
    const int a = sets_root(parent, i);
    const int b = sets_root(parent, j);
    parent[a > b ? a : b] = a < b ? a : b;
}

#endif
