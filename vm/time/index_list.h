/* index_list.h - compares the indices of a gather or scatter with the previous list.
 *
 * Programs gather records word by word. Each word is in a separate table, but all
 * gathers have the same list of indices. The first gather computes most of the cost,
 * and the others use its results.
 */
#ifndef C205_INDEX_LIST_H
#define C205_INDEX_LIST_H

#include "vm/c205.h"

struct index_list {
    const c205_word *indices;
    size_t count;
    uint64_t number;  /* number of the list; equal lists have equal numbers, never 0 */
    c205_word spread; /* the OR of all indices, an upper bound of each */
    c205_word *kept;  /* a copy of the latest list or NULL, and the capacity */
    size_t kept_count, room;
};

/* Makes `indices` the current list. A list that differs from the previous list gets a
 * new number. The struct must be zeroed before the first call. */
void index_list_meet(struct index_list *list, const c205_word *indices, size_t count);
void index_list_free(struct index_list *list);

#endif
