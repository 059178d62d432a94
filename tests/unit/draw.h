/* draw.h - the random numbers of a test program. Every run uses the same sequence. */
#ifndef TESTS_DRAW_H
#define TESTS_DRAW_H

#include "tests/random.h"

static uint64_t random_state = RANDOM_SEED;

static inline uint64_t below(uint64_t end)
{
    return xorshift_below(&random_state, end);
}

static inline double between(double low, double high)
{
    return xorshift_real(&random_state, low, high);
}

/* Returns a number from low to high, both included. */
static inline size_t count_between(size_t low, size_t high)
{
    return (size_t)xorshift_between(&random_state, (int64_t)low, (int64_t)high);
}

#endif
