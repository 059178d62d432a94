/* operands.h - generates pairs of words that test the arithmetic well.
 *
 * It is a stream of pairs of one format, determined by the seed.  A block pairs one
 * edge word with all of them, or contains one family (alignments, cancellations,
 * unnormalised words, extreme exponents, equal values, ...), so that a fault in one
 * family is not hidden by special words of another.  Blocks of edges alternate with the
 * others until all pairs of edges have been used.
 */
#ifndef OPERANDS_H
#define OPERANDS_H

#include "arithmetic_oracle.h"

struct operands {
    const struct oracle_format *format;
    uint64_t random;
    size_t position; /* pairs generated so far */
};

struct operands operands_begin(const struct oracle_format *format, uint64_t seed);
/* Generates the next n pairs. */
void operands_next(struct operands *operands, c205_word *a, c205_word *b, size_t n);

/* Return random numbers: 64 bits; low to high, both included. */
uint64_t random_bits(uint64_t *random);
int64_t random_between(uint64_t *random, int64_t low, int64_t high);
/* Returns a random word of any kind. */
c205_word random_word(const struct oracle_format *format, uint64_t *random);

#endif
