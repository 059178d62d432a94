/* hash.h - hash functions of texts and lists of words.
 *
 * For a given word, hash_word is a bijection of the hash. For a given hash, it is a
 * bijection of the word. Two lists that differ in one word therefore never have the
 * same hash.
 */
#ifndef C205_HASH_H
#define C205_HASH_H

#include <stdint.h>

#define HASH_BEGIN UINT64_C(0xCBF29CE484222325)

static inline uint64_t hash_word(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * UINT64_C(0x9E3779B97F4A7C15);
    return hash ^ hash >> 32;
}

static inline uint64_t hash_text(uint64_t hash, const char *text)
{
    for (; *text; text++)
        hash = hash_word(hash, (unsigned char)*text);
    return hash_word(hash, 0);
}

#endif
