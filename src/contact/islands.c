#include "contact/islands.h"

#include <stdlib.h>

#include "base/memory.h"
#include "mesh/counting_sort.h"
#include "mesh/mesh.h"

static void reserve(Islands* islands, int count, int side_count) {
    if (count > islands->contact_capacity || side_count > islands->side_capacity) {
        islands_close(islands);
        islands->contact_capacity = 2 * count;
        islands->side_capacity = 2 * side_count;
        islands->start = new_array(int, 2 * count + 1);
        islands->contact = new_array(Contact*, 2 * count);
        islands->key = new_array(int, 2 * count);
        islands->order = new_array(int, 2 * count);
        islands->parent = new_array(int, 2 * side_count);
        islands->island = new_array(int, 2 * side_count);
    }
    for (int i = 0; i < side_count; i++) {
        islands->parent[i] = i;
        islands->island[i] = NONE;
    }
}

int islands_root(int* parent, int element) {
    while (parent[element] != element)
        element = parent[element] = parent[parent[element]];
    return element;
}

void islands_find(Islands* islands, Contact* contact, int count, int side_count) {
    islands_find_joined(islands, contact, count, side_count, NULL, 0);
}

void islands_find_joined(Islands* islands, Contact* contact, int count, int side_count,
                         const int* joined, int joined_count) {
    reserve(islands, count + joined_count, side_count);
    int* parent = islands->parent;
    const int first = side_count - joined_count;
    for (int k = 0; k < joined_count; k++)
        parent[first + k] = first + joined[k];
    for (int k = 0; k < count; k++)
        if (contact[k].side[1] != NONE && contact[k].side[1] < side_count)
            parent[islands_root(parent, contact[k].side[1])] =
                islands_root(parent, contact[k].side[0]);

    islands->count = 0;
    for (int k = 0; k < count; k++) {
        int* number = &islands->island[islands_root(parent, contact[k].side[0])];
        if (*number == NONE)
            *number = islands->count++;
        islands->key[k] = *number;
    }
    for (int k = 0; k < joined_count; k++) {
        int* number = &islands->island[islands_root(parent, first + joined[k])];
        if (joined[k] != k && *number == NONE)
            *number = islands->count++;
    }
    counting_sort(islands->key, count, islands->count, islands->start, islands->order);
    for (int k = 0; k < count; k++)
        islands->contact[k] = &contact[islands->order[k]];
}

int islands_of_side(const Islands* islands, int side) {
    while (islands->parent[side] != side)
        side = islands->parent[side];
    return islands->island[side];
}

void islands_close(Islands* islands) {
    free(islands->start);
    free(islands->contact);
    free(islands->key);
    free(islands->order);
    free(islands->parent);
    free(islands->island);
    *islands = (Islands){0};
}
