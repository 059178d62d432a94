/* ranks.h - numbers that lie far apart, counted again from 1 on in their order.
 *
 *   rank_index_begin(&ranks, 3) and rank_index_add 70, 20, 70, then
 *   rank_index_sort; rank_index_place of 20 is 1, of 70 it is 2, of 50 it is 0
 */
#ifndef BASE_RANK_INDEX_H
#define BASE_RANK_INDEX_H

#include <stdbool.h>
#include <stddef.h>

struct rank_index {
    size_t count; /* once settled: how many there are, each once */
    size_t *numbers;
};

/* Room for at most that many numbers.  False: no memory; then it may only be freed. */
bool rank_index_begin(struct rank_index *ranks, size_t most);
void rank_index_add(struct rank_index *ranks, size_t number);
/* After the last. */
void rank_index_sort(struct rank_index *ranks);
/* From 1 on; 0: it is none of them. */
size_t rank_index_place(const struct rank_index *ranks, size_t number);
void rank_index_free(struct rank_index *ranks);

#endif
