/// FNV-1a, 64 bits: one number that says whether two states are the same to the last bit.
/// Source: G. Fowler, L. C. Noll, K.-P. Vo, http://www.isthe.com/chongo/tech/comp/fnv/
#ifndef BALLOON_BASE_HASH_H
#define BALLOON_BASE_HASH_H

#include <stddef.h>
#include <stdint.h>

#define HASH_START UINT64_C(14695981039346656037)
#define HASH_PRIME UINT64_C(1099511628211)

static inline uint64_t hash_bytes(uint64_t hash, const void* data, size_t size) {
    const unsigned char* byte = data;
    for (size_t i = 0; i < size; i++)
        hash = (hash ^ byte[i]) * HASH_PRIME;
    return hash;
}

#endif
