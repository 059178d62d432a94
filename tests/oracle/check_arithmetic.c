/* check_arithmetic.c - compares the machine's arithmetic with the oracle's.
 *
 *     check_arithmetic [--seed N] [--operation NAME] [cases]
 *
 * Each operation is computed in three ways for the same random operands: by arith.h for
 * single pairs, by lanes.h for spans, and by the oracle. The test fails if a word or a
 * flag differs, and prints the first such case.
 */
#include "arithmetic_oracle.h"
#include "operands.h"
#include "operations.h"
#include "tests/oracle/give_up.h"
#include "tests/oracle/read_options.h"
#include "vm/number/lanes.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

/* ---- One operation ------------------------------------------------------ */

/* No operation sets or clears this flag, so it must still be set afterwards. */
#define EARLIER_FLAG UINT64_C(1)

struct outcome {
    c205_word word;
    uint64_t flags;
};

static bool same(struct outcome a, struct outcome b)
{
    return a.word == b.word && a.flags == b.flags;
}

static struct outcome expect(oracle_rule *rule, const struct oracle_format *format,
                             c205_word a, c205_word b)
{
    struct outcome outcome = { .flags = EARLIER_FLAG };
    outcome.word = rule(format, a, b, &outcome.flags);
    return outcome;
}

static struct outcome apply(scalar_rule *rule, c205_word a, c205_word b)
{
    struct outcome outcome = { .flags = EARLIER_FLAG };
    outcome.word = rule(a, b, &outcome.flags);
    return outcome;
}

static void show_mismatch(const char *room, const char *name, c205_word a, c205_word b,
                          struct outcome expected, struct outcome got)
{
    printf("%s %s %016" PRIX64 " %016" PRIX64 "\n", room, name, a, b);
    printf("    expected %016" PRIX64 " flags %06" PRIX64 "\n", expected.word,
           expected.flags);
    printf("    got      %016" PRIX64 " flags %06" PRIX64 "\n", got.word, got.flags);
}

/* Operands and results of a span. c has one more word, which must not change. */
struct span {
    size_t n;
    c205_word a[SPAN], b[SPAN], c[SPAN + 1];
    struct outcome expected[SPAN];
};

static bool check_scalars(const struct operation *operation, struct span *span)
{
    for (size_t i = 0; i < span->n; i++) {
        c205_word a = span->a[i], b = span->b[i];
        struct outcome expected = expect(operation->expected, operation->format, a, b);
        span->expected[i] = expected;
        if (!operation->scalar)
            continue;
        struct outcome got = apply(operation->scalar, a, b);
        if (!same(expected, got)) {
            show_mismatch("scalar", operation->name, a, b, expected, got);
            return false;
        }
    }
    return true;
}

/* Compares the words of a span, and the union of the flags of its elements. */
static bool check_span(const struct operation *operation, struct span *span)
{
    c205_word guard = UINT64_C(0x0123456789ABCDEF);
    uint64_t flags = EARLIER_FLAG, expected_flags = EARLIER_FLAG;
    span->c[span->n] = guard;
    operation->span(span->c, span->a, span->b, span->n, &flags);
    for (size_t i = 0; i < span->n; i++) {
        const struct outcome got = { span->c[i], span->expected[i].flags };
        expected_flags |= span->expected[i].flags;
        if (!same(span->expected[i], got)) {
            show_mismatch("span", operation->name, span->a[i], span->b[i],
                          span->expected[i], got);
            return false;
        }
    }
    if (flags == expected_flags && span->c[span->n] == guard)
        return true;
    printf("span %s, %zu elements from %016" PRIX64 " %016" PRIX64
           " on: %s\n    expected flags %06" PRIX64 ", got %06" PRIX64 "\n",
           operation->name, span->n, span->a[0], span->b[0],
           span->c[span->n] == guard ? "flags" : "a word past the end", expected_flags,
           flags);
    return false;
}

/* Returns a random length. Short spans detect wrong flags, long ones test loops. */
static size_t span_length(uint64_t *random)
{
    int64_t longest = random_bits(random) % 2 == 0 ? 9 : SPAN;
    return (size_t)random_between(random, 1, longest);
}

/* Checks an operation on single words, and on arrays if it has such a function. */
static bool check_operation(const void *what, struct span *span)
{
    const struct operation *operation = what;
    return check_scalars(operation, span)
           && (!operation->span || check_span(operation, span));
}

