/* pages.c - keeps the list of pages in the associative registers and in real memory,
 * and counts translation misses and page faults.
 */
#include "vm/time/pages.h"

#include "vm/memory.h"

#include <stdlib.h>
#include <string.h>

enum { HEAD = 0 };
#define NO_PAGE UINT64_MAX

/* Returns the smallest n with 2^n >= number. */
static unsigned power_of_two(uint64_t number)
{
    unsigned power = 0;
    while (UINT64_C(1) << power < number)
        power++;
    return power;
}

bool pages_init(struct pages *pages, uint64_t page_words, uint64_t real_words,
                size_t registers)
{
    uint64_t capacity = real_words / page_words;
    pages->shift = power_of_two(page_words * WORD_BITS);
    pages->registers = registers;
    pages->named.number = 0;
    pages->capacity = capacity > 0 ? (size_t)capacity : 1;
    pages->hash_bits = 1 + power_of_two(pages->capacity);
    pages->resident = calloc(pages->capacity + 1, sizeof *pages->resident);
    pages->hashed = malloc(sizeof *pages->hashed << pages->hash_bits);
    if (!pages->resident || !pages->hashed)
        return false;
    pages_forget(pages);
    return true;
}

void pages_free(struct pages *pages)
{
    free(pages->resident);
    free(pages->hashed);
}

void pages_forget(struct pages *pages)
{
    struct resident head = { NO_PAGE, HEAD, HEAD, 0, false };
    memset(pages->hashed, 0, sizeof *pages->hashed << pages->hash_bits);
    pages->resident[HEAD] = head;
    pages->count = pages->known = 0;
    pages->edge = HEAD;
    pages->latest = NO_PAGE;
}

/* ---- The hash table ----------------------------------------------------- */

/* Returns the head of the list of pages that have the same hash as a page. The hash
 * spreads neighbouring pages and the pages of any stride. */
static uint32_t *hashed(const struct pages *pages, uint64_t page)
{
    uint64_t hash = page * UINT64_C(0x9E3779B97F4A7C15);
    return &pages->hashed[hash >> (64 - pages->hash_bits)];
}

/* Returns the index of a page, or HEAD if it is not in real memory. */
static uint32_t find_page(const struct pages *pages, uint64_t page)
{
    uint32_t at = *hashed(pages, page);
    while (at && pages->resident[at].page != page)
        at = pages->resident[at].chained;
    return at;
}

static void enter(struct pages *pages, uint32_t at, uint64_t page)
{
    uint32_t *first = hashed(pages, page);
    pages->resident[at].page = page;
    pages->resident[at].chained = *first;
    *first = at;
}

static void strike_out(struct pages *pages, uint32_t at)
{
    uint32_t *link = hashed(pages, pages->resident[at].page);
    while (*link != at)
        link = &pages->resident[*link].chained;
    *link = pages->resident[at].chained;
}

/* ---- The list ------------------------------------------------------------ */

static void take_out(struct pages *pages, uint32_t at)
{
    struct resident *resident = pages->resident, *page = &resident[at];
    if (pages->edge == at)
        pages->edge = page->newer;
    resident[page->newer].older = page->older;
    resident[page->older].newer = page->newer;
}

static void put_in_front(struct pages *pages, uint32_t at)
{
    struct resident *resident = pages->resident;
    uint32_t second = resident[HEAD].older;
    resident[at].newer = HEAD;
    resident[at].older = second;
    resident[second].newer = resident[HEAD].older = at;
}

/* Enters the latest page into the associative registers. If they are full, the page at
 * the edge, their least recently used page, leaves them. */
static void learn(struct pages *pages, uint32_t at)
{
    if (pages->registers == 0)
        return;
    pages->resident[at].known = true;
    if (pages->known == pages->registers) {
        pages->resident[pages->edge].known = false;
        pages->edge = pages->resident[pages->edge].newer;
        return;
    }
    pages->known++;
    if (pages->edge == HEAD)
        pages->edge = at;
}

/* Returns a free index for a new page. If real memory is full, the oldest page leaves
 * it. */
static uint32_t free_page(struct pages *pages)
{
    if (pages->count < pages->capacity)
        return (uint32_t)++pages->count;
    uint32_t oldest = pages->resident[HEAD].newer;
    take_out(pages, oldest);
    strike_out(pages, oldest);
    pages->known -= pages->resident[oldest].known;
    return oldest;
}

/* ---- Look-up ------------------------------------------------------------ */

void pages_look_up(struct pages *pages, uint64_t page, struct translation *met)
{
    uint32_t at = find_page(pages, page);
    bool known = at && pages->resident[at].known;
    if (at) {
        take_out(pages, at);
    } else {
        met->faults++;
        at = free_page(pages);
        enter(pages, at, page);
    }
    put_in_front(pages, at);
    if (!known) {
        met->misses++;
        pages->resident[at].known = false;
        learn(pages, at);
    } else if (pages->edge == HEAD) {
        pages->edge = at;
    }
    pages->latest = pages->registers > 0 ? page : NO_PAGE;
}

bool pages_know(const struct pages *pages, uint64_t page)
{
    uint32_t at = find_page(pages, page);
    return at && pages->resident[at].known;
}

/* Looks up a page. Most references are to the same page as the previous reference. */
static inline void touch(struct pages *pages, uint64_t address, struct translation *met)
{
    uint64_t page = (address & ADDRESS_MASK) >> pages->shift;
    if (page != pages->latest)
        pages_look_up(pages, page, met);
}

void pages_touch_all(struct pages *pages, uint64_t address, uint64_t bits,
                     struct translation *met)
{
    if (bits == 0)
        return;
    uint64_t last = (address + bits - 1) >> pages->shift;
    for (uint64_t page = address >> pages->shift; page <= last; page++)
        touch(pages, page << pages->shift, met);
}

/* ---- Lists of indices ----------------------------------------------------- */

static bool all_known(const struct pages *pages, const struct named_pages *named)
{
    for (size_t i = 0; i < named->count; i++)
        if (!pages_know(pages, named->page[i]))
            return false;
    return true;
}

/* Looks up the pages that a list of indices accesses. If the associative registers hold
 * all of them, no page drops out. The final order then depends only on the last
 * reference to each page, so one look-up per page suffices. */
void pages_touch_indexed(struct pages *pages, uint64_t table, unsigned step,
                         const struct index_list *list, struct translation *met)
{
    struct named_pages *named = &pages->named;
    if (named_pages_find(named, list, table, power_of_two(step), pages->shift)
        && all_known(pages, named))
        for (size_t i = 0; i < named->count; i++)
            touch(pages, named->page[i] << pages->shift, met);
    else
        for (size_t i = 0; i < list->count; i++)
            touch(pages, table + list->indices[i] * step, met);
}
