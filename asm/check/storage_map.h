/* storage_map.h - finds the label that storage belongs to. Not public.
 *
 * The storage of a label extends from its address to the next label, or to the end of
 * the contiguous data. Code has no storage.
 */
#ifndef ASM_STORAGE_MAP_H
#define ASM_STORAGE_MAP_H

#include "asm/object/object.h"

struct storage_map;

/* Returns a map of the storage of the labels, or NULL if memory is exhausted. The
 * object must outlive it. */
struct storage_map *storage_map_new(const struct object *object);
void storage_map_free(struct storage_map *map);

/* Returns the label whose storage contains an address, and the end of the storage.
 * Returns NULL if there is no such label. */
const char *storage_at(const struct storage_map *map, uint64_t address, uint64_t *end);

#endif
