/// Items gathered by an integer key, in linear time: the one sort of this folder.
#ifndef BALLOON_MESH_GROUP_H
#define BALLOON_MESH_GROUP_H

/// Item i has the key key[i], 0 <= key < key_count, or NONE to be left out. Fills
///
///     item[from[k]] … item[from[k + 1] - 1]   the items of key k, in ascending order
///
/// key: [count], from: [key_count + 1], item: [count].
void group_by_key(const int* key, int count, int key_count, int* from, int* item);

#endif
