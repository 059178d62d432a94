/* array.h - arrays that grow by one item at a time. */
#ifndef BASE_ARRAY_H
#define BASE_ARRAY_H

#include <stddef.h>

/* Room for one item more in an array of so many: the array, moved where it had
 * to grow, or NULL without memory, and then the old one is still good.  The
 * array's room is its count rounded up to a power of two, so it needs no
 * counter of its own, and every item must have come this way. */
void *array_grow(void *items, size_t count, size_t item_size);

#endif
