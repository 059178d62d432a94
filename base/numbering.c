#include "base/numbering.h"

#include <stdlib.h>

static int compare_numbers(const void *a, const void *b)
{
    const size_t *x = a, *y = b;

    return (*x > *y) - (*x < *y);
}

bool numbering_begin(struct numbering *numbering, size_t most)
{
    numbering->count = 0;
    numbering->numbers = malloc((most + 1) * sizeof *numbering->numbers);
    return numbering->numbers;
}

void numbering_add(struct numbering *numbering, size_t number)
{
    numbering->numbers[numbering->count++] = number;
}

void numbering_settle(struct numbering *numbering)
{
    size_t *numbers = numbering->numbers, kept = 0;

    qsort(numbers, numbering->count, sizeof *numbers, compare_numbers);
    for (size_t i = 0; i < numbering->count; i++)
        if (kept == 0 || numbers[kept - 1] != numbers[i])
            numbers[kept++] = numbers[i];
    numbering->count = kept;
}

size_t numbering_place(const struct numbering *numbering, size_t number)
{
    const size_t *place = bsearch(&number, numbering->numbers, numbering->count,
                                  sizeof number, compare_numbers);

    return place ? (size_t)(place - numbering->numbers) + 1 : 0;
}

void numbering_free(struct numbering *numbering)
{
    free(numbering->numbers);
}
