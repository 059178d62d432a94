/* spans.h - how a loop over a span of words is compiled and walked; for the
 * files that hold the functions of lanes.h.
 */
#ifndef C205_SPANS_H
#define C205_SPANS_H

#include "lanes.h"

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

#define BINARY_PARAMETERS                                                  \
    (c205_word *restrict c, const c205_word *restrict a,                   \
     const c205_word *restrict b, size_t n, uint64_t *restrict flags)
#define UNARY_PARAMETERS                                                   \
    (c205_word *restrict c, const c205_word *restrict a, size_t n,         \
     uint64_t *restrict flags)

static inline size_t lesser(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Word by word. */
static inline void binary_exactly(arith_binary *exact, c205_word *c,
                                  const c205_word *a, const c205_word *b,
                                  size_t n, uint64_t *flags)
{
    for (size_t i = 0; i < n; i++)
        c[i] = exact(a[i], b[i], flags);
}

static inline void unary_exactly(arith_unary *exact, c205_word *c,
                                 const c205_word *a, size_t n,
                                 uint64_t *flags)
{
    for (size_t i = 0; i < n; i++)
        c[i] = exact(a[i], flags);
}

/* A span of lanes (lane_parts.h), block by block; a block with a lane that
 * was not right is done again by the exact rule. */
enum { BLOCK = 128 };
#define SPAN(name, parameters, of_lane, exactly)                           \
    CLONED void name parameters                                            \
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
#define BINARY_SPAN(name, lane_function, exact)                            \
    SPAN(name, BINARY_PARAMETERS, lane_function(a[j], b[j]),               \
         binary_exactly(exact, c + i, a + i, b + i, end - i, flags))
#define UNARY_SPAN(name, lane_function, exact)                             \
    SPAN(name, UNARY_PARAMETERS, lane_function(a[j]),                      \
         unary_exactly(exact, c + i, a + i, end - i, flags))

/* What is rare has no fast path. */
#define EXACT(name, exact)                                                 \
    void name BINARY_PARAMETERS                                            \
    {                                                                      \
        binary_exactly(exact, c, a, b, n, flags);                          \
    }

#endif
