/* lanes.c - spans of words; see lanes.h for what they promise.
 *
 * A span goes block by block through the functions of lane.h; if one of them
 * was not right for a lane, the block is done again by the exact rule of
 * arith.c.
 */
#include "lanes.h"

#include "lane.h"

/* Whole spans are compiled several times, for what the host's vector unit
 * can do; the loader chooses.  Only gcc on ELF systems with glibc has this
 * in a form that links across files. */
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__)         \
    && !defined(__clang__) && !defined(NO_TARGET_CLONES)
#define CLONED                                                             \
    __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3",       \
                                 "default")))
#else
#define CLONED
#endif

enum {
    BLOCK = 128, /* lanes */
    BITS = 64    /* of a word */
};

/* ---- Spans -------------------------------------------------------------- */

typedef c205_word exact_binary(c205_word a, c205_word b, uint64_t *flags);
typedef c205_word exact_unary(c205_word a, uint64_t *flags);

static void binary_exactly(exact_binary *exact, c205_word *c,
                           const c205_word *a, const c205_word *b, size_t n,
                           uint64_t *flags)
{
    for (size_t i = 0; i < n; i++)
        c[i] = exact(a[i], b[i], flags);
}

static void unary_exactly(exact_unary *exact, c205_word *c,
                          const c205_word *a, size_t n, uint64_t *flags)
{
    for (size_t i = 0; i < n; i++)
        c[i] = exact(a[i], flags);
}

