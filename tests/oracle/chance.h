/* chance.h - what random scenes are drawn with; the state is never 0. */
#ifndef CHANCE_H
#define CHANCE_H

#include "tests/random.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* 0 .. count - 1. */
static inline size_t below(uint64_t *state, size_t count)
{
    return (size_t)((xorshift(state) >> 16) % count);
}

static inline bool one_in(uint64_t *state, size_t count)
{
    return below(state, count) == 0;
}

static inline double between(uint64_t *state, double low, double high)
{
    return xorshift_real(state, low, high);
}

/* As many between 1 and 2 as between 100 and 200. */
static inline double of_any_size(uint64_t *state, double low, double high)
{
    return exp(between(state, log(low), log(high)));
}

/* Another stream: what the first one continues to draw does not depend on it.  Several from one
 * state have other numbers, the first odd. */
static inline uint64_t stream_beside(uint64_t state, uint64_t times, uint64_t more)
{
    uint64_t other = state * times + more;
    for (int i = 0; i < 8; i++)
        xorshift(&other);
    return other;
}

#endif
