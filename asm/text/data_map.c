/* data_map.c - finds the type and the number of data at each label. */
#include "asm/text/data_map.h"

#include <stdlib.h>

/* Returns the number of elements in a number of half words. */
static uint64_t count_of(enum asm_contents contents, uint64_t halves)
{
    switch (contents) {
    case ASM_BITS: return 32 * halves;
    case ASM_BYTES: return 4 * halves;
    case ASM_WORDS: return halves / 2;
    default: return halves;
    }
}

static int compare_addresses(const void *a, const void *b)
{
    const uint64_t *one = a, *other = b;
    return *one < *other ? -1 : *one > *other;
}

/* Returns the index of the first address >= `address`, by bisection. The addresses are
 * in ascending order. */
static size_t find_address(const uint64_t *addresses, size_t count, uint64_t address)
{
    size_t low = 0, high = count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (addresses[middle] < address)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Sets the data type and the number of elements at a label. The data of a label are the
 * adjacent items of one type from its address up to `end`. */
static void set_type(const struct assembler *assembler, struct asm_symbol *symbol,
                     size_t first, uint64_t end)
{
    uint64_t at = (uint64_t)symbol->value, halves = 0;
    for (size_t i = first; i < assembler->item_count; i++) {
        const struct layout_item *item = &assembler->items[i];
        if (item->address != at || item->address >= end
            || (halves > 0 && item->contents != symbol->contents))
            break;
        symbol->contents = item->contents;
        halves += item->halves;
        at = layout_end(item);
    }
    symbol->count = count_of(symbol->contents, halves);
}

/* Sets the types of data at all labels without a declared length. The addresses are
 * sorted once. The next label and the first item of each label are then found by
 * bisection, in n log n time for n labels. */
static void set_types(const struct assembler *assembler, struct asm_symbol *symbols,
                      size_t count, uint64_t *labels, uint64_t *items)
{
    size_t label_count = 0;
    for (size_t i = 0; i < count; i++)
        if (symbols[i].is_label)
            labels[label_count++] = (uint64_t)symbols[i].value;
    qsort(labels, label_count, sizeof *labels, compare_addresses);
    for (size_t i = 0; i < assembler->item_count; i++)
        items[i] = assembler->items[i].address;
    for (size_t i = 0; i < count; i++) {
        uint64_t address = (uint64_t)symbols[i].value;
        size_t next = find_address(labels, label_count, address + 1);
        if (symbols[i].is_label && !symbols[i].counted)
            set_type(assembler, &symbols[i],
                     find_address(items, assembler->item_count, address),
                     next < label_count ? labels[next] : UINT64_MAX);
    }
}

bool data_map_fill(const struct assembler *assembler, struct asm_symbol *symbols,
                   size_t count)
{
    uint64_t *labels = malloc((count + 1) * sizeof *labels);
    uint64_t *items = malloc((assembler->item_count + 1) * sizeof *items);
    bool good = labels && items;
    if (good)
        set_types(assembler, symbols, count, labels, items);
    free(labels);
    free(items);
    return good;
}
