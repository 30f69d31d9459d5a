#include "mesh/group.h"

#include <string.h>

#include "mesh/mesh.h"

void group_by_key(const int* key, int count, int key_count, int* from, int* item) {
    // how many items each key has, one place to the right
    memset(from, 0, (size_t)(key_count + 1) * sizeof *from);
    for (int i = 0; i < count; i++)
        if (key[i] != NONE)
            from[key[i] + 1]++;

    // where each key's items begin
    for (int k = 0; k < key_count; k++)
        from[k + 1] += from[k];

    // from[k] runs ahead to the end of its items, which is where the next key's begin …
    for (int i = 0; i < count; i++)
        if (key[i] != NONE)
            item[from[key[i]]++] = i;

    // … so moving it one place to the right restores it
    memmove(from + 1, from, (size_t)key_count * sizeof *from);
    from[0] = 0;
}
