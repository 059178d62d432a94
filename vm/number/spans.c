/* spans.c - span operations whose code is the same for words and half words: bitwise
 * operations, comparisons, reductions, copies.
 */
#include "vm/number/spans.h"

#include "vm/number/lane_kinds.h"
#include "vm/number/fast_path.h"

enum { BITS = 64 /* bits of a word */ };

/* ---- Words as bits, which set no flags ---------------------------------- */

/* `result` is an expression in the two words x and y and their format f. */
#define LOGICAL_SPAN(name, format, result) \
    LANEWISE void name##_block(c205_word *restrict to, const c205_word *a, \
                               const c205_word *b, size_t n) \
    { \
        word_format f = format; \
        for (size_t i = 0; i < n; i++) { \
            c205_word x = a[i], y = b[i]; \
            to[i] = (result)&format_mask(f); \
        } \
    } \
    LANEWISE void name##_span BINARY_PARAMETERS \
    { \
        c205_word space[BLOCK]; \
        bool apart = !spans_meet(c, a, n) && !spans_meet(c, b, n); \
        (void)flags; \
        for (size_t i = 0; i < n; i += BLOCK) { \
            size_t length = min_size(n - i, BLOCK); \
            name##_block(apart ? c + i : space, a + i, b + i, length); \
            if (!apart) \
                copy_block(c + i, space, length); \
        } \
    } \
    BINARY_VERSIONS(name, name##_span)
#define LOGICAL(name, result) \
    LOGICAL_SPAN(lanes_##name, whole_words, result) \
    LOGICAL_SPAN(halves_##name, half_words, result)

LOGICAL(xor, x ^ y)
LOGICAL(and, (x) & (y))
LOGICAL(or, x | y)
LOGICAL(nand, ~((x) & (y)))
LOGICAL(nor, ~(x | y))
LOGICAL(or_not, x | ~y)
LOGICAL(and_not, x & ~y)
LOGICAL(equivalence, ~(x ^ y))
LOGICAL(shift, format_shift(f, x, format_coefficient(f, y)))
LOGICAL(pack, format_pack(f, x, y))
LOGICAL(add_index, format_with_coefficient(f, x, x + y))
LOGICAL(subtract_index, format_with_coefficient(f, x, x - y))

#define EXPONENT(name, format) \
    LANEWISE void name##_span UNARY_PARAMETERS \
    { \
        (void)flags; \
        for (size_t i = 0; i < n; i++) \
            c[i] = format_make(format, 0, format_exponent(format, a[i])); \
    } \
    UNARY_VERSIONS(name, name##_span)
EXPONENT(lanes_exponent, whole_words)
EXPONENT(halves_exponent, half_words)

/* ---- Comparisons -------------------------------------------------------- */

/* Returns the number 0 with the smallest exponent for a machine zero, and other words
 * unchanged. */
static inline c205_word zero_as_number(c205_word w)
{
    return max_word(w, MIN_NUMBER);
}

/* Returns a word whose first bit is 1 if the number is not normalised. */
static inline uint64_t unnormalised(word_format f, c205_word number)
{
    uint64_t digits = number << f.exponent_bits;
    return number == MIN_NUMBER ? 0 : ~(digits ^ digits << 1);
}

/* Returns an integer for the comparison of normalised numbers of the same sign: the
 * order of the integers is the order of the numbers. For negative numbers, the exponent
 * is complemented. */
static inline c205_word order(word_format f, c205_word w)
{
    c205_word exponent = ~format_coefficient_mask(f);
    int64_t sign = (int64_t)(w << f.exponent_bits) >> 63;
    return w ^ (exponent & (c205_word)sign);
}

/* Returns a word whose first bit is 1 if x < y as signed integers. */
static inline uint64_t less_integer(uint64_t x, uint64_t y)
{
    uint64_t difference = x - y;
    return difference ^ ((x ^ y) & (difference ^ x));
}

static inline uint64_t less_number(word_format f, c205_word x, c205_word y)
{
    uint64_t of_one_sign = less_integer(order(f, x), order(f, y));
    uint64_t sign_x = x << f.exponent_bits;
    uint64_t sign_y = y << f.exponent_bits;
    return of_one_sign ^ ((of_one_sign ^ sign_x) & (sign_x ^ sign_y));
}

static inline int64_t coefficient_bits(word_format f, c205_word w)
{
    return (int64_t)(w << f.exponent_bits);
}

/* Returns the exponent field in place, or 0 for a machine zero that zero_as_number()
 * has converted. Exponent 0 also gives 0. */
static inline uint64_t exponent_bits(word_format f, c205_word w)
{
    return w == MIN_NUMBER ? 0 : w & ~format_coefficient_mask(f);
}

/* Relations of two words x and y of the format f. The first bit of the value is 1 if
 * the relation holds. */
#define NOT_EQUAL(f, x, y) ((x ^ y) | (0 - (x ^ y)))
#define EQUAL(f, x, y) ~NOT_EQUAL(f, x, y)
#define LESS(f, x, y) less_number(f, x, y)
#define NOT_LESS(f, x, y) ~LESS(f, x, y)

/* Eight masks of one bit each, from bit i on, counted from the left. */
#define PLACES(i) \
    FIRST >> (i), FIRST >> (i + 1), FIRST >> (i + 2), FIRST >> (i + 3), \
        FIRST >> (i + 4), FIRST >> (i + 5), FIRST >> (i + 6), FIRST >> (i + 7)
#define FIRST (UINT64_C(1) << (BITS - 1))
static const uint64_t places[BITS] = { PLACES(0),  PLACES(8),  PLACES(16), PLACES(24),
                                       PLACES(32), PLACES(40), PLACES(48), PLACES(56) };

/* Copies the first bit to all other bits. */
static inline uint64_t copied(uint64_t bit)
{
    return (uint64_t)((int64_t)bit >> 63);
}

/* Compares the words of a block by their ranks (format_rank()), one result bit each.
 * The relation is false for an indefinite word. inverse is 1 for the negated
 * relation. */
#define BY_RANK(format, relation, inverse) \
    for (size_t j = 0; j < length; j++) { \
        c205_word x = a[i + j], y = b[i + j]; \
        uint64_t holds = (uint64_t)(format_rank(format, x) \
                                        relation format_rank(format, y)) \
                         & ~indefinite(max_word(x, y)) >> 63; \
        word |= (holds ^ inverse) << (BITS - 1 - j); \
    }

/* Compares the words of a block by their coefficients, one result bit each. This is
 * valid for zeros and for words with exponent 0, such as indices. `exponents` becomes
 * nonzero if the block has other words. */
#define BY_COEFFICIENT(format, relation, inverse) \
    for (size_t j = 0; j < length; j++) { \
        c205_word x = zero_as_number(a[i + j]); \
        c205_word y = zero_as_number(b[i + j]); \
        uint64_t holds = (uint64_t)(coefficient_bits(format, x) \
                                        relation coefficient_bits(format, y)); \
        word |= (0 - (holds ^ inverse)) & places[j]; \
        exponents |= exponent_bits(format, x) | exponent_bits(format, y); \
    }

#define COMPARE_PARAMETERS \
    (uint64_t *restrict bits, const c205_word *restrict a, \
     const c205_word *restrict b, size_t n)

/* Compares a span block by block. A block that contains words other than normalised
 * numbers and machine zeros is compared again, by coefficients if possible and
 * otherwise by rank. */
#define COMPARE_SPAN(name, format, is, relation, inverse) \
    LANEWISE void name##_span COMPARE_PARAMETERS \
    { \
        for (size_t i = 0; i < n; i += BITS) { \
            size_t length = min_size(n - i, BITS); \
            uint64_t word = 0, odd = 0; \
            c205_word most = MIN_NUMBER; \
            for (size_t j = 0; j < length; j++) { \
                c205_word x = zero_as_number(a[i + j]); \
                c205_word y = zero_as_number(b[i + j]); \
                word |= copied(is(format, x, y)) & places[j]; \
                odd |= unnormalised(format, x) | unnormalised(format, y); \
                most = max_word(most, max_word(x, y)); \
            } \
            if ((odd | indefinite(most)) >> 63) { \
                uint64_t exponents = word = 0; \
                BY_COEFFICIENT(format, relation, inverse) \
                if (exponents) { \
                    word = 0; \
                    BY_RANK(format, relation, inverse) \
                } \
            } \
            bits[i / BITS] = word; \
        } \
    }
#define COMPARE_WORDS(name, holds) \
    static void name COMPARE_PARAMETERS \
    { \
        for (size_t i = 0; i < n; i += BITS) { \
            size_t length = min_size(n - i, BITS); \
            uint64_t word = 0; \
            for (size_t j = 0; j < length; j++) \
                word |= (uint64_t)holds(a[i + j], b[i + j]) << (BITS - 1 - j); \
            bits[i / BITS] = word; \
        } \
    }
#define COMPARE(name, is, relation, inverse) \
    COMPARE_SPAN(lanes_##name, whole_words, is, relation, inverse) \
    COMPARE_WORDS(lanes_##name##_words, fast_##name) \
    VERSIONS(lanes_##name, lanes_##name##_words, COMPARE_PARAMETERS, (bits, a, b, n)) \
    COMPARE_SPAN(halves_##name, half_words, is, relation, inverse) \
    VERSIONS(halves_##name, halves_##name##_span, COMPARE_PARAMETERS, (bits, a, b, n))

COMPARE(equal, EQUAL, ==, 0)
COMPARE(not_equal, NOT_EQUAL, ==, 1)
COMPARE(not_less, NOT_LESS, >=, 0)
COMPARE(less, LESS, <, 0)

/* ---- Copies ------------------------------------------------------------- */

void lanes_copy(c205_word *c, const c205_word *a, size_t n, uint64_t *flags)
{
    (void)flags;
    if (n > 0)
        memmove(c, a, n * sizeof *c);
}

LANEWISE void lanes_fill_span(c205_word *c, c205_word word, size_t n)
{
    for (size_t i = 0; i < n; i++)
        c[i] = word;
}
VERSIONS(lanes_fill, lanes_fill_span, (c205_word * c, c205_word word, size_t n),
         (c, word, n))

LANEWISE void lanes_store_masked_span(c205_word *restrict c,
                                      const c205_word *restrict a,
                                      const uint64_t *restrict bits, size_t n)
{
    for (size_t i = 0; i < n; i += BITS) {
        size_t length = min_size(n - i, BITS);
        uint64_t permitted = bits[i / BITS];
        for (size_t j = 0; j < length; j++)
            c[i + j] = permitted & places[j] ? a[i + j] : c[i + j];
    }
}
VERSIONS(lanes_store_masked, lanes_store_masked_span,
         (c205_word *restrict c, const c205_word *restrict a,
          const uint64_t *restrict bits, size_t n),
         (c, a, bits, n))

/* ---- Reductions --------------------------------------------------------- */

#define REDUCTION_SPAN(name, exact) \
    void name(c205_word *accumulator, const c205_word *a, size_t n, uint64_t *flags) \
    { \
        c205_word result = *accumulator; \
        for (size_t i = 0; i < n; i++) \
            result = exact(result, a[i], flags); \
        *accumulator = result; \
    }
#define REDUCTION(name, step, specials) \
    REDUCTION_SPAN(lanes_##name, arith_##step) \
    REDUCTION_SPAN(halves_##name, half_##step)
#include "vm/arith.def"
