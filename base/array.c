/* array.c - adds items to arrays. The count of an array determines its capacity. */
#include "base/array.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Returns the array with room for one more item, or NULL if the host is out of memory.
 * The array may move. */
static void *grow(void *items, size_t count, size_t size)
{
    if ((count & (count - 1)) != 0)
        return items;
    if (count > SIZE_MAX / 2 / size)
        return NULL;
    return realloc(items, (count ? 2 * count : 1) * size);
}

/* Stores the array by copying the bytes of its pointer, because the type of the pointer
 * depends on the items. */
void *array_store(void *items, void *array, size_t *count, const void *item,
                  size_t size)
{
    char *added;
    if (!array)
        return NULL;
    memcpy(items, &array, sizeof array);
    added = (char *)array + (*count)++ * size;
    if (item)
        memcpy(added, item, size);
    else
        memset(added, 0, size);
    return added;
}

void *array_add(void *items, size_t *count, const void *item, size_t size)
{
    void *array;
    memcpy(&array, items, sizeof array);
    return array_store(items, grow(array, *count, size), count, item, size);
}
