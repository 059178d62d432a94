/* operations.h - the operations in both sizes with the functions of the oracle and the
 * machine, and the conversions between words and doubles, integers and text. */
#ifndef OPERATIONS_H
#define OPERATIONS_H

#include "arithmetic_oracle.h"

typedef c205_word scalar_rule(c205_word a, c205_word b, uint64_t *flags);
typedef void span_rule(c205_word *c, const c205_word *a, const c205_word *b, size_t n,
                       uint64_t *flags);

/* scalar: signature of arith.h; NULL if only lanes.h has the operation. span: for up to
 * SPAN elements; NULL if only the fast path has the operation. */
struct operation {
    const char *name; /* half_NAME: for half words; fast_NAME: on the fast path */
    const struct oracle_format *format; /* format of the operands */
    oracle_rule *expected;
    scalar_rule *scalar;
    span_rule *span;
};

enum { SPAN = 512, BITMAP = SPAN / 64 };

extern const struct operation operations[];
extern const size_t operation_count;

/* A reduction. span starts with *accumulator, and continues element by element. */
struct reduction {
    const char *name;
    const struct oracle_format *format;
    oracle_rule *step;
    void (*span)(c205_word *accumulator, const c205_word *a, size_t n, uint64_t *flags);
};

extern const struct reduction reductions[];
extern const size_t reduction_count;

/* The conversions of one size of word. */
struct converters {
    const struct oracle_format *format;
    c205_word (*from_double)(double value);
    double (*to_double)(c205_word word);
    c205_word (*from_text)(const char *text, const char **end);
    void (*to_text)(c205_word word, char text[C205_TEXT_SIZE]);
};

struct conversion {
    const char *name;
    const struct converters *converters;
    /* Compares the machine's conversion of one random case with the oracle, and prints
     * the difference. */
    bool (*agrees)(const struct converters *converters, uint64_t *random);
};

extern const struct conversion conversions[];
extern const size_t conversion_count;

bool check_conversion(const struct conversion *conversion, uint64_t seed, size_t cases);

/* Writes the first n bits of a string as n words, each 1 or 0. */
void spread_bits(c205_word *words, const uint64_t *bits, size_t n);

#endif
