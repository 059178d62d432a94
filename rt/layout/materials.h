/* materials.h - which primitives look alike, so that they can be shaded at once.
 *
 * A look is a row of words; each goes by the address of the first primitive
 * that has it.
 */
#ifndef RT_MATERIALS_H
#define RT_MATERIALS_H

#include "vm/c205.h"

enum { LOOK_WORDS = 62 };

struct looks;

/* For so many primitives at most; NULL: no memory. */
struct looks *looks_new(size_t count);
void looks_free(struct looks *looks);

/* The address that goes with these words: this one if they are new, and 0 if
 * there is no memory for them. */
uint64_t looks_first(struct looks *looks, const c205_word words[LOOK_WORDS],
                     uint64_t address);

#endif
