/* storage_map.c - finds the data that each label of a program names. */
#include "asm/check/storage_map.h"

#include <stdlib.h>
#include <string.h>

struct storage_span {
    uint64_t begin, end;
    const char *name;
};

/* The storage of the labels. If several labels have the same address, the last of them
 * by name owns the storage. */
struct storage_map {
    size_t count;
    struct storage_span spans[];
};

static int compare(const void *a, const void *b)
{
    const struct storage_span *first = a, *second = b;
    if (first->begin != second->begin)
        return first->begin < second->begin ? -1 : 1;
    return strcmp(first->name, second->name);
}

static bool segment_contains(const c205_segment *segment, uint64_t address)
{
    return address >= segment->address
           && address - segment->address < 64 * (uint64_t)segment->length;
}

/* Returns the end of the contiguous data at an address. The data may have several
 * segments. Returns 0 if there is no data or if it is code. */
static uint64_t end_of_data(const c205_program *program, uint64_t address)
{
    uint64_t end = 0;
    for (size_t i = 0; i < program->segment_count; i++) {
        const c205_segment *segment = &program->segments[i];
        if (!segment_contains(segment, end ? end : address))
            continue;
        if (segment_contains(segment, program->entry))
            return 0;
        end = segment->address + 64 * (uint64_t)segment->length;
    }
    return end;
}

struct storage_map *storage_map_new(const struct object *object)
{
    struct storage_map *map = malloc(sizeof *map
                                     + (object->symbol_count + 1) * sizeof *map->spans);
    if (!map)
        return NULL;
    map->count = 0;
    for (size_t i = 0; i < object->symbol_count; i++) {
        const struct asm_symbol *symbol = &object->symbols[i];
        struct storage_span *span = &map->spans[map->count];
        span->begin = (uint64_t)symbol->value;
        span->name = symbol->name;
        map->count += symbol->is_label;
    }
    qsort(map->spans, map->count, sizeof *map->spans, compare);
    for (size_t i = 0; i < map->count; i++) {
        struct storage_span *span = &map->spans[i];
        uint64_t end = end_of_data(&object->program, span->begin);
        span->end = i + 1 < map->count && span[1].begin < end ? span[1].begin : end;
    }
    return map;
}

void storage_map_free(struct storage_map *map)
{
    free(map);
}

const char *storage_at(const struct storage_map *map, uint64_t address, uint64_t *end)
{
    size_t low = 0, high = map->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (map->spans[middle].begin <= address)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == 0 || address >= map->spans[low - 1].end)
        return NULL;
    *end = map->spans[low - 1].end;
    return map->spans[low - 1].name;
}
