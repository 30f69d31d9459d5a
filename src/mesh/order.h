/// Numbers points so that neighbours in space are neighbours in memory: the kernels that walk
/// springs and faces then find their particles in cache. The outside keeps the loaded order.
#ifndef BALLOON_MESH_ORDER_H
#define BALLOON_MESH_ORDER_H

/// Breadth-first from a point of least valence, component by component (Cuthill–McKee). Around each
/// point from where it was met: then a front runs one way, and what lies beside a run of points is
/// often a run as well.
/// neighbour_from: [count + 1], neighbour: the CSR adjacency in loaded order, each point's in the
/// order in which they lie around it.
/// Fills loaded: [count], the loaded number of each new number.
void order_points(int count, const int* neighbour_from, const int* neighbour, int* loaded);

#endif
