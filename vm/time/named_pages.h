/* named_pages.h - the pages that a list of indices names, in the order in which it
 * names them last.
 */
#ifndef C205_NAMED_PAGES_H
#define C205_NAMED_PAGES_H

#include "vm/time/index_list.h"

enum { MAX_NAMED = 64 };

/* Those of the list met last, and of a table of elements of 2^places bits; they are
 * the same for one that begins up to `slack` bits behind it. */
struct named_pages {
    uint64_t number; /* the list's; 0: there was none */
    unsigned places;
    uint64_t table, slack;
    size_t count;
    uint64_t page[MAX_NAMED];
};

/* For pages of 2^shift bits.  False: they lie too far apart to be told. */
bool named_pages_find(struct named_pages *named, const struct index_list *list,
                      uint64_t table, unsigned places, unsigned shift);

#endif
