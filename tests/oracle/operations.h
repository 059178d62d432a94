/* operations.h - every operation of the arithmetic, in both sizes, as the
 * oracle has it and as the machine has it. */
#ifndef OPERATIONS_H
#define OPERATIONS_H

#include "arithmetic_oracle.h"

typedef c205_word scalar_rule(c205_word a, c205_word b, uint64_t *flags);
typedef void span_rule(c205_word *c, const c205_word *a, const c205_word *b, size_t n,
                       uint64_t *flags);

/* scalar: as arith.h; NULL where only lanes.h has the operation.  span: of
 * SPAN elements at most; NULL where only quick.h has it. */
struct operation {
    const char *name;                   /* half_NAME for half words, fast_NAME */
    const struct oracle_format *format; /* of the operands */
    oracle_rule *expected;
    scalar_rule *scalar;
    span_rule *span;
};

enum { SPAN = 512, BITMAP = SPAN / 64 };

extern const struct operation operations[];
extern const size_t operation_count;

/* span: from *accumulator on, step after step. */
struct reduction {
    const char *name;
    const struct oracle_format *format;
    oracle_rule *step;
    void (*span)(c205_word *accumulator, const c205_word *a, size_t n, uint64_t *flags);
};

extern const struct reduction reductions[];
extern const size_t reduction_count;

/* A word 1 or 0 for each of n bits. */
void spread_bits(c205_word *words, const uint64_t *bits, size_t n);

#endif
