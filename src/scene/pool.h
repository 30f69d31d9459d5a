/// The memory of one scene: every array and text that its WorldDef points to, freed together.
#ifndef BALLOON_SCENE_POOL_H
#define BALLOON_SCENE_POOL_H

#include <stddef.h>

typedef struct PoolBlock PoolBlock;

typedef struct Pool {
    PoolBlock* newest; ///< each block points to the one before
} Pool;

/// Zeroed memory for `count` elements; NULL for none.
void* pool_array(Pool* pool, size_t count, size_t size);

void pool_free(Pool* pool);

#endif
