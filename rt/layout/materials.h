/* materials.h - finds primitives with equal materials, so that they can be shaded
 * together.
 *
 * A material is a row of words. Its address is that of the first primitive that
 * has it.
 */
#ifndef RT_MATERIALS_H
#define RT_MATERIALS_H

#include "vm/c205.h"

enum { LOOK_WORDS = 62 };

struct looks;

/* Returns an empty set for up to count primitives, or NULL if out of memory. */
struct looks *looks_new(size_t count);
void looks_free(struct looks *looks);

/* Returns the address that is recorded for these words. If the words are new, it
 * records `address` and returns it. Returns 0 if out of memory. */
uint64_t looks_first(struct looks *looks, const c205_word words[LOOK_WORDS],
                     uint64_t address);

#endif
