/* operations.c - the operations with the functions of the oracle and the machine. */
#include "operations.h"

#include "vm/number/lanes.h"
#include "vm/number/fast_path.h"

#include <string.h>

void spread_bits(c205_word *words, const uint64_t *bits, size_t n)
{
    for (size_t i = 0; i < n; i++)
        words[i] = bits[i / 64] >> (63 - i % 64) & 1;
}

static bool rest_is_zero(const uint64_t *bits, size_t n)
{
    return n % 64 == 0 || bits[n / 64] << n % 64 == 0;
}

/* ---- How the functions of the machine are called ------------------------ */

/* Adapt each kind of function to the signatures of scalar_rule and span_rule.
 * `function` is a name of arith.h or lanes.h. */
#define SPAN_OF(function) \
    static void call_##function(c205_word *c, const c205_word *a, const c205_word *b, \
                                size_t n, uint64_t *flags)
#define CALL_BINARY_SPAN(function) \
    SPAN_OF(function) \
    { \
        function(c, a, b, n, flags); \
    }
#define CALL_UNARY_SPAN(function) \
    SPAN_OF(function) \
    { \
        (void)b; \
        function(c, a, n, flags); \
    }
/* Clears the flags if the bitmap is too long. Comparisons do not change flags. */
#define CALL_RELATION_SPAN(function) \
    SPAN_OF(function) \
    { \
        uint64_t bits[BITMAP]; \
\
        memset(bits, 0xA5, sizeof bits); \
        function(bits, a, b, n); \
        spread_bits(c, bits, n); \
        if (!rest_is_zero(bits, n)) \
            *flags = 0; \
    }

/* clang-format off */
#define BINARY(name, ...) \
    CALL_BINARY(arith_##name) CALL_BINARY_SPAN(lanes_##name) \
    CALL_BINARY(half_##name) CALL_BINARY_SPAN(halves_##name)
#define UNARY(name, ...) \
    CALL_UNARY(arith_##name) CALL_UNARY_SPAN(lanes_##name) \
    CALL_UNARY(half_##name) CALL_UNARY_SPAN(halves_##name)
#define RELATION(name) \
    CALL_RELATION(arith_##name) CALL_RELATION_SPAN(lanes_##name) \
    CALL_RELATION(half_##name) CALL_RELATION_SPAN(halves_##name)
#define BITWISE(name) \
    CALL_BINARY_SPAN(lanes_##name) CALL_BINARY_SPAN(halves_##name)
#define CONVERSION(name, ...) \
    CALL_UNARY(arith_##name) CALL_UNARY_SPAN(lanes_##name)
#define COPY(name, ...) CALL_UNARY_SPAN(lanes_##name)
/* clang-format on */
#include "vm/arith.def"

/* These functions compute one word at a time by the fast path for common operands. */
/* clang-format off */
#define CALL_BINARY_COMMON(name) CALL_BINARY(fast_##name)
#define CALL_UNARY_COMMON(name) CALL_UNARY(fast_##name)
#define CALL_BINARY_REGISTERS(name)
#define CALL_UNARY_REGISTERS(name)
#define CALL_BINARY_VECTORS(name)
#define CALL_UNARY_VECTORS(name)
#define BINARY(name, spans, registers, specials) CALL_BINARY_##registers(name)
#define UNARY(name, spans, registers, specials) CALL_UNARY_##registers(name)
#define RELATION(name) CALL_RELATION(fast_##name)
/* clang-format on */
#include "vm/arith.def"

/* ---- The operations ----------------------------------------------------- */

/* clang-format off */
#define ROW_OF_WORDS(name) \
    { #name, &oracle_full, oracle_##name, call_arith_##name, \
      call_lanes_##name },
#define ROW_OF_HALVES(name) \
    { "half_" #name, &oracle_half, oracle_##name, call_half_##name, \
      call_halves_##name },
#define SPAN_ROW_OF_WORDS(name) \
    { #name, &oracle_full, oracle_##name, NULL, call_lanes_##name },
#define SPAN_ROW_OF_HALVES(name) \
    { "half_" #name, &oracle_half, oracle_##name, NULL, call_halves_##name },
#define ROW_COMMON(name) \
    { "fast_" #name, &oracle_full, oracle_##name, call_fast_##name, NULL },
#define ROW_REGISTERS(name)
#define ROW_VECTORS(name)
#define FORMAT_WORDS &oracle_full
#define FORMAT_HALVES &oracle_half
/* clang-format on */

const struct operation operations[] = {
#define ELEMENTWISE(name, specials) ROW_OF_WORDS(name) ROW_OF_HALVES(name)
#define BITWISE(name) SPAN_ROW_OF_WORDS(name) SPAN_ROW_OF_HALVES(name)
#define CONVERSION(name, of, specials) \
    { #name, FORMAT_##of, oracle_##name, call_arith_##name, call_lanes_##name },
#define COPY(name, specials) SPAN_ROW_OF_WORDS(name)
#include "vm/arith.def"
#define BINARY(name, spans, registers, specials) ROW_##registers(name)
#define UNARY(name, spans, registers, specials) ROW_##registers(name)
#define RELATION(name) ROW_COMMON(name)
#include "vm/arith.def"
};

const size_t operation_count = sizeof operations / sizeof operations[0];

const struct reduction reductions[] = {
/* clang-format off */
#define REDUCTION(name, step, specials) \
    { #name, &oracle_full, oracle_##step, lanes_##name }, \
    { "half_" #name, &oracle_half, oracle_##step, halves_##name },
/* clang-format on */
#include "vm/arith.def"
};

const size_t reduction_count = sizeof reductions / sizeof reductions[0];
