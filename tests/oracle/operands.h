/* operands.h - generates pairs of words that test the arithmetic well.
 *
 * The seed determines a stream of pairs of the same format. Some blocks of the stream
 * pair one edge word with all edge words. Other blocks contain one family, such as
 * alignments, cancellations, unnormalised words, extreme exponents or equal values, so
 * that special words of another family do not hide a fault. Both kinds of blocks
 * alternate until all pairs of edge words have been used.
 */
#ifndef OPERANDS_H
#define OPERANDS_H

#include "arithmetic_oracle.h"

struct operands {
    const struct oracle_format *format;
    uint64_t random;
    size_t position; /* number of pairs generated so far */
};

struct operands operands_begin(const struct oracle_format *format, uint64_t seed);
/* Generates the next n pairs of operands. */
void operands_next(struct operands *operands, c205_word *a, c205_word *b, size_t n);

/* Return 64 random bits, and a random integer from low to high, both included. */
uint64_t random_bits(uint64_t *random);
int64_t random_between(uint64_t *random, int64_t low, int64_t high);
/* Returns a random word of any kind. */
c205_word random_word(const struct oracle_format *format, uint64_t *random);

#endif
