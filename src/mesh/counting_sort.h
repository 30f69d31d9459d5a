/// Counting sort: items grouped by an integer key, in linear time.
#ifndef BALLOON_MESH_COUNTING_SORT_H
#define BALLOON_MESH_COUNTING_SORT_H

/// Item i has the key key[i], 0 <= key < key_count, or NONE to leave it out. Fills
///
///     item[from[k]] … item[from[k + 1] - 1]   the items of key k, in ascending order
///
/// key: [count], from: [key_count + 1], item: [count].
void counting_sort(const int* key, int count, int key_count, int* from, int* item);

#endif
