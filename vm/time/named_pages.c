#include "vm/time/named_pages.h"

#include "vm/memory.h"
#include "vm/number/host.h"

enum { SPAN = 256 };

/* ---- Where the elements are ----------------------------------------------- */

struct elements {
    unsigned shift,
        places; /* of a page; of a step, which is a power of two */
    uint64_t table;
    uint64_t low, high; /* the lowest page and the highest */
    uint64_t inside;    /* the farthest into its page */
};

static unsigned places_of(unsigned step)
{
    unsigned places = 0;
    while (1u << places < step)
        places++;
    return places;
}

static inline uint64_t address_of(const struct elements *of, c205_word index)
{
    return (of->table + (index << of->places)) & ADDRESS_MASK;
}

#define FIND_RANGE_PARAMETERS \
    (struct elements * elements, const c205_word *indices, size_t n)
LANEWISE void find_range_span FIND_RANGE_PARAMETERS
{
    struct elements of = *elements;
    uint64_t mask = (UINT64_C(1) << of.shift) - 1;
    /* hosts compare numbers with a sign */
    int64_t low = INT64_MAX, high = 0, most = 0;
    for (size_t i = 0; i < n; i++) {
        uint64_t address = address_of(&of, indices[i]);
        int64_t page = (int64_t)(address >> of.shift);
        int64_t inside = (int64_t)(address & mask);
        low = page < low ? page : low;
        high = page > high ? page : high;
        most = inside > most ? inside : most;
    }
    elements->low = (uint64_t)low;
    elements->high = (uint64_t)high;
    elements->inside = (uint64_t)most;
}

/* Of each its page, told from the lowest. */
#define FIND_PLACES_PARAMETERS \
    (uint8_t *restrict place, const struct elements *elements, \
     const c205_word *restrict indices, size_t n)
LANEWISE void find_places_span FIND_PLACES_PARAMETERS
{
    struct elements of = *elements;
    for (size_t i = 0; i < n; i++)
        place[i] = (uint8_t)((address_of(&of, indices[i]) >> of.shift)
                             - of.low);
}

static void find_range FIND_RANGE_PARAMETERS;
static void find_places FIND_PLACES_PARAMETERS;
VERSIONS(find_range, find_range_span, FIND_RANGE_PARAMETERS,
         (elements, indices, n))
VERSIONS(find_places, find_places_span, FIND_PLACES_PARAMETERS,
         (place, elements, indices, n))

/* ---- Named last ------------------------------------------------------------ */

/* How many of the list it takes to name each page for the last time; 0: it does
 * not. */
static void find_last(const struct elements *elements,
                      const struct index_list *list, uint32_t *last)
{
    uint8_t place[SPAN];
    for (size_t first = 0, n; first < list->count; first += n) {
        n = list->count - first < SPAN ? list->count - first : SPAN;
        find_places(place, elements, list->indices + first, n);
        for (size_t i = 0; i < n; i++)
            last[place[i]] = (uint32_t)(first + i + 1);
    }
}

/* To its place by `last`; there are not many. */
static void add_page(struct named_pages *named, uint64_t low,
                     const uint32_t *last, uint64_t page)
{
    size_t at = named->count++;
    for (; at > 0 && last[named->page[at - 1] - low] > last[page - low]; at--)
        named->page[at] = named->page[at - 1];
    named->page[at] = page;
}

static bool is_known(const struct named_pages *named,
                     const struct index_list *list, uint64_t table,
                     unsigned step)
{
    return named->number == list->number && named->step == step
           && table - named->table <= named->slack;
}

bool named_pages_find(struct named_pages *named,
                      const struct index_list *list, uint64_t table,
                      unsigned step, unsigned shift)
{
    struct elements elements = { .shift = shift,
                                 .places = places_of(step),
                                 .table = table };
    uint32_t last[NAMED_MOST] = { 0 };
    if (is_known(named, list, table, step))
        return true;
    named->number = 0;
    find_range(&elements, list->indices, list->count);
    if (list->count == 0 || elements.high - elements.low >= NAMED_MOST)
        return false;
    find_last(&elements, list, last);
    named->count = 0;
    for (uint64_t page = elements.low; page <= elements.high; page++)
        if (last[page - elements.low] > 0)
            add_page(named, elements.low, last, page);
    named->number = list->number;
    named->step = step;
    named->table = table;
    named->slack = (UINT64_C(1) << shift) - 1 - elements.inside;
    return true;
}
