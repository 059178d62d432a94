/* array.h - arrays that grow by one item at a time. */
#ifndef BASE_ARRAY_H
#define BASE_ARRAY_H

#include <stdbool.h>
#include <stddef.h>

/* Makes room for one more item in an array of count items. Returns the array, which may
 * move, or NULL if memory is out; the old array then remains valid. The capacity is the
 * count rounded up to a power of two, so it is not stored, and every item must be added
 * through this function. */
void *array_grow(void *items, size_t count, size_t item_size);
/* Appends a copy of an item, and counts it. `items` points to the pointer to the array.
 * Fails if memory is out; the array is then unchanged. */
bool array_add(void *items, size_t *count, const void *item, size_t item_size);

#endif
