/* materials.h - finds primitives with equal materials, so that the kernels shade them
 * together.
 *
 * A material is a row of words. The address of the first primitive that has the
 * material identifies it.
 */
#ifndef RT_MATERIALS_H
#define RT_MATERIALS_H

#include "vm/c205.h"

enum { MATERIAL_WORDS = 62 };

struct material_table;

/* Returns an empty set for up to count primitives, or NULL if out of memory. */
struct material_table *materials_new(size_t count);
void materials_free(struct material_table *materials);

/* Returns the address that is stored for these words. For new words it stores `address`
 * and returns it. Returns 0 if out of memory. */
uint64_t materials_first(struct material_table *materials,
                         const c205_word words[MATERIAL_WORDS], uint64_t address);

#endif
