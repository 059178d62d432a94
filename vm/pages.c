/* pages.c - address translation: associative registers and real memory. */
#include "pages.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

bool pages_init(struct pages *pages, size_t registers, size_t capacity)
{
    pages->registers = registers;
    pages->capacity = capacity;
    pages->count = 0;
    pages->page = malloc(capacity * sizeof *pages->page);
    return pages->page;
}

void pages_free(struct pages *pages)
{
    free(pages->page);
}

void pages_forget(struct pages *pages)
{
    pages->count = 0;
}

/* Depth of a page in the list; pages->count: it isn't there. */
static size_t depth_of(const struct pages *pages, uint32_t page)
{
    size_t depth = 0;
    while (depth < pages->count && pages->page[depth] != page)
        depth++;
    return depth;
}

/* The pages above the depth move down by one; what stood there leaves. */
static void put_in_front(struct pages *pages, size_t depth, uint32_t page)
{
    memmove(pages->page + 1, pages->page, depth * sizeof *pages->page);
    pages->page[0] = page;
}

static void look_up(struct pages *pages, uint32_t page,
                    struct translation *met)
{
    size_t depth = depth_of(pages, page);
    met->misses += depth == pages->count || depth >= pages->registers;
    if (depth == pages->count) {
        met->faults++;
        if (pages->count < pages->capacity)
            pages->count++;
        else
            depth--;
    }
    put_in_front(pages, depth, page);
}

static void touch(struct pages *pages, uint64_t address,
                  struct translation *met)
{
    uint32_t page = (uint32_t)((address & ADDRESS_MASK) >> PAGE_SHIFT);
    if (pages->registers == 0 || pages->count == 0 || pages->page[0] != page)
        look_up(pages, page, met);
}

void pages_touch(struct pages *pages, uint64_t address, uint64_t bits,
                 struct translation *met)
{
    if (bits == 0)
        return;
    uint64_t last = (address + bits - 1) >> PAGE_SHIFT;
    for (uint64_t page = address >> PAGE_SHIFT; page <= last; page++)
        touch(pages, page << PAGE_SHIFT, met);
}

void pages_touch_indexed(struct pages *pages, uint64_t table,
                         unsigned step, const c205_word *indices,
                         size_t count,
                         struct translation *met)
{
    for (size_t i = 0; i < count; i++)
        touch(pages, table + indices[i] * step, met);
}
