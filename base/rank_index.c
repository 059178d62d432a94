/* rank_index.c - sorts numbers without duplicates, and finds their ranks. */
#include "base/rank_index.h"

#include <stdlib.h>

static int compare_numbers(const void *a, const void *b)
{
    const size_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

bool rank_index_begin(struct rank_index *ranks, size_t most)
{
    ranks->count = 0;
    ranks->numbers = malloc((most + 1) * sizeof *ranks->numbers);
    return ranks->numbers;
}

void rank_index_add(struct rank_index *ranks, size_t number)
{
    ranks->numbers[ranks->count++] = number;
}

void rank_index_sort(struct rank_index *ranks)
{
    size_t *numbers = ranks->numbers, kept = 0;
    qsort(numbers, ranks->count, sizeof *numbers, compare_numbers);
    for (size_t i = 0; i < ranks->count; i++)
        if (kept == 0 || numbers[kept - 1] != numbers[i])
            numbers[kept++] = numbers[i];
    ranks->count = kept;
}

size_t rank_index_place(const struct rank_index *ranks, size_t number)
{
    const size_t *place = bsearch(&number, ranks->numbers, ranks->count, sizeof number,
                                  compare_numbers);
    return place ? (size_t)(place - ranks->numbers) + 1 : 0;
}

void rank_index_free(struct rank_index *ranks)
{
    free(ranks->numbers);
}