static inline size_t lesser(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* A span of lanes and, for the blocks where one was not right, of words. */
#define SPAN(name, parameters, of_lane, exactly)                           \
    CLONED void lanes_##name parameters                                    \
    {                                                                      \
        for (size_t i = 0; i < n; i += BLOCK) {                            \
            const size_t end = i + lesser(n - i, BLOCK);                   \
            uint64_t odd = 0, zeros = 0;                                   \
            for (size_t j = i; j < end; j++) {                             \
                const lane result = of_lane;                               \
                odd |= result.odd;                                         \
                zeros |= zero(result.word);                                \
                c[j] = result.word;                                        \
            }                                                              \
            if (odd >> 63)                                                 \
                exactly;                                                   \
            else if (zeros >> 63)                                          \
                *flags |= FLAG_MACHINE_ZERO;                               \
        }                                                                  \
    }

#define BINARY_PARAMETERS                                                  \
    (c205_word *restrict c, const c205_word *restrict a,                   \
     const c205_word *restrict b, size_t n, uint64_t *restrict flags)
#define BINARY(name)                                                       \
    SPAN(name, BINARY_PARAMETERS, lane_##name(a[j], b[j]),                 \
         binary_exactly(arith_##name, c + i, a + i, b + i, end - i, flags))

#define UNARY_PARAMETERS                                                   \
    (c205_word *restrict c, const c205_word *restrict a, size_t n,         \
     uint64_t *restrict flags)
#define UNARY(name)                                                        \
    SPAN(name, UNARY_PARAMETERS, lane_##name(a[j]),                        \
         unary_exactly(arith_##name, c + i, a + i, end - i, flags))

/* What is rare has no fast path. */
#define EXACT(name)                                                        \
    void lanes_##name BINARY_PARAMETERS                                    \
    {                                                                      \
        binary_exactly(arith_##name, c, a, b, n, flags);                   \
    }

/* Bits, which set no flags. */
#define LOGICAL(name, of_a_and_b)                                          \
    CLONED void lanes_##name BINARY_PARAMETERS                             \
    {                                                                      \
        (void)flags;                                                       \
        for (size_t i = 0; i < n; i++)                                     \
            c[i] = of_a_and_b(a[i], b[i]);                                 \
    }

/* A relation of ranks, which holds for no indefinite; or where it does not
 * hold. */
#define COMPARE(name, relation, inverse)                                   \
    CLONED void lanes_##name(uint64_t *restrict bits,                      \
                             const c205_word *restrict a,                  \
                             const c205_word *restrict b, size_t n)        \
    {                                                                      \
        for (size_t i = 0; i < n; i += BITS) {                             \
            const size_t length = lesser(n - i, BITS);                     \
            uint64_t word = 0;                                             \
            for (size_t j = 0; j < length; j++) {                          \
                const c205_word x = a[i + j], y = b[i + j];                \
                const uint64_t holds                                       \
                    = (uint64_t)(word_rank(x) relation word_rank(y))       \
                      & ~indefinite(larger(x, y)) >> 63;                   \
                word |= (holds ^ inverse) << (BITS - 1 - j);               \
            }                                                              \
            bits[i / BITS] = word;                                         \
        }                                                                  \
    }

BINARY(add_upper)
BINARY(add_normalised)
BINARY(subtract_upper)
BINARY(subtract_normalised)
BINARY(average)
BINARY(average_difference)
BINARY(multiply_upper)
BINARY(multiply_significant)
BINARY(divide_significant)
EXACT(add_lower)
EXACT(subtract_lower)
EXACT(multiply_lower)
EXACT(divide_upper)
EXACT(adjust_significance)
EXACT(adjust_exponent)
UNARY(square_root)
UNARY(truncate)
UNARY(floor)
UNARY(ceiling)
UNARY(absolute)
UNARY(negate)
COMPARE(equal, ==, 0)
COMPARE(not_equal, ==, 1)
COMPARE(not_less, >=, 0)
COMPARE(less, <, 0)

#define XOR(a, b) ((a) ^ (b))
#define AND(a, b) ((a) & (b))
#define OR(a, b) ((a) | (b))
#define NAND(a, b) ~((a) & (b))
#define NOR(a, b) ~((a) | (b))
#define OR_NOT(a, b) ((a) | ~(b))
#define AND_NOT(a, b) ((a) & ~(b))
#define EQUIVALENCE(a, b) ~((a) ^ (b))
#define PACK(a, b) ((a) << 48 | ((b) & WORD_COEFFICIENT_MASK))
#define HIGH(a) ((a) & ~WORD_COEFFICIENT_MASK)
#define ADD_INDEX(a, b) (HIGH(a) | (((a) + (b)) & WORD_COEFFICIENT_MASK))
#define SUBTRACT_INDEX(a, b)                                               \
    (HIGH(a) | (((a) - (b)) & WORD_COEFFICIENT_MASK))

static inline c205_word shift(c205_word a, c205_word b)
{
    const int64_t count = (int64_t)(b << 16) >> 16;
    const uint64_t left = (uint64_t)count & 63;
    const c205_word rotated = a << left | a >> ((64 - left) & 63);
    const c205_word shifted
        = (c205_word)((int64_t)a >> (count < -63 ? 63 : -count & 63));

    return count < 0 ? shifted : rotated;
}

LOGICAL(xor, XOR)
LOGICAL(and, AND)
LOGICAL(or, OR)
LOGICAL(nand, NAND)
LOGICAL(nor, NOR)
LOGICAL(or_not, OR_NOT)
LOGICAL(and_not, AND_NOT)
LOGICAL(equivalence, EQUIVALENCE)
LOGICAL(shift, shift)
LOGICAL(pack, PACK)
LOGICAL(add_index, ADD_INDEX)
LOGICAL(subtract_index, SUBTRACT_INDEX)

CLONED void lanes_exponent UNARY_PARAMETERS
{
    (void)flags;
    for (size_t i = 0; i < n; i++)
        c[i] = (c205_word)exponent(a[i]) & WORD_COEFFICIENT_MASK;
}

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

static c205_word reduce(exact_binary *exact, c205_word from,
                        const c205_word *a, size_t n, uint64_t *flags)
{
    for (size_t i = 0; i < n; i++)
        from = exact(from, a[i], flags);
    return from;
}

void lanes_sum(c205_word *accumulator, const c205_word *a, size_t n,
               uint64_t *flags)
{
    *accumulator = reduce(arith_add_normalised, *accumulator, a, n, flags);
}

void lanes_product(c205_word *accumulator, const c205_word *a, size_t n,
                   uint64_t *flags)
{
    *accumulator
        = reduce(arith_multiply_significant, *accumulator, a, n, flags);
}
