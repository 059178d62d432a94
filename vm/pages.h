/* pages.h - which pages are in real memory and which of them the associative
 * registers know.
 *
 * The registers are kept in move-to-front order (source P), real memory loses
 * its least recently used page (R).  Both see the same references, so one list
 * of pages, the latest first, serves for both: how deep a page stands in it
 * tells whether the registers know it, real memory holds it, or neither.
 */
#ifndef C205_PAGES_H
#define C205_PAGES_H

#include "c205.h"

struct pages {
    size_t registers; /* a page less deep than this is known .. */
    size_t capacity;  /* .. and less deep than this is in real memory */
    size_t count;
    uint32_t *page;   /* page numbers, the latest first */
};

/* What looking up some pages has met with.  A page fault is a miss too: the
 * table in memory is searched before it is known that a page isn't there. */
struct translation {
    uint64_t misses, faults;
};

bool pages_init(struct pages *pages, size_t registers, size_t capacity);
void pages_free(struct pages *pages);
void pages_forget(struct pages *pages);

/* Look up every page of a range of bits, in order; add to *met. */
void pages_touch(struct pages *pages, uint64_t address, uint64_t bits,
                 struct translation *met);
/* Look up the pages of table + step x index for a list of indices. */
void pages_touch_indexed(struct pages *pages, uint64_t table,
                         unsigned step, const c205_word *indices,
                         size_t count,
                         struct translation *met);

#endif
