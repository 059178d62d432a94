/* object.c - looks up the lines, regions and symbols of a program. */
#include "asm/object/object.h"

#include <stdlib.h>
#include <string.h>

enum { HALF_BITS = 32 };

const struct asm_line *object_line(const struct object *object, uint64_t address)
{
    const struct asm_line *lines = object->lines;
    size_t low = 0, high = object->line_count;

    while (low < high) {
        size_t middle = low + (high - low) / 2;

        if (lines[middle].address <= address)
            low = middle + 1;
        else
            high = middle;
    }
    return low > 0
                   && address - lines[low - 1].address
                          < HALF_BITS * lines[low - 1].halves
               ? &lines[low - 1]
               : NULL;
}

const char *object_region(const struct object *object, uint64_t address)
{
    const c205_region *regions = object->program.regions;

    for (size_t i = 0; i < object->program.region_count; i++)
        if (address >= regions[i].begin && address < regions[i].end)
            return regions[i].name;
    return "";
}

struct position asm_line_position(const struct asm_line *line)
{
    const struct position position = { line->file, line->number,
                                       strspn(line->source, " \t") + 1, line->source,
                                       strlen(line->source) };

    return position;
}

static int compare_name(const void *name, const void *symbol)
{
    return strcmp(name, ((const struct asm_symbol *)symbol)->name);
}

const struct asm_symbol *object_symbol(const struct object *object, const char *name)
{
    if (object->symbol_count == 0)
        return NULL;
    return bsearch(name, object->symbols, object->symbol_count, sizeof *object->symbols,
                   compare_name);
}
