/* index_list.h - the list of indices of a gather or scatter, and whether it equals the
 * previous list.
 *
 * Programs gather records word by word with one list, each word from a table of its
 * own. Most of the cost of such a list is known after the first of them.
 */
#ifndef C205_INDEX_LIST_H
#define C205_INDEX_LIST_H

#include "vm/c205.h"

struct index_list {
    const c205_word *indices;
    size_t count;
    uint64_t number;  /* equal lists have equal numbers; never 0 */
    c205_word spread; /* the OR of its indices; no index is greater */
    c205_word *kept;  /* a copy of the latest list or NULL, and its capacity */
    size_t kept_count, room;
};

/* Makes the indices the current list and sets its number. The list must be zeroed
 * before the first call. */
void index_list_meet(struct index_list *list, const c205_word *indices, size_t count);
void index_list_free(struct index_list *list);

#endif
