/* spans.h - how a loop over a span of words is compiled and walked; for the
 * files that hold the functions of lanes.h.
 */
#ifndef C205_SPANS_H
#define C205_SPANS_H

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
    (c205_word *restrict c, const c205_word *restrict a, \
     const c205_word *restrict b, size_t n, uint64_t *restrict flags)
#define UNARY_PARAMETERS \
    (c205_word *restrict c, const c205_word *restrict a, size_t n, \
     uint64_t *restrict flags)

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
 * was not right, that one is done again by the exact rule. */
enum { BLOCK = 512 };
#define SPAN(name, parameters, of_lane, exactly) \
    CLONED void name parameters \
    { \
        uint64_t odd[BLOCK]; \
        for (size_t i = 0; i < n; i += BLOCK) { \
            size_t end = i + lesser(n - i, BLOCK); \
            uint64_t odds = 0, zeros = 0; \
            for (size_t j = i; j < end; j++) { \
                lane result = of_lane; \
                odd[j - i] = result.odd; \
                odds |= result.odd; \
                zeros |= result.zero; \
                c[j] = result.word; \
            } \
            if (odds >> 63) \
                exactly; \
            else if (zeros >> 63) \
                *flags |= FLAG_MACHINE_ZERO; \
        } \
    }
#define BINARY_SPAN(name, lane_function, exact) \
    SPAN(name, BINARY_PARAMETERS, lane_function(a[j], b[j]), \
         binary_again(exact, c + i, a + i, b + i, odd, end - i, flags))
#define UNARY_SPAN(name, lane_function, exact) \
    SPAN(name, UNARY_PARAMETERS, lane_function(a[j]), \
         unary_again(exact, c + i, a + i, odd, end - i, flags))

/* What is rare has no fast path: word by word. */
#define EXACT(name, exact) \
    void name BINARY_PARAMETERS \
    { \
        for (size_t i = 0; i < n; i++) \
            c[i] = exact(a[i], b[i], flags); \
    }

#endif
