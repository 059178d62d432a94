/* rank_index.h - maps distinct numbers to their ranks, which count from 1.
 *
 *   After rank_index_begin(&ranks, 3), rank_index_add of 70, 20 and 70, and
 *   rank_index_sort, rank_index_place is 1 for 20, 2 for 70 and 0 for 50.
 */
#ifndef BASE_RANK_INDEX_H
#define BASE_RANK_INDEX_H

#include <stdbool.h>
#include <stddef.h>

struct rank_index {
    size_t count; /* after sorting: number of distinct numbers */
    size_t *numbers;
};

/* Allocates room for at most this many numbers. Returns false if the host is out of
 * memory; the index may then only be freed. */
bool rank_index_begin(struct rank_index *ranks, size_t most);
void rank_index_add(struct rank_index *ranks, size_t number);
/* Sorts the index. Must be called after the last number was added. */
void rank_index_sort(struct rank_index *ranks);
/* Returns the rank of a number, from 1 on, or 0 if it was not added. */
size_t rank_index_place(const struct rank_index *ranks, size_t number);
void rank_index_free(struct rank_index *ranks);

#endif
