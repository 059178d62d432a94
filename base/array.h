/* array.h - arrays that grow by one item at a time. */
#ifndef BASE_ARRAY_H
#define BASE_ARRAY_H

#include <stddef.h>

/* Makes room for one more item in an array of count items. Returns the array, which may
 * move, or NULL if memory is out; the old array then remains valid. The capacity is the
 * count rounded up to a power of two, so it is not stored, and every item must be added
 * through this function. */
void *array_grow(void *items, size_t count, size_t item_size);

#endif