/* ---- Reductions, masked stores ------------------------------------------ */

static bool check_reduction(const void *what, struct span *span)
{
    const struct reduction *reduction = what;
    struct outcome expected = { span->b[0], EARLIER_FLAG };
    struct outcome got = expected;
    for (size_t i = 0; i < span->n; i++)
        expected.word = reduction->step(reduction->format, expected.word, span->a[i],
                                        &expected.flags);
    reduction->span(&got.word, span->a, span->n, &got.flags);
    if (same(expected, got))
        return true;
    printf("%zu elements: ", span->n);
    show_mismatch("span", reduction->name, span->b[0], span->a[0], expected, got);
    return false;
}

static bool check_masked_store(const void *random, struct span *span)
{
    uint64_t bits[BITMAP];
    c205_word choice[SPAN];
    for (size_t i = 0; i < BITMAP; i++)
        bits[i] = random_bits((uint64_t *)random);
    spread_bits(choice, bits, span->n);
    memcpy(span->c, span->b, sizeof span->b);
    lanes_store_masked(span->c, span->a, bits, span->n);
    for (size_t i = 0; i < SPAN; i++) {
        bool taken = i < span->n && choice[i] == 1;
        c205_word expected = taken ? span->a[i] : span->b[i];
        if (span->c[i] != expected) {
            show_mismatch("span", "store_masked", span->a[i], span->b[i],
                          (struct outcome){ expected, 0 },
                          (struct outcome){ span->c[i], 0 });
            return false;
        }
    }
    return true;
}

/* ---- The run ------------------------------------------------------------ */

struct run {
    uint64_t seed, cases;
    const char *only; /* NULL: all operations */
    unsigned passed, failed;
};

static bool wanted(const struct run *run, const char *name)
{
    return !run->only || strcmp(run->only, name) == 0;
}

static void count(struct run *run, const char *name, size_t cases, bool pass)
{
    run->passed += pass;
    run->failed += !pass;
    printf("%-28s %9zu %s\n", name, cases, pass ? "ok" : "FAILED");
    fflush(stdout);
}

/* Checks random spans. The masks of stores use the random stream of the lengths. */
static void check_spans(struct run *run, const char *name,
                        const struct oracle_format *format,
                        bool (*check)(const void *what, struct span *span),
                        const void *what)
{
    static struct span span;
    struct operands operands = operands_begin(format, run->seed);
    uint64_t random = ~run->seed;
    bool good = true;
    if (!wanted(run, name))
        return;
    for (size_t done = 0; good && done < run->cases; done += span.n) {
        span.n = span_length(&random);
        operands_next(&operands, span.a, span.b, span.n);
        good = check(what ? what : &random, &span);
    }
    count(run, name, run->cases, good);
}

static void check_everything(struct run *run)
{
    size_t conversion_cases = run->cases / 10;
    for (const struct operation *o = operations; o < operations + operation_count; o++)
        check_spans(run, o->name, o->format, check_operation, o);
    for (const struct reduction *r = reductions; r < reductions + reduction_count; r++)
        check_spans(run, r->name, r->format, check_reduction, r);
    check_spans(run, "store_masked", &oracle_full, check_masked_store, NULL);
    for (size_t i = 0; i < conversion_count; i++)
        if (wanted(run, conversions[i].name))
            count(run, conversions[i].name, conversion_cases,
                  check_conversion(conversions + i, run->seed, conversion_cases));
}

int main(int argc, char **argv)
{
    struct run run = { .seed = 205, .cases = 1000000 };
    const struct check_option options[] = {
        { .name = "seed", .number = &run.seed },
        { .name = "operation", .text = &run.only },
        { .number = &run.cases },
    };
    READ_OPTIONS(argc, argv, "check_arithmetic [--seed N] [--operation NAME] [cases]",
                 options);
    if (run.cases == 0)
        give_up("no cases");
    oracle_begin();
    check_everything(&run);
    oracle_end();
    if (run.passed + run.failed == 0) {
        fprintf(stderr, "check_arithmetic: no operation %s\n", run.only);
        return 2;
    }
    printf("%u passed, %u failed\n", run.passed, run.failed);
    return run.failed == 0 ? 0 : 1;
}
