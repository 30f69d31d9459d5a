#include "mesh/counting_sort.h"

#include <string.h>

#include "mesh/mesh.h"

void counting_sort(const int* key, int count, int key_count, int* from, int* item) {
    // from[k + 1]: the number of items of key k
    memset(from, 0, (size_t)(key_count + 1) * sizeof *from);
    for (int i = 0; i < count; i++)
        if (key[i] != NONE)
            from[key[i] + 1]++;

    // from[k]: the start of key k's items
    for (int k = 0; k < key_count; k++)
        from[k + 1] += from[k];

    // from[k] advances to the end of its items, which is the start of the next key's …
    for (int i = 0; i < count; i++)
        if (key[i] != NONE)
            item[from[key[i]]++] = i;

    // … so moving the array by one element restores it
    memmove(from + 1, from, (size_t)key_count * sizeof *from);
    from[0] = 0;
}
