/* array.c - grows arrays whose capacity follows from their count. */
#include "base/array.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

void *array_grow(void *items, size_t count, size_t item_size)
{
    if ((count & (count - 1)) != 0)
        return items;
    if (count > SIZE_MAX / 2 / item_size)
        return NULL;
    return realloc(items, (count ? 2 * count : 1) * item_size);
}

bool array_add(void *items, size_t *count, const void *item, size_t item_size)
{
    char *list;

    memcpy(&list, items, sizeof list);
    list = array_grow(list, *count, item_size);
    if (!list)
        return false;
    memcpy(items, &list, sizeof list);
    memcpy(list + (*count)++ * item_size, item, item_size);
    return true;
}
