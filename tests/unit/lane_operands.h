/* lane_operands.h - random words and half words for tests of spans. They include all
 * kinds of words that a fast path of vm/number may accept or must reject. */
#ifndef TESTS_LANE_OPERANDS_H
#define TESTS_LANE_OPERANDS_H

#include "tests/random.h"
#include "vm/number/word.h"

typedef c205_word supply(word_format f, uint64_t *seed);

/* Special words on both sides of each limit: special exponents, the limits of
 * exponents, coefficients and integers, and the number one. */
enum {
    LANE_EXPONENTS = 10,
    LANE_COEFFICIENTS = 8,
    LANE_SPECIALS = LANE_EXPONENTS * LANE_COEFFICIENTS
};
c205_word lane_special_at(word_format f, size_t i);

supply lane_near, lane_or_machine_zero, lane_any_bits, lane_sparse, lane_mostly_usual,
    lane_about_a_square;

/* The number of functions that supply random words, without those about squares. */
enum { LANE_SUPPLIES = 23 };
extern supply *const lane_supplies[LANE_SUPPLIES];

void lane_fill(c205_word *words, size_t n, supply *next, word_format f, uint64_t *seed);

#endif
