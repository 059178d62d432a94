/* operands.h - pairs of words that are worth computing with.
 *
 * A stream of pairs of one format, the same for the same seed.  A block of
 * it crosses one edge word with all of them, or keeps to one family
 * (alignments, cancellations, unnormalised, extreme exponents, equal values,
 * ...), so that a fault in one shows where specials of another would hide
 * it.  The blocks of edges alternate with the others until all pairs were
 * given.
 */
#ifndef OPERANDS_H
#define OPERANDS_H

#include "arithmetic_oracle.h"

struct operands {
    const struct oracle_format *format;
    uint64_t random;
    size_t position; /* pairs given so far */
};

struct operands operands_begin(const struct oracle_format *format, uint64_t seed);
/* The next n pairs. */
void operands_next(struct operands *operands, c205_word *a, c205_word *b, size_t n);

/* Random numbers: 64 bits; low..high, both included. */
uint64_t random_bits(uint64_t *random);
int64_t random_between(uint64_t *random, int64_t low, int64_t high);
/* A word of any kind. */
c205_word random_word(const struct oracle_format *format, uint64_t *random);

#endif
