/* fnv_hash.c - computes 64-bit FNV-1a hashes of bytes, words and sizes. */
#include "base/fnv_hash.h"

#define PRIME UINT64_C(0x100000001B3)

uint64_t hash_bytes(uint64_t sum, const unsigned char *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++)
        sum = (sum ^ bytes[i]) * PRIME;
    return sum;
}

uint64_t hash_words(uint64_t sum, const uint64_t *words, size_t count)
{
    for (size_t i = 0; i < count; i++)
        for (unsigned shift = 64; shift > 0; shift -= 8)
            sum = (sum ^ (words[i] >> (shift - 8) & 0xFF)) * PRIME;
    return sum;
}

uint64_t hash_sizes(uint64_t sum, const size_t *sizes, size_t count)
{
    for (size_t i = 0; i < count; i++)
        sum = hash_words(sum, (const uint64_t[]){ sizes[i] }, 1);
    return sum;
}
