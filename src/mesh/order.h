/// Numbers points so that neighbours in space are neighbours in memory: the kernels that walk
/// springs and faces then find their particles in cache. The outside keeps the loaded order.
#ifndef BALLOON_MESH_ORDER_H
#define BALLOON_MESH_ORDER_H

/// Breadth-first from a point of least valence, component by component (Cuthill–McKee).
/// neighbour_from: [count + 1], neighbour: the CSR adjacency in loaded order.
/// Fills loaded: [count], the loaded number of each new number.
void order_points(int count, const int* neighbour_from, const int* neighbour, int* loaded);

#endif
