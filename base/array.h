/* array.h - arrays that grow by one item at a time. */
#ifndef BASE_ARRAY_H
#define BASE_ARRAY_H

#include <stddef.h>

/* Adds a copy of an item, or zeros if item is NULL, to an array of *count items, and
 * returns its place. items: the address of the pointer to the array, which may move.
 * Returns NULL, with the array unchanged, if the host is out of memory. The capacity is
 * not stored: it is the count rounded up to a power of two. Every item must therefore
 * be added by this function. The owner frees the array. */
void *array_add(void *items, size_t *count, const void *item, size_t size);

/* Adds an item to `array`, which must have room for it, and stores the address of the
 * array in *items. Returns the address of the item, or NULL if array is NULL. */
void *array_store(void *items, void *array, size_t *count, const void *item,
                  size_t size);

#endif
