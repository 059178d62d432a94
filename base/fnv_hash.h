/* fnv_hash.h - computes 64-bit FNV-1a hashes. A hash starts with HASH_START, and each
 * call continues it. Source: Fowler, Noll and Vo; draft-eastlake-fnv.
 */
#ifndef BASE_FNV_HASH_H
#define BASE_FNV_HASH_H

#include <stddef.h>
#include <stdint.h>

#define HASH_START UINT64_C(0xCBF29CE484222325)

uint64_t hash_bytes(uint64_t sum, const unsigned char *bytes, size_t count);
/* Continue a hash with the bytes of words, the highest byte of each word first. */
uint64_t hash_words(uint64_t sum, const uint64_t *words, size_t count);
uint64_t hash_sizes(uint64_t sum, const size_t *sizes, size_t count);

#endif
