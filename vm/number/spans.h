/* spans.h - defines loops over spans of words, for the files that define the functions
 * of lanes.h.
 */
#ifndef C205_SPANS_H
#define C205_SPANS_H

#include "vm/min_max.h"
#include "vm/number/host.h"
#include "vm/number/lane_kinds.h"
#include "vm/number/lanes.h"
#include "vm/number/common_range.h"

#define BINARY_PARAMETERS \
    (c205_word * c, const c205_word *a, const c205_word *b, size_t n, uint64_t *flags)
#define UNARY_PARAMETERS (c205_word * c, const c205_word *a, size_t n, uint64_t *flags)

#define BINARY_VERSIONS(name, plain) \
    VERSIONS(name, plain, BINARY_PARAMETERS, (c, a, b, n, flags))
#define UNARY_VERSIONS(name, plain) \
    VERSIONS(name, plain, UNARY_PARAMETERS, (c, a, n, flags))

/* These loops process one word at a time. */
#define BINARY_WORDS(name, of_words) \
    void name BINARY_PARAMETERS \
    { \
        for (size_t i = 0; i < n; i++) \
            c[i] = of_words(a[i], b[i], flags); \
    }
#define UNARY_WORDS(name, of_word) \
    void name UNARY_PARAMETERS \
    { \
        for (size_t i = 0; i < n; i++) \
            c[i] = of_word(a[i], flags); \
    }

/* Recomputes by the exact rule each word whose first bit of odd is 1. The other words
 * are valid, and a machine zero among them sets its flag. */
static inline void binary_again(arith_binary *exact, c205_word *c, const c205_word *a,
                                const c205_word *b, const uint64_t *odd, size_t n,
                                uint64_t *flags)
{
    for (size_t i = 0; i < n; i++)
        if (odd[i] >> 63)
            c[i] = exact(a[i], b[i], flags);
        else if (word_is_machine_zero(c[i]))
            *flags |= FLAG_MACHINE_ZERO;
}

static inline void unary_again(arith_unary *exact, c205_word *c, const c205_word *a,
                               const uint64_t *odd, size_t n, uint64_t *flags)
{
    for (size_t i = 0; i < n; i++)
        if (odd[i] >> 63)
            c[i] = exact(a[i], flags);
        else if (word_is_machine_zero(c[i]))
            *flags |= FLAG_MACHINE_ZERO;
}

/* Spans are processed block by block. If the fast arithmetic of lane_parts.h marks a
 * result of a block as odd, the exact rule computes that result again.
 *
 * If the result overlaps an operand, a block is computed in a temporary array first, so
 * the operands are read before the result is stored. LANES is the number of words that
 * one vector operation takes. All loops run over whole groups of LANES: the last group
 * of a block overlaps the previous group, and a block shorter than LANES is padded.
 */
enum { BLOCK = 256, LANES = 8 };

static inline bool spans_meet(const c205_word *one, const c205_word *other, size_t n)
{
    uintptr_t a = (uintptr_t)one, b = (uintptr_t)other;
    return a - b < n * sizeof *one || b - a < n * sizeof *one;
}

static inline void copy_block(c205_word *to, const c205_word *from, size_t n)
{
    memcpy(to, from, n * sizeof *to);
}

/* Copies n words, 1 <= n <= LANES, and fills the remaining lanes with copies of the
 * first word. */
static inline void fill_lanes(c205_word *lanes, const c205_word *words, size_t n)
{
    for (size_t i = 0; i < LANES; i++)
        lanes[i] = words[0];
    for (size_t i = 1; i < n; i++)
        lanes[i] = words[i];
}

/* Runs the body, a statement or a block, for each index j of the whole groups of LANES,
 * then for the last LANES of n. */
#define EACH_LANE(body) \
    for (size_t i = 0, end = n & ~(size_t)(LANES - 1);;) { \
        for (size_t j = i; j < end; j++) \
            body; \
        if (end == n) \
            break; \
        i = n - LANES; \
        end = n; \
    }
#define BLOCK_OF(name, parameters, of_lane, exactly) \
    LANEWISE void name##_block parameters \
    { \
        uint64_t odd[BLOCK], odds = 0, zeros = 0; \
        EACH_LANE({ \
            lane result = of_lane; \
            odd[j] = result.odd; \
            odds |= result.odd; \
            zeros |= zero(result.word); \
            to[j] = result.word; \
        }); \
        if (odds >> 63) \
            exactly; \
        else if (zeros >> 63) \
            *flags |= FLAG_MACHINE_ZERO; \
    }
#define BLOCK_PARAMETERS \
    (c205_word *restrict to, const c205_word *a, const c205_word *b, size_t n, \
     uint64_t *flags)
