/// Reorders points so that neighbors on the mesh are neighbors in memory: kernels over springs and
/// faces then find their particles in cache.
///
/// The order of Cuthill and McKee: breadth-first, from a point of minimum valence in each
/// component. Source: E. Cuthill, J. McKee, Reducing the bandwidth of sparse symmetric matrices,
/// ACM 1969. They visit the neighbors of a point in order of valence; here they are visited around
/// the point, beginning at the one it was reached from, so that a run of points along the front
/// often has a run of points beside it.
#ifndef BALLOON_MESH_REORDER_H
#define BALLOON_MESH_REORDER_H

/// neighbor_from: [count + 1], neighbor: the CSR adjacency in loaded order, each point's
/// neighbors sorted around it.
/// Fills loaded: [count], the loaded number of each new number.
void reorder_points(int count, const int* neighbor_from, const int* neighbor, int* loaded);

#endif
