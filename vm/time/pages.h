/* pages.h - finds the translation misses and page faults of accesses. It stores which
 * pages are in real memory and in the associative registers.
 *
 * The registers are in move-to-front order (primary source). Real memory drops its
 * least recently used page (reconstructed). Both depend on the same references, so one
 * list of pages, the latest first, represents both. The position of a page in the list
 * determines whether the registers hold it, real memory holds it, or neither does.
 *
 *      head -> latest -> .. -> edge -> .. -> oldest -> head
 *              '--- known ---'
 *
 * There may be thousands of small pages, so no operation walks the list. A hash table
 * finds a page. A flag of the page records whether it is above the edge. The edge moves
 * by one page at a time.
 */
#ifndef C205_PAGES_H
#define C205_PAGES_H

#include "vm/time/named_pages.h"

/* A page in real memory. Indices into an array identify pages. Index 0 is the head of
 * the list and not a page. */
struct resident {
    uint64_t page;         /* the address without the bits within a page */
    uint32_t newer, older; /* its neighbours in the list */
    uint32_t chained;      /* next page with the same hash; 0: none */
    bool known;            /* the associative registers hold the page */
};

struct pages {
    unsigned shift; /* bits of an address within a page */
    unsigned hash_bits;
    size_t registers;    /* number of associative registers */
    size_t capacity;     /* number of pages that fit real memory */
    size_t known, count; /* current number of pages in the registers, in real memory */
    uint32_t edge;       /* the oldest page in the registers; 0: none */
    uint64_t latest;     /* the page at the front, if the registers hold it */
    struct resident *resident;
    uint32_t *hashed;         /* first page with each hash, or 0 */
    struct named_pages named; /* pages of the latest list */
};

/* The misses and faults of some look-ups. A page fault is a miss, too, because the page
 * table in memory is searched before the fault is detected. */
struct translation {
    uint64_t misses, faults;
};

/* Initialises the pages. Page sizes must be powers of two, in words. Real memory holds
 * real_words / page_words pages, at least 1. Returns false if the host is out of
 * memory. */
bool pages_init(struct pages *pages, uint64_t page_words, uint64_t real_words,
                size_t registers);
void pages_free(struct pages *pages);
void pages_forget(struct pages *pages);

/* Looks up a page by its number and adds its miss and fault to *met. Looking up the
 * pages in memory from the oldest to the latest rebuilds the same list. */
void pages_look_up(struct pages *pages, uint64_t page, struct translation *met);
/* Returns true if the associative registers hold the page. */
bool pages_know(const struct pages *pages, uint64_t page);
/* Looks up every page of a range of bits, in order. */
void pages_touch_all(struct pages *pages, uint64_t address, uint64_t bits,
                     struct translation *met);

/* Looks up every page of a range, in order. The page of the previous reference is
 * tested first, because it is the most frequent case. */
static inline void pages_touch(struct pages *pages, uint64_t address, uint64_t bits,
                               struct translation *met)
{
    uint64_t last = (address + bits - 1) >> pages->shift;
    if (bits > 0 && (last != pages->latest || address >> pages->shift != pages->latest))
        pages_touch_all(pages, address, bits, met);
}
/* Looks up the pages of the elements at table + step x index for a list of indices. */
void pages_touch_indexed(struct pages *pages, uint64_t table, unsigned step,
                         const struct index_list *list, struct translation *met);

#endif
