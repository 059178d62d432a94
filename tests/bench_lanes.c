/* bench_lanes.c - host nanoseconds per element of the machine's arithmetic, on words
 * and half words, compared with the same loop in plain doubles.
 *
 *     bench_lanes [TRIALS]
 */
#include "tests/random.h"
#include "vm/number/lanes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { LENGTH = 4096, REPEATS = 2000 };

static c205_word a[LENGTH], b[LENGTH], c[LENGTH];
static c205_word half_a[LENGTH], half_b[LENGTH];
static double x[LENGTH], y[LENGTH], z[LENGTH];
static volatile double sink;
static int trials = 5;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

/* Copies the values of a and b to the doubles, and truncated to the half words. */
static void share_values(void)
{
    uint64_t flags = 0;
    lanes_contract(half_a, a, LENGTH, &flags);
    lanes_contract(half_b, b, LENGTH, &flags);
    for (size_t i = 0; i < LENGTH; i++) {
        x[i] = c205_to_double(a[i]);
        y[i] = c205_to_double(b[i]);
    }
}

/* Makes one in `each` elements of b a machine zero; 0: none. */
static void fill(size_t each)
{
    uint64_t state = RANDOM_SEED;
    for (size_t i = 0; i < LENGTH; i++) {
        a[i] = xorshift_normalised(&state, -60, -40);
        b[i] = xorshift_normalised(&state, -60, -40);
        if (each > 0 && i % each == each / 2)
            b[i] = C205_MACHINE_ZERO;
    }
    share_values();
}

/* Replaces zero divisors and negative radicands. */
static void make_divisible(void)
{
    uint64_t flags = 0;
    for (size_t i = 0; i < LENGTH; i++) {
        if (word_is_machine_zero(b[i]))
            b[i] = C205_ONE;
        a[i] = arith_absolute(a[i], &flags);
    }
    share_values();
}

typedef void task(void);

static double nanoseconds(task *run)
{
    double best = HUGE_VAL;
    for (int trial = 0; trial < trials; trial++) {
        double start = now();
        for (int i = 0; i < REPEATS; i++)
            run();
        double each = (now() - start) / REPEATS / LENGTH;
        best = each < best ? each : best;
    }
    sink = z[LENGTH / 2];
    return best;
}

/* The compared loops: on words, on half words, in doubles. */
typedef struct thread_pool {
    task *lanes, *halves, *doubles;
} tasks;

#define TASKS(name, of_words, of_halves, of_doubles) \
    static void name##_lanes(void) \
    { \
        uint64_t flags = 0; \
        of_words; \
    } \
    static void name##_halves(void) \
    { \
        uint64_t flags = 0; \
        of_halves; \
    } \
    static void name##_doubles(void) \
    { \
        for (size_t i = 0; i < LENGTH; i++) \
            z[i] = of_doubles; \
    } \
    static const tasks name = { name##_lanes, name##_halves, name##_doubles };

#define BINARY(name, operation, of_doubles) \
    TASKS(name, lanes_##operation(c, a, b, LENGTH, &flags), \
          halves_##operation(c, half_a, half_b, LENGTH, &flags), of_doubles)
#define UNARY(name, operation, of_doubles) \
    TASKS(name, lanes_##operation(c, a, LENGTH, &flags), \
          halves_##operation(c, half_a, LENGTH, &flags), of_doubles)

BINARY(add, add_normalised, x[i] + y[i])
BINARY(subtract, subtract_normalised, x[i] - y[i])
BINARY(add_upper, add_upper, x[i] + y[i])
BINARY(multiply, multiply_significant, x[i] * y[i])
TASKS(less, lanes_less(c, a, b, LENGTH);
      (void)flags, halves_less(c, half_a, half_b, LENGTH); (void)flags, x[i] < y[i])
UNARY(truncate, truncate, trunc(x[i]))
BINARY(divide, divide_significant, x[i] / y[i])
UNARY(square_root, square_root, sqrt(x[i]))
TASKS(convert, lanes_extend(c, half_a, LENGTH, &flags),
      lanes_contract(c, a, LENGTH, &flags), (double)(float)x[i])

#define EACH_WORD(name, operation) \
    static void name(void) \
    { \
        uint64_t flags = 0; \
        for (size_t i = 0; i < LENGTH; i++) \
            c[i] = operation; \
    }
EACH_WORD(add_words, arith_add_normalised(a[i], b[i], &flags))
EACH_WORD(multiply_words, arith_multiply_significant(a[i], b[i], &flags))
EACH_WORD(divide_words, arith_divide_significant(a[i], b[i], &flags))
EACH_WORD(root_words, arith_square_root(a[i], &flags))

static void report(const char *name, const tasks *spans, task *words)
{
    printf("%-24s %8.2f %8.2f", name, nanoseconds(spans->lanes),
           nanoseconds(spans->halves));
    if (words)
        printf(" %8.2f", nanoseconds(words));
    else
        printf(" %8s", "");
    printf(" %8.2f\n", nanoseconds(spans->doubles));
}

int main(int count, char **words)
{
    trials = count > 1 ? atoi(words[1]) : trials;
    fill(8);
    printf("%-24s %8s %8s %8s %8s  ns per element\n", "", "lanes", "halves", "words",
           "double");
    report("add normalised", &add, add_words);
    report("subtract normalised", &subtract, NULL);
    report("add upper", &add_upper, NULL);
    report("multiply significant", &multiply, multiply_words);
    report("less", &less, NULL);
    report("truncate", &truncate, NULL);
    fill(0);
    report("add, no zeros", &add, NULL);
    report("subtract, no zeros", &subtract, NULL);
    report("multiply, no zeros", &multiply, NULL);
    fill(1);
    report("add, all zeros", &add, NULL);
    report("subtract, all zeros", &subtract, NULL);
    report("multiply, all zeros", &multiply, NULL);
    fill(8);
    make_divisible();
    report("divide significant", &divide, divide_words);
    report("square root", &square_root, root_words);
    report("extend, contract", &convert, NULL);
    return 0;
}
