/* spans.h - how a loop over a span of words is compiled and walked; for the
 * files that hold the functions of lanes.h.
 */
#ifndef C205_SPANS_H
#define C205_SPANS_H

#include "vm/number/lane_kinds.h"
#include "vm/number/lanes.h"

/* Whole spans are compiled several times, for what the host's vector unit
 * can do; the loader chooses.  Only gcc on ELF systems with glibc has this
 * in a form that links across files. */
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) \
    && !defined(__clang__) && !defined(NO_TARGET_CLONES)
#define CLONED \
    __attribute__(( \
        target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define CLONED
#endif

#define BINARY_PARAMETERS \
    (c205_word * c, const c205_word *a, const c205_word *b, size_t n, \
     uint64_t *flags)
#define UNARY_PARAMETERS \
    (c205_word * c, const c205_word *a, size_t n, uint64_t *flags)

static inline size_t lesser(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Where the first bit of odd is 1, by the exact rule; the others are right,
 * and raise the flag of their zeros. */
static inline void binary_again(arith_binary *exact, c205_word *c,
                                const c205_word *a, const c205_word *b,
                                const uint64_t *odd, size_t n,
                                uint64_t *flags)
{
    for (size_t i = 0; i < n; i++)
        if (odd[i] >> 63)
            c[i] = exact(a[i], b[i], flags);
        else if (word_is_machine_zero(c[i]))
            *flags |= FLAG_MACHINE_ZERO;
}

static inline void unary_again(arith_unary *exact, c205_word *c,
                               const c205_word *a, const uint64_t *odd,
                               size_t n, uint64_t *flags)
{
    for (size_t i = 0; i < n; i++)
        if (odd[i] >> 63)
            c[i] = exact(a[i], flags);
        else if (word_is_machine_zero(c[i]))
            *flags |= FLAG_MACHINE_ZERO;
}

/* A span of lanes (lane_parts.h), block by block; in a block with a lane that
 * was not right, that one is done again by the exact rule.
 *
 * A result that lies upon an operand is made elsewhere, so that a block is
 * read before it is stored.  What a vector unit takes at once are so many
 * LANES, and all loops take whole ones: the last ones of a block overlap those
 * before, and fewer than that are done with others behind them. */
enum { BLOCK = 256, LANES = 8 };

static inline bool spans_meet(const c205_word *one, const c205_word *other,
                              size_t n)
{
    uintptr_t a = (uintptr_t)one, b = (uintptr_t)other;

    return a - b < n * sizeof *one || b - a < n * sizeof *one;
}

static inline void copy_block(c205_word *to, const c205_word *from, size_t n)
{
    memcpy(to, from, n * sizeof *to);
}

/* n words, 1 to LANES of them, and the first again behind them. */
static inline void fill_lanes(c205_word *lanes, const c205_word *words,
                              size_t n)
{
    for (size_t i = 0; i < LANES; i++)
        lanes[i] = words[0];
    for (size_t i = 1; i < n; i++)
        lanes[i] = words[i];
}

/* Whole lanes, and again the last LANES of n. */
#define EACH_LANE(of_lane) \
    for (size_t i = 0, end = n & ~(size_t)(LANES - 1);;) { \
        for (size_t j = i; j < end; j++) { \
            lane result = of_lane; \
            odd[j] = result.odd; \
            odds |= result.odd; \
            zeros |= zero(result.word); \
            to[j] = result.word; \
        } \
        if (end == n) \
            break; \
        i = n - LANES; \
        end = n; \
    }
#define BLOCK_OF(name, parameters, of_lane, exactly) \
    static inline void name##_block parameters \
    { \
        uint64_t odd[BLOCK], odds = 0, zeros = 0; \
        EACH_LANE(of_lane) \
        if (odds >> 63) \
            exactly; \
        else if (zeros >> 63) \
            *flags |= FLAG_MACHINE_ZERO; \
    }
#define BINARY_SPAN(name, lane_function, exact) \
    BLOCK_OF(name, \
             (c205_word *restrict to, const c205_word *a, \
              const c205_word *b, size_t n, uint64_t *flags), \
             lane_function(a[j], b[j]), \
             binary_again(exact, to, a, b, odd, n, flags)) \
    CLONED void name BINARY_PARAMETERS \
    { \
        c205_word space[BLOCK], some_a[LANES], some_b[LANES]; \
        bool apart = !spans_meet(c, a, n) && !spans_meet(c, b, n); \
        for (size_t i = 0, length; i < n; i += length) { \
            const c205_word *x = a + i, *y = b + i; \
            length = lesser(n - i, BLOCK); \
            bool few = length < LANES; \
            if (few) { \
                fill_lanes(some_a, x, length); \
                fill_lanes(some_b, y, length); \
                x = some_a; \
                y = some_b; \
            } \
            name##_block(apart && !few ? c + i : space, x, y, \
                         few ? LANES : length, flags); \
            if (few || !apart) \
                copy_block(c + i, space, length); \
        } \
    }
#define UNARY_SPAN(name, lane_function, exact) \
    BLOCK_OF(name, \
             (c205_word *restrict to, const c205_word *a, size_t n, \
              uint64_t *flags), \
             lane_function(a[j]), unary_again(exact, to, a, odd, n, flags)) \
    CLONED void name UNARY_PARAMETERS \
    { \
        c205_word space[BLOCK], some_a[LANES]; \
        bool apart = !spans_meet(c, a, n); \
        for (size_t i = 0, length; i < n; i += length) { \
            const c205_word *x = a + i; \
            length = lesser(n - i, BLOCK); \
            bool few = length < LANES; \
            if (few) { \
                fill_lanes(some_a, x, length); \
                x = some_a; \
            } \
            name##_block(apart && !few ? c + i : space, x, \
                         few ? LANES : length, flags); \
            if (few || !apart) \
                copy_block(c + i, space, length); \
        } \
    }

/* What is rare has no fast path: word by word. */
#define EXACT(name, exact) \
    void name BINARY_PARAMETERS \
    { \
        for (size_t i = 0; i < n; i++) \
            c[i] = exact(a[i], b[i], flags); \
    }

#endif
