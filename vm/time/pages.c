/* pages.c - address translation: associative registers and real memory. */
#include "vm/time/pages.h"

#include "vm/memory.h"
#include "vm/number/host.h"

#include <stdlib.h>
#include <string.h>

enum { HEAD = 0, NAMED_MOST = 256, SPAN = 256 };
#define NO_PAGE UINT64_MAX

/* The least n for which 2^n is not less. */
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

/* ---- The hash ------------------------------------------------------------ */

/* Neighbours lie far apart, and so do the pages of any stride. */
static uint32_t *hashed(const struct pages *pages, uint64_t page)
{
    uint64_t hash = page * UINT64_C(0x9E3779B97F4A7C15);
    return &pages->hashed[hash >> (64 - pages->hash_bits)];
}

/* HEAD: it is not in real memory. */
static uint32_t find(const struct pages *pages, uint64_t page)
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

/* The page in front is in the registers from now on; when they are full, that
 * at the edge drops out. */
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

/* Where a page that is brought in goes: the oldest leaves full memory. */
static uint32_t make_room(struct pages *pages)
{
    if (pages->count < pages->capacity)
        return (uint32_t)++pages->count;
    uint32_t oldest = pages->resident[HEAD].newer;
    take_out(pages, oldest);
    strike_out(pages, oldest);
    pages->known -= pages->resident[oldest].known;
    return oldest;
}

/* ---- Looking up ---------------------------------------------------------- */

void pages_look_up(struct pages *pages, uint64_t page,
                   struct translation *met)
{
    uint32_t at = find(pages, page);
    bool known = at && pages->resident[at].known;
    if (at) {
        take_out(pages, at);
    } else {
        met->faults++;
        at = make_room(pages);
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
    uint32_t at = find(pages, page);
    return at && pages->resident[at].known;
}

/* Most references are to the page of the one before. */
static inline void touch(struct pages *pages, uint64_t address,
                         struct translation *met)
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

/* Pages of a list, which lie no farther apart than NAMED_MOST. */
struct page_list {
    unsigned shift,
        places; /* of a page; of a step, which is a power of two */
    uint64_t table;
    uint64_t low, high; /* the lowest page and the highest */
};

static inline uint64_t page_of(const struct page_list *list, c205_word index)
{
    return ((list->table + (index << list->places)) & ADDRESS_MASK)
           >> list->shift;
}

#define FIND_RANGE_PARAMETERS \
    (struct page_list * list, const c205_word *indices, size_t n)
LANEWISE void find_range_span FIND_RANGE_PARAMETERS
{
    int64_t low = INT64_MAX, high = 0; /* hosts compare numbers with a sign */
    for (size_t i = 0; i < n; i++) {
        int64_t page = (int64_t)page_of(list, indices[i]);
        low = page < low ? page : low;
        high = page > high ? page : high;
    }
    list->low = (uint64_t)low;
    list->high = (uint64_t)high;
}

/* Where each stands among them. */
#define FIND_PLACES_PARAMETERS \
    (uint8_t *restrict place, const struct page_list *list, \
     const c205_word *restrict indices, size_t n)
LANEWISE void find_places_span FIND_PLACES_PARAMETERS
{
    struct page_list of = *list;
    for (size_t i = 0; i < n; i++)
        place[i] = (uint8_t)(page_of(&of, indices[i]) - of.low);
}

static void find_range FIND_RANGE_PARAMETERS;
static void find_places FIND_PLACES_PARAMETERS;
VERSIONS(find_range, find_range_span, FIND_RANGE_PARAMETERS,
         (list, indices, n))
VERSIONS(find_places, find_places_span, FIND_PLACES_PARAMETERS,
         (place, list, indices, n))

/* How many of the list it takes to name each page for the last time; 0: it does
 * not. */
static void find_last(const struct page_list *list, const c205_word *indices,
                      size_t count, uint32_t *last)
{
    uint8_t place[SPAN];
    for (size_t first = 0, n; first < count; first += n) {
        n = count - first < SPAN ? count - first : SPAN;
        find_places(place, list, indices + first, n);
        for (size_t i = 0; i < n; i++)
            last[place[i]] = (uint32_t)(first + i + 1);
    }
}

/* The pages that are named, in the order of `last`; there are not many. */
struct named {
    size_t count;
    uint64_t page[NAMED_MOST];
};

static void add_named(struct named *named, const struct page_list *list,
                      const uint32_t *last, uint64_t page)
{
    size_t at = named->count++;
    for (; at > 0
           && last[named->page[at - 1] - list->low] > last[page - list->low];
         at--)
        named->page[at] = named->page[at - 1];
    named->page[at] = page;
}

/* False: some are not in the registers, or they are too far apart. */
static bool find_named(const struct pages *pages, struct page_list *list,
                       const c205_word *indices, size_t count,
                       struct named *named)
{
    uint32_t last[NAMED_MOST] = { 0 };
    named->count = 0;
    find_range(list, indices, count);
    if (count == 0 || list->high - list->low >= NAMED_MOST)
        return false;
    if (list->low < list->high)
        find_last(list, indices, count, last);
    else
        last[0] = 1;
    for (uint64_t page = list->low; page <= list->high; page++) {
        if (last[page - list->low] == 0)
            continue;
        if (!pages_know(pages, page))
            return false;
        add_named(named, list, last, page);
    }
    return true;
}

/* Where the registers know all of them nobody drops out, and in the end they
 * stand as they were named last. */
void pages_touch_indexed(struct pages *pages, uint64_t table, unsigned step,
                         const c205_word *indices, size_t count,
                         struct translation *met)
{
    struct page_list list = { pages->shift, power_of_two(step), table, 0, 0 };
    struct named named;
    if (find_named(pages, &list, indices, count, &named))
        for (size_t i = 0; i < named.count; i++)
            touch(pages, named.page[i] << pages->shift, met);
    else
        for (size_t i = 0; i < count; i++)
            touch(pages, table + indices[i] * step, met);
}
