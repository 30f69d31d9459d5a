#include "scene/pool.h"

#include <stdalign.h>
#include <stdlib.h>

#include "base/memory_missing.h"

struct PoolBlock {
    PoolBlock* older;
    alignas(max_align_t) unsigned char bytes[];
};

void* pool_array(Pool* pool, size_t count, size_t size) {
    if (count == 0)
        return NULL;
    PoolBlock* block = calloc(1, sizeof *block + count * size);
    if (!block)
        memory_missing("a scene");
    block->older = pool->newest;
    pool->newest = block;
    return block->bytes;
}

void pool_free(Pool* pool) {
    while (pool->newest) {
        PoolBlock* older = pool->newest->older;
        free(pool->newest);
        pool->newest = older;
    }
}
