/* storage_map.h - what belongs to the names of a program's data.  Not public.
 *
 * The storage of a label goes from its address to the next label, or to the
 * end of the data that lie together.  Code has none.
 */
#ifndef ASM_STORAGE_MAP_H
#define ASM_STORAGE_MAP_H

#include "asm/assemble.h"

struct storage_map;

/* The object must outlive it.  NULL: no memory. */
struct storage_map *storage_map_new(const struct object *object);
void storage_map_free(struct storage_map *map);

/* The name of the storage that an address lies in, and where that ends; NULL:
 * the address belongs to no name. */
const char *storage_at(const struct storage_map *map, uint64_t address, uint64_t *end);

#endif
