/* checksum.h - 64-bit FNV-1a, begun with CHECKSUM_BEGIN and gone on with.
 * Source: Fowler, Noll and Vo; draft-eastlake-fnv.
 */
#ifndef RT_CHECKSUM_H
#define RT_CHECKSUM_H

#include <stddef.h>
#include <stdint.h>

#define CHECKSUM_BEGIN UINT64_C(0xCBF29CE484222325)

uint64_t checksum_bytes(uint64_t sum, const unsigned char *bytes,
                        size_t count);
/* Of each word the highest byte first. */
uint64_t checksum_words(uint64_t sum, const uint64_t *words, size_t count);

#endif
