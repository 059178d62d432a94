/* bench_lanes.c - host nanoseconds per element of the machine's arithmetic,
 * beside the same loop in plain doubles. */
#include "tests/random.h"
#include "vm/lanes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { LENGTH = 4096, REPEATS = 2000, TRIALS = 7 };

static c205_word a[LENGTH], b[LENGTH], c[LENGTH];
static double x[LENGTH], y[LENGTH], z[LENGTH];
static volatile double sink;

static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static void fill(void)
{
    uint64_t state = RANDOM_SEED;

    for (size_t i = 0; i < LENGTH; i++) {
        a[i] = xorshift_normalised(&state, -60, -40);
        b[i] = xorshift_normalised(&state, -60, -40);
        if (i % 8 == 3)
            b[i] = C205_MACHINE_ZERO;
        x[i] = c205_to_double(a[i]);
        y[i] = c205_to_double(b[i]);
    }
}

/* Divisors without zeros, radicands without signs. */
static void make_divisible(void)
{
    uint64_t flags = 0;

    for (size_t i = 0; i < LENGTH; i++) {
        if (word_is_machine_zero(b[i]))
            b[i] = C205_ONE;
        a[i] = arith_absolute(a[i], &flags);
        x[i] = fabs(x[i]);
        y[i] = c205_to_double(b[i]);
    }
}

typedef void task(void);

static double nanoseconds(task *run)
{
    double best = HUGE_VAL;

    for (int trial = 0; trial < TRIALS; trial++) {
        const double start = now();
        for (int i = 0; i < REPEATS; i++)
            run();
        const double each = (now() - start) / REPEATS / LENGTH;
        best = each < best ? each : best;
    }
    sink = z[LENGTH / 2];
    return best;
}

#define TASK(name, lanes, doubles)                                         \
    static void name##_lanes(void)                                         \
    {                                                                      \
        uint64_t flags = 0;                                                \
        lanes;                                                             \
    }                                                                      \
    static void name##_doubles(void)                                       \
    {                                                                      \
        for (size_t i = 0; i < LENGTH; i++)                                \
            z[i] = doubles;                                                \
    }

TASK(add, lanes_add_normalised(c, a, b, LENGTH, &flags), x[i] + y[i])
TASK(subtract, lanes_subtract_normalised(c, a, b, LENGTH, &flags),
     x[i] - y[i])
TASK(add_upper, lanes_add_upper(c, a, b, LENGTH, &flags), x[i] + y[i])
TASK(multiply, lanes_multiply_significant(c, a, b, LENGTH, &flags),
     x[i] * y[i])
TASK(less, lanes_less(c, a, b, LENGTH); (void)flags, x[i] < y[i])
TASK(truncate, lanes_truncate(c, a, LENGTH, &flags), trunc(x[i]))
TASK(sum, c[0] = C205_ONE; lanes_sum(c, a, LENGTH, &flags),
     z[0] = z[0] + x[i])
TASK(divide, lanes_divide_significant(c, a, b, LENGTH, &flags),
     x[i] / y[i])
TASK(square_root, lanes_square_root(c, a, LENGTH, &flags), sqrt(x[i]))

#define EACH_WORD(name, operation)                                         \
    static void name(void)                                                 \
    {                                                                      \
        uint64_t flags = 0;                                                \
        for (size_t i = 0; i < LENGTH; i++)                                \
            c[i] = operation;                                              \
    }
EACH_WORD(add_words, arith_add_normalised(a[i], b[i], &flags))
EACH_WORD(multiply_words, arith_multiply_significant(a[i], b[i], &flags))
EACH_WORD(divide_words, arith_divide_significant(a[i], b[i], &flags))
EACH_WORD(root_words, arith_square_root(a[i], &flags))

static void report(const char *name, task *ours, task *words, task *doubles)
{
    printf("%-24s %8.2f", name, nanoseconds(ours));
    if (words != NULL)
        printf(" %8.2f", nanoseconds(words));
    else
        printf(" %8s", "");
    printf(" %8.2f\n", nanoseconds(doubles));
}

int main(void)
{
    fill();
    printf("%-24s %8s %8s %8s  ns per element\n", "", "lanes", "words",
           "double");
    report("add normalised", add_lanes, add_words, add_doubles);
    report("subtract normalised", subtract_lanes, NULL, subtract_doubles);
    report("add upper", add_upper_lanes, NULL, add_upper_doubles);
    report("multiply significant", multiply_lanes, multiply_words,
           multiply_doubles);
    report("less", less_lanes, NULL, less_doubles);
    report("truncate", truncate_lanes, NULL, truncate_doubles);
    report("sum", sum_lanes, NULL, sum_doubles);
    make_divisible();
    report("divide significant", divide_lanes, divide_words, divide_doubles);
    report("square root", square_root_lanes, root_words,
           square_root_doubles);
    return 0;
}
