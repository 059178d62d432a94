/* index_list.c - compares each list of indices with a copy of the previous one. */
#include "vm/time/index_list.h"

#include <stdlib.h>
#include <string.h>

static bool is_kept(const struct index_list *list, const c205_word *indices,
                    size_t count)
{
    return list->number > 0 && count == list->kept_count
           && memcmp(indices, list->kept, count * sizeof *indices) == 0;
}

static c205_word spread_of(const c205_word *indices, size_t count)
{
    c205_word spread = 0;
    for (size_t i = 0; i < count; i++)
        spread |= indices[i];
    return spread;
}

/* Copies a list. If the host has no memory for a copy, every list counts as new. */
static void store_list(struct index_list *list, const c205_word *indices, size_t count)
{
    list->kept_count = SIZE_MAX;
    if (count > list->room) {
        free(list->kept);
        list->kept = malloc(count * sizeof *indices);
        list->room = list->kept ? count : 0;
    }
    if (count == 0 || count > list->room)
        return;
    memcpy(list->kept, indices, count * sizeof *indices);
    list->kept_count = count;
}

void index_list_meet(struct index_list *list, const c205_word *indices, size_t count)
{
    list->indices = indices;
    list->count = count;
    if (is_kept(list, indices, count))
        return;
    store_list(list, indices, count);
    list->spread = spread_of(indices, count);
    list->number++;
}

void index_list_free(struct index_list *list)
{
    free(list->kept);
}
