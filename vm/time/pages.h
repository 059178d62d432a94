/* pages.h - which pages are in real memory and which of them the associative
 * registers know.
 *
 * The registers are kept in move-to-front order (source P), real memory loses
 * its least recently used page (R).  Both see the same references, so one list
 * of pages, the latest first, serves for both: how deep a page is in it
 * tells whether the registers know it, real memory holds it, or neither.
 *
 *      head -> latest -> .. -> edge -> .. -> oldest -> head
 *              '--- known ---'
 *
 * There may be thousands of small pages, so nobody walks along the list: a
 * page is found by a hash, and instead of its depth it is kept whether it
 * stands above the edge, which moves by one page at a time.
 */
#ifndef C205_PAGES_H
#define C205_PAGES_H

#include "vm/time/named_pages.h"

/* A page in real memory.  Pages are named by their places in an array; place
 * 0, the head, is none of them. */
struct resident {
    uint64_t page;         /* its number: the address without its last bits */
    uint32_t newer, older; /* its neighbours in the list */
    uint32_t chained;      /* the next with the same hash; 0: there is none */
    bool known;            /* to the registers */
};

struct pages {
    unsigned shift; /* bits of address within a page */
    unsigned hash_bits;
    size_t registers;    /* so many of the latest pages are known .. */
    size_t capacity;     /* .. and so many are in real memory */
    size_t known, count; /* how many are by now */
    uint32_t edge;       /* the oldest that is known; 0: none is */
    uint64_t latest;     /* the page that is known to be in front */
    struct resident *resident;
    uint32_t *hashed;         /* the first page of each hash, or 0 */
    struct named_pages named; /* by the latest list */
};

/* What looking up some pages has met with.  A page fault is a miss too: the
 * table in memory is searched before it is known that a page isn't there. */
struct translation {
    uint64_t misses, faults;
};

/* For pages of a power of two of words; real memory holds as many as have
 * room in it, and one at least.  False: the host has no memory left. */
bool pages_init(struct pages *pages, uint64_t page_words, uint64_t real_words,
                size_t registers);
void pages_free(struct pages *pages);
void pages_forget(struct pages *pages);

/* Look up a page by its number; add to *met.  The pages in memory, looked up
 * from the oldest to the latest, make the same list again. */
void pages_look_up(struct pages *pages, uint64_t page, struct translation *met);
/* Do the registers know it? */
bool pages_know(const struct pages *pages, uint64_t page);
/* Every page of a range of bits, in order. */
void pages_touch_all(struct pages *pages, uint64_t address, uint64_t bits,
                     struct translation *met);

/* The same; mostly there is one, that of the reference before. */
static inline void pages_touch(struct pages *pages, uint64_t address, uint64_t bits,
                               struct translation *met)
{
    uint64_t last = (address + bits - 1) >> pages->shift;
    if (bits > 0 && (last != pages->latest || address >> pages->shift != pages->latest))
        pages_touch_all(pages, address, bits, met);
}
/* The pages of table + step x index for a list of indices. */
void pages_touch_indexed(struct pages *pages, uint64_t table, unsigned step,
                         const struct index_list *list, struct translation *met);

#endif
