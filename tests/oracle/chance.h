/* chance.h - random numbers for scenes and programs. The state is never 0. */
#ifndef CHANCE_H
#define CHANCE_H

#include "tests/random.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* Returns an integer from 0 to count - 1. */
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

/* Returns a number whose logarithm is uniform: 1 to 2 is as likely as 100 to 200. */
static inline double of_any_size(uint64_t *state, double low, double high)
{
    return exp(between(state, log(low), log(high)));
}

/* Returns the state of a second stream, which does not change the first stream. Streams
 * from the same state need different multipliers; the first must be odd. */
static inline uint64_t stream_beside(uint64_t state, uint64_t times, uint64_t more)
{
    uint64_t other = state * times + more;
    for (int i = 0; i < 8; i++)
        xorshift(&other);
    return other;
}

#endif
