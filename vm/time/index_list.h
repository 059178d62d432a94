/* index_list.h - the list of indices of a gather or scatter, and whether it is
 * that of the one before.
 *
 * Records are gathered word by word with one list, each word from a table of its
 * own: what a list costs then is known from the first of them, or nearly so.
 */
#ifndef C205_INDEX_LIST_H
#define C205_INDEX_LIST_H

#include "vm/c205.h"

struct index_list {
    const c205_word *indices;
    size_t count;
    uint64_t number;  /* lists with the same number are the same; never 0 */
    c205_word spread; /* all bits of its indices; none is greater */
    c205_word *kept;  /* a copy of it, if there is one, and its room */
    size_t kept_count, room;
};

/* All zeros before. */
void index_list_meet(struct index_list *list, const c205_word *indices, size_t count);
void index_list_free(struct index_list *list);

#endif