#define BINARY_SPAN(name, common_block, lane_function, exact) \
    BLOCK_OF(name, BLOCK_PARAMETERS, lane_function(a[j], b[j]), \
             binary_again(exact, to, a, b, odd, n, flags)) \
    LANEWISE void name##_span BINARY_PARAMETERS \
    { \
        c205_word space[BLOCK], some_a[LANES], some_b[LANES]; \
        bool apart = !spans_meet(c, a, n) && !spans_meet(c, b, n); \
        for (size_t i = 0, length; i < n; i += length) { \
            const c205_word *x = a + i, *y = b + i; \
            length = min_size(n - i, BLOCK); \
            bool few = length < LANES; \
            c205_word *to = apart && !few ? c + i : space; \
            size_t count = few ? LANES : length; \
            if (few) { \
                fill_lanes(some_a, x, length); \
                fill_lanes(some_b, y, length); \
                x = some_a; \
                y = some_b; \
            } \
            if (!common_block(to, x, y, count, flags)) \
                name##_block(to, x, y, count, flags); \
            if (few || !apart) \
                copy_block(c + i, space, length); \
        } \
    }
#define UNARY_SPAN(name, lane_function, exact) \
    BLOCK_OF(name, \
             (c205_word *restrict to, const c205_word *a, size_t n, uint64_t *flags), \
             lane_function(a[j]), unary_again(exact, to, a, odd, n, flags)) \
    LANEWISE void name##_span UNARY_PARAMETERS \
    { \
        c205_word space[BLOCK], some_a[LANES]; \
        bool apart = !spans_meet(c, a, n); \
        for (size_t i = 0, length; i < n; i += length) { \
            const c205_word *x = a + i; \
            length = min_size(n - i, BLOCK); \
            bool few = length < LANES; \
            if (few) { \
                fill_lanes(some_a, x, length); \
                x = some_a; \
            } \
            name##_block(apart && !few ? c + i : space, x, few ? LANES : length, \
                         flags); \
            if (few || !apart) \
                copy_block(c + i, space, length); \
        } \
    }

/* ---- Blocks of one kind ----------------------------------------------------
 *
 * In most blocks all words are common (common_range.h), or all words of one operand are
 * machine zeros. A test for these cases takes fewer steps than the general code. A
 * common_block function returns true if it computed the block.
 */

#define NEVER_COMMON(to, a, b, n, flags) false

LANEWISE bool common_lanes(const c205_word *a, const c205_word *b, size_t n)
{
    uint64_t all = UINT64_MAX, any = 0;
    EACH_LANE({
        uint64_t x = common_edges(a[j]);
        uint64_t y = common_edges(b[j]);
        all &= x & y;
        any |= x | y;
    });
    return common_by_edges(all, any);
}

/* Tests whether all words are common. It tests the first words separately, because a
 * block that contains a word that is not common usually has one at its start. */
LANEWISE bool common_pairs(const c205_word *a, const c205_word *b, size_t n)
{
    enum { FIRST_ONES = 2 * LANES };
    size_t first = n > 2 * FIRST_ONES ? FIRST_ONES : n;
    return common_lanes(a, b, first)
           && (first == n || common_lanes(a + first, b + first, n - first));
}

LANEWISE bool zero_lanes(const c205_word *a, size_t n)
{
    c205_word most = a[0];
    if (!is_zero(most))
        return false;
    EACH_LANE(most = max_word(most, a[j]));
    return is_zero(most);
}

/* The result if one operand consists of machine zeros and the other of common words or
 * machine zeros: zeros, the other words, or neither. */
enum zeros_give { GIVE_ZEROS, GIVE_OTHERS, GIVE_NEITHER };

LANEWISE bool block_of_zeros(c205_word *restrict to, const c205_word *zeros,
                             const c205_word *others, size_t n, enum zeros_give gives,
                             uint64_t *flags)
{
    if (gives == GIVE_NEITHER || !zero_lanes(zeros, n))
        return false;
    bool both = zero_lanes(others, n);
    if (!both && !common_pairs(others, others, n))
        return false;
    if (both || gives == GIVE_ZEROS) {
        EACH_LANE(to[j] = C205_MACHINE_ZERO);
        *flags |= FLAG_MACHINE_ZERO;
    } else
        copy_block(to, others, n);
    return true;
}

/* Defines a function for blocks in which all words of one operand are machine zeros.
 * first: the result if the zeros are the first operand. second: the result if they are
 * the second operand. */
#define ZEROS_BLOCK(name, first, second) \
    LANEWISE bool name BLOCK_PARAMETERS \
    { \
        return block_of_zeros(to, a, b, n, first, flags) \
               || block_of_zeros(to, b, a, n, second, flags); \
    }
#define COMMON_BLOCK(name, of_common) \
    LANEWISE bool name BLOCK_PARAMETERS \
    { \
        (void)flags; \
        if (!common_pairs(a, b, n)) \
            return false; \
        EACH_LANE(to[j] = of_common(a[j], b[j])); \
        return true; \
    }

/* Defines a function that calls the block function `one`. If `one` returns false, it
 * calls `other`. */
#define EITHER_BLOCK(name, one, other) \
    LANEWISE bool name BLOCK_PARAMETERS \
    { \
        return one(to, a, b, n, flags) || other(to, a, b, n, flags); \
    }

#endif
