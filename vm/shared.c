/* shared.c - creates, frees and maps pages that several machines share. */
#include "vm/shared.h"
#include "vm/error.h"

#include <stdlib.h>
#include <string.h>

/* Shared pages need no lock, because no machine writes to them. */
struct c205_shared {
    size_t count;
    struct page *pages;
};

c205_shared *c205_shared_new(const c205_word *words, size_t count)
{
    struct c205_shared *shared = calloc(1, sizeof *shared);
    if (!shared)
        return NULL;
    shared->count = (count + C205_PAGE_WORDS - 1) / C205_PAGE_WORDS;
    shared->pages = calloc(shared->count + 1, sizeof *shared->pages);
    if (!shared->pages) {
        free(shared);
        return NULL;
    }
    for (size_t i = 0; i < shared->count; i++) {
        size_t first = i * C205_PAGE_WORDS, n = count - first;
        n = n < C205_PAGE_WORDS ? n : C205_PAGE_WORDS;
        memcpy(shared->pages[i].word, words + first, n * sizeof *words);
        shared->pages[i].shared = true;
    }
    return shared;
}

void c205_shared_free(c205_shared *shared)
{
    if (!shared)
        return;
    free(shared->pages);
    free(shared);
}

bool shared_map(const c205_shared *shared, struct memory *memory, uint64_t address,
                c205_error *error)
{
    uint64_t pages = (ADDRESS_MASK + 1) / PAGE_BITS;
    if (address % PAGE_BITS == 0 && address <= ADDRESS_MASK
        && shared->count <= pages - address / PAGE_BITS)
        return memory_map_shared(memory, address, shared->pages, shared->count, error);
    return error_set(error,
                     "%zu page%s at %llX must begin on a page and end within the "
                     "address space",
                     shared->count, shared->count == 1 ? "" : "s",
                     (unsigned long long)address);
}
