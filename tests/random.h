/* random.h - random words; the same seed gives the same words on every run. */
#ifndef TESTS_RANDOM_H
#define TESTS_RANDOM_H

#include "vm/number/word.h"

#define RANDOM_SEED UINT64_C(0x205205205205205)

/* Returns the next number of Marsaglia's xorshift with the shifts 13, 7, 17. The state
 * is never 0. */
static inline uint64_t xorshift(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state;
}

/* Returns a number from low to high, both included. */
static inline int64_t xorshift_between(uint64_t *state, int64_t low, int64_t high)
{
    return low + (int64_t)(xorshift(state) % (uint64_t)(high - low + 1));
}

/* Returns a number from 0 to end - 1. */
static inline uint64_t xorshift_below(uint64_t *state, uint64_t end)
{
    return xorshift(state) % end;
}

static inline double xorshift_real(uint64_t *state, double low, double high)
{
    return low + (high - low) * (double)(xorshift(state) >> 11) * 0x1p-53;
}

/* Returns a normalised word of a format with an exponent from low to high. */
static inline c205_word xorshift_normalised_of(word_format f, uint64_t *state,
                                               int32_t low, int32_t high)
{
    int32_t exponent = (int32_t)xorshift_between(state, low, high);
    uint64_t random = xorshift(state);
    int64_t c = (int64_t)(random >> (65 - f.digits) | UINT64_C(1) << (f.digits - 1));
    return format_make(f, exponent, random & 1 ? c : ~c);
}

/* Returns an unnormalised number with an exponent from low to high, and with all
 * numbers of significant bits except the largest. */
static inline c205_word xorshift_unnormalised_of(word_format f, uint64_t *state,
                                                 int32_t low, int32_t high)
{
    int32_t exponent = (int32_t)xorshift_between(state, low, high);
    int places = (int)xorshift_between(state, 64 - f.digits, 63);
    return format_make(f, exponent, (int64_t)xorshift(state) >> places);
}

static inline c205_word xorshift_normalised(uint64_t *state, int32_t low, int32_t high)
{
    return xorshift_normalised_of(whole_words, state, low, high);
}

static inline c205_word xorshift_unnormalised(uint64_t *state, int32_t low,
                                              int32_t high)
{
    return xorshift_unnormalised_of(whole_words, state, low, high);
}

#endif
