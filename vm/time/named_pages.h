/* named_pages.h - finds the pages that a list of indices refers to, in the order of the
 * last reference to each.
 */
#ifndef C205_NAMED_PAGES_H
#define C205_NAMED_PAGES_H

#include "vm/time/index_list.h"

enum { MAX_NAMED = 64 };

/* The pages that the latest list of indices accesses in a table of elements of 2^places
 * bits. They are the same for a table that begins up to `slack` bits later. */
struct named_pages {
    uint64_t number; /* number of the list; 0: none */
    unsigned places;
    uint64_t table, slack;
    size_t count;
    uint64_t page[MAX_NAMED];
};

/* Finds the pages of a table that an indexed instruction accesses: the pages of the
 * elements whose indices are in the list. An element has 2^places bits, a page 2^shift
 * bits. Returns false if the pages are too far apart. */
bool named_pages_find(struct named_pages *named, const struct index_list *list,
                      uint64_t table, unsigned places, unsigned shift);

#endif
