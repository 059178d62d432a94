/* spans.c - the spans that are written alike for words and half words: bits,
 * comparisons, reductions, copies.
 */
#include "spans.h"

#include "lane_kinds.h"

enum { BITS = 64 /* of a word */ };

/* ---- Words as bits, which set no flags ---------------------------------- */

/* x and y are the words, f their format. */
#define LOGICAL_SPAN(name, format, result)                                 \
    CLONED void name BINARY_PARAMETERS                                     \
    {                                                                      \
        const word_format f = format;                                      \
        (void)flags;                                                       \
        for (size_t i = 0; i < n; i++) {                                   \
            const c205_word x = a[i], y = b[i];                            \
            c[i] = (result) & format_mask(f);                              \
        }                                                                  \
    }
#define LOGICAL(name, result)                                              \
    LOGICAL_SPAN(lanes_##name, whole_words, result)                        \
    LOGICAL_SPAN(halves_##name, half_words, result)

/* The high bits of the one, the coefficient of the other. */
static inline c205_word with_coefficient(word_format f, c205_word high,
                                         c205_word low)
{
    const c205_word mask = format_coefficient_mask(f);

    return (high & ~mask) | (low & mask);
}

LOGICAL(xor, x ^ y)
LOGICAL(and, x & y)
LOGICAL(or, x | y)
LOGICAL(nand, ~(x & y))
LOGICAL(nor, ~(x | y))
LOGICAL(or_not, x | ~y)
LOGICAL(and_not, x & ~y)
LOGICAL(equivalence, ~(x ^ y))
LOGICAL(shift, format_shift(f, x, format_coefficient(f, y)))
LOGICAL(pack, format_pack(f, x, y))
LOGICAL(add_index, with_coefficient(f, x, x + y))
LOGICAL(subtract_index, with_coefficient(f, x, x - y))

#define EXPONENT(name, format)                                             \
    CLONED void name UNARY_PARAMETERS                                      \
    {                                                                      \
        (void)flags;                                                       \
        for (size_t i = 0; i < n; i++)                                     \
            c[i] = format_make(format, 0, format_exponent(format, a[i]));  \
    }
EXPONENT(lanes_exponent, whole_words)
EXPONENT(halves_exponent, half_words)

/* ---- Comparisons -------------------------------------------------------- */

/* A relation of ranks, which holds for no indefinite; or where it does not
 * hold. */
#define COMPARE_SPAN(name, format, relation, inverse)                      \
    CLONED void name(uint64_t *restrict bits, const c205_word *restrict a, \
                     const c205_word *restrict b, size_t n)                \
    {                                                                      \
        for (size_t i = 0; i < n; i += BITS) {                             \
            const size_t length = lesser(n - i, BITS);                     \
            uint64_t word = 0;                                             \
            for (size_t j = 0; j < length; j++) {                          \
                const c205_word x = a[i + j], y = b[i + j];                \
                const uint64_t holds                                       \
                    = (uint64_t)(format_rank(format, x)                    \
                                 relation format_rank(format, y))          \
                      & ~indefinite(larger(x, y)) >> 63;                   \
                word |= (holds ^ inverse) << (BITS - 1 - j);               \
            }                                                              \
            bits[i / BITS] = word;                                         \
        }                                                                  \
    }
#define COMPARE(name, relation, inverse)                                   \
    COMPARE_SPAN(lanes_##name, whole_words, relation, inverse)             \
    COMPARE_SPAN(halves_##name, half_words, relation, inverse)

COMPARE(equal, ==, 0)
COMPARE(not_equal, ==, 1)
COMPARE(not_less, >=, 0)
COMPARE(less, <, 0)

/* ---- Copies ------------------------------------------------------------- */

void lanes_copy(c205_word *c, const c205_word *a, size_t n, uint64_t *flags)
{
    (void)flags;
    if (n > 0)
        memcpy(c, a, n * sizeof *c);
}

CLONED void lanes_store_masked(c205_word *restrict c,
                               const c205_word *restrict a,
                               const uint64_t *restrict bits, size_t n)
{
    for (size_t i = 0; i < n; i += BITS) {
        const size_t length = lesser(n - i, BITS);
        const uint64_t permitted = bits[i / BITS];
        for (size_t j = 0; j < length; j++)
            c[i + j] = permitted >> (BITS - 1 - j) & 1 ? a[i + j] : c[i + j];
    }
}

/* ---- Reductions --------------------------------------------------------- */

#define REDUCTION(name, exact)                                             \
    void name(c205_word *accumulator, const c205_word *a, size_t n,        \
              uint64_t *flags)                                             \
    {                                                                      \
        c205_word result = *accumulator;                                   \
        for (size_t i = 0; i < n; i++)                                     \
            result = exact(result, a[i], flags);                           \
        *accumulator = result;                                             \
    }
REDUCTION(lanes_sum, arith_add_normalised)
REDUCTION(lanes_product, arith_multiply_significant)
REDUCTION(halves_sum, half_add_normalised)
REDUCTION(halves_product, half_multiply_significant)
