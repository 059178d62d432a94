/* host.h - compiles vectorised loops once for each vector unit. Every call uses the
 * best version that the host supports.
 */
#ifndef C205_HOST_H
#define C205_HOST_H

#include <stdbool.h>

/* The vector units of hosts. Code on lanes is faster only if the vector unit can shift
 * each lane by its own count. HOST_LANES is the vector unit that the compiler targets.
 * HOST_WORDS processes words one by one. */
enum host_vectors { HOST_WORDS, HOST_LANES, HOST_AVX2, HOST_AVX512 };

#if defined(__x86_64__) && defined(__GNUC__)
#define HOST_VERSIONS
#define AVX2_FEATURES "avx2,bmi,bmi2"
#define AVX512_FEATURES AVX2_FEATURES ",avx512f,avx512bw,avx512cd,avx512dq,avx512vl"
#endif

static inline enum host_vectors host_vectors(void)
{
#if defined(HOST_VECTORS) /* for tests: selects the vector unit */
    return HOST_VECTORS;
#elif defined(HOST_VERSIONS)
    if (__builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd")
        && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
        return HOST_AVX512;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2"))
        return HOST_AVX2;
    return HOST_WORDS;
#elif defined(__aarch64__)
    return HOST_LANES;
#else
    return HOST_WORDS;
#endif
}

/* VERSIONS(NAME, ..) defines a function that calls the version of NAME_span for the
 * vector unit of the host, or PLAIN if the host has none. PLAIN may be NAME_span
 * too. */
#ifdef HOST_VERSIONS
#define LANEWISE static inline __attribute__((always_inline))
#define VERSION(attribute, version, of, parameters, arguments) \
    __attribute__((attribute)) static void version parameters \
    { \
        of arguments; \
    }
#define VERSIONS(name, plain, parameters, arguments) \
    VERSION(noinline, name##_alone, plain, parameters, arguments) \
    VERSION(target(AVX2_FEATURES), name##_avx2, name##_span, parameters, arguments) \
    VERSION(target(AVX512_FEATURES), name##_avx512, name##_span, parameters, \
            arguments) \
    void name parameters \
    { \
        switch (host_vectors()) { \
        case HOST_AVX512: name##_avx512 arguments; break; \
        case HOST_AVX2: name##_avx2 arguments; break; \
        case HOST_LANES: name##_span arguments; break; \
        case HOST_WORDS: name##_alone arguments; break; \
        } \
    }
#else
#define LANEWISE static inline
#define VERSIONS(name, plain, parameters, arguments) \
    void name parameters \
    { \
        if (host_vectors() == HOST_WORDS) \
            plain arguments; \
        else \
            name##_span arguments; \
    }
#endif

/* ---- Rounding of doubles --------------------------------------------------- */

/* A rounding mode of the host. A compiler may move arithmetic across a change of the
 * mode, but not loads and stores. The mode therefore applies to each operation whose
 * operands are loaded and whose result is stored before the next change. */
typedef unsigned host_rounding;

#ifdef HOST_VERSIONS
static inline void host_round_as(host_rounding way)
{
    __asm__ volatile("ldmxcsr %0" : : "m"(way) : "memory");
}

/* Sets the host to round doubles down, and *before to the previous mode. Returns false
 * if the host cannot, for example an emulator that supports one mode only. */
static inline bool host_round_down(host_rounding *before)
{
    host_rounding ways = 3U << 13, down = 1U << 13, untrapped = 0x3FU << 7;
    volatile double little = 0x1p-60;
    __asm__ volatile("stmxcsr %0" : "=m"(*before) : : "memory");
    host_round_as((*before & ~ways) | down | untrapped);
    if (1 - little < 1)
        return true;
    host_round_as(*before);
    return false;
}
#else
static inline void host_round_as(host_rounding way)
{
    (void)way;
}

static inline bool host_round_down(host_rounding *before)
{
    *before = 0;
    return false;
}
#endif

#endif
