/* named_pages.c - finds the pages of a list of indices with vectorised loops. */
#include "vm/time/named_pages.h"

#include "vm/memory.h"
#include "vm/number/host.h"

enum { SPAN = 256 };

/* ---- The pages of the elements ------------------------------------------ */

struct page_walk {
    unsigned shift, places; /* a page has 2^shift bits, an element 2^places bits */
    uint64_t table;
    uint64_t low, high; /* the lowest and the highest page */
    uint64_t inside;    /* the largest offset within a page */
};

static inline uint64_t address_of(const struct page_walk *of, c205_word index)
{
    return (of->table + (index << of->places)) & ADDRESS_MASK;
}

#define FIND_RANGE_PARAMETERS \
    (struct page_walk * walk, const c205_word *indices, size_t n)
LANEWISE void find_range_span FIND_RANGE_PARAMETERS
{
    struct page_walk of = *walk;
    uint64_t mask = (UINT64_C(1) << of.shift) - 1;
    int64_t low = INT64_MAX, high = 0, most = 0;
    for (size_t i = 0; i < n; i++) {
        uint64_t address = address_of(&of, indices[i]);
        int64_t page = (int64_t)(address >> of.shift);
        int64_t inside = (int64_t)(address & mask);
        low = page < low ? page : low;
        high = page > high ? page : high;
        most = inside > most ? inside : most;
    }
    walk->low = (uint64_t)low;
    walk->high = (uint64_t)high;
    walk->inside = (uint64_t)most;
}

/* Computes the page of each element, relative to the lowest page. */
#define FIND_PLACES_PARAMETERS \
    (uint8_t *restrict place, const struct page_walk *walk, \
     const c205_word *restrict indices, size_t n)
LANEWISE void find_places_span FIND_PLACES_PARAMETERS
{
    struct page_walk of = *walk;
    for (size_t i = 0; i < n; i++)
        place[i] = (uint8_t)((address_of(&of, indices[i]) >> of.shift) - of.low);
}

static void find_range FIND_RANGE_PARAMETERS;
static void find_places FIND_PLACES_PARAMETERS;
VERSIONS(find_range, find_range_span, FIND_RANGE_PARAMETERS, (walk, indices, n))
VERSIONS(find_places, find_places_span, FIND_PLACES_PARAMETERS,
         (place, walk, indices, n))

/* ---- Last references ---------------------------------------------------- */

/* Sets last[page] to 1 + the position of the last element on the page. Pages without an
 * element keep 0. */
static void find_last(const struct page_walk *walk, const struct index_list *list,
                      uint32_t *last)
{
    uint8_t place[SPAN];
    for (size_t first = 0, n; first < list->count; first += n) {
        n = list->count - first < SPAN ? list->count - first : SPAN;
        find_places(place, walk, list->indices + first, n);
        for (size_t i = 0; i < n; i++)
            last[place[i]] = (uint32_t)(first + i + 1);
    }
}

/* Inserts a page. The pages are in the order of their last references, `last`.
 * Insertion sort suffices, because the list is short. */
static void add_page(struct named_pages *named, uint64_t low, const uint32_t *last,
                     uint64_t page)
{
    size_t at = named->count++;
    for (; at > 0 && last[named->page[at - 1] - low] > last[page - low]; at--)
        named->page[at] = named->page[at - 1];
    named->page[at] = page;
}

static bool is_known(const struct named_pages *named, const struct index_list *list,
                     uint64_t table, unsigned places)
{
    return named->number == list->number && named->places == places
           && table - named->table <= named->slack;
}

bool named_pages_find(struct named_pages *named, const struct index_list *list,
                      uint64_t table, unsigned places, unsigned shift)
{
    struct page_walk walk = { .shift = shift, .places = places, .table = table };
    uint32_t last[MAX_NAMED] = { 0 };
    if (is_known(named, list, table, places))
        return true;
    named->number = 0;
    find_range(&walk, list->indices, list->count);
    if (list->count == 0 || walk.high - walk.low >= MAX_NAMED)
        return false;
    find_last(&walk, list, last);
    named->count = 0;
    for (uint64_t page = walk.low; page <= walk.high; page++)
        if (last[page - walk.low] > 0)
            add_page(named, walk.low, last, page);
    named->number = list->number;
    named->places = places;
    named->table = table;
    named->slack = (UINT64_C(1) << shift) - 1 - walk.inside;
    return true;
}
