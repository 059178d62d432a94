/* check_quartic.c - compares the machine's roots of polynomials with exact ones.
 *
 *     check_quartic [--seed N] [--falsi RULE] [polynomials of each kind]
 *     check_quartic [--seed N] --print KIND [polynomials]
 *
 * The first form tests random polynomials of each kind. The roots must obey
 * quartic_rule.h. The scalar form, the vector form with any queue length and the search
 * for the first root must give the same roots bit for bit. The second form prints
 * polynomials for rt205 quartic.
 */
#include "arithmetic_oracle.h"
#include "quartic_rule.h"
#include "tests/oracle/give_up.h"
#include "tests/oracle/read_options.h"
#include "tests/oracle/solid_text.h"
#include "tests/random.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POLYNOMIALS = 600, MAX_SHOWN = 20 };

static unsigned long shown;

static void print_polynomial(const struct polynomial *polynomial)
{
    char text[C205_TEXT_SIZE];
    for (int i = 0; i < 5; i++) {
        c205_to_text(polynomial->c[i], text);
        printf("%s,", text);
    }
    c205_to_text(polynomial->bound, text);
    fputs(text, stdout);
}

static void show(const struct polynomial *polynomial,
                 const struct polynomial_roots *roots, const char *why)
{
    char text[C205_TEXT_SIZE];
    if (shown++ >= MAX_SHOWN)
        return;
    printf("%s:\n   ", why);
    print_polynomial(polynomial);
    printf("\n    found");
    for (int i = 0; i < roots->count; i++) {
        c205_to_text(roots->root[i], text);
        printf(" %s", text);
    }
    putchar('\n');
}

/* ---- The machine -------------------------------------------------------- */

static void solve(struct polynomial_roots *roots, const struct polynomial *polynomials,
                  size_t count, const struct roots_options *options)
{
    struct root_search *search = roots_new(polynomials, count, options, &last_error);
    need(search && roots_run(search, &last_error)
         && roots_read(search, roots, &last_error));
    roots_free(search);
}

static bool same_roots(const struct polynomial_roots *a,
                       const struct polynomial_roots *b, int most)
{
    int count = a->count < most ? a->count : most;
    if (count != b->count)
        return false;
    for (int i = 0; i < count; i++)
        if (a->root[i] != b->root[i])
            return false;
    return true;
}

/* Computes the roots with other options. Returns the number of differences. */
static unsigned long compare(const struct polynomial *polynomials, size_t count,
                             const struct polynomial_roots *expected,
                             const struct roots_options *options)
{
    FREED struct polynomial_roots *roots = test_room(count * sizeof *roots);
    unsigned long differ = 0;
    solve(roots, polynomials, count, options);
    for (size_t i = 0; i < count; i++)
        if (!same_roots(&expected[i], &roots[i], options->first ? 1 : MAX_ROOTS)) {
            show(&polynomials[i], &roots[i], "scalar, all");
            show(&polynomials[i], &roots[i], trace_mode_name(options->mode));
            differ++;
        }
    return differ;
}

static unsigned long compare_ways(const struct polynomial *polynomials, size_t count,
                                  const struct polynomial_roots *expected,
                                  const struct roots_options *options)
{
    static const size_t queues[] = { 1, 7, 100, 2000 };
    struct roots_options other = *options;
    unsigned long differ = 0;
    for (int first = 0; first <= 1; first++) {
        other.first = first != 0;
        other.mode = TRACE_SCALAR;
        if (first)
            differ += compare(polynomials, count, expected, &other);
        other.mode = TRACE_VECTOR;
        for (size_t i = 0; i < sizeof queues / sizeof *queues; i++) {
            other.queue = queues[i];
            differ += compare(polynomials, queues[i] == 1 ? count / 10 : count,
                              expected, &other);
        }
    }
    return differ;
}

/* ---- The report --------------------------------------------------------- */

static unsigned long report(const struct tally *tallies)
{
    unsigned long wrong = 0, all = 0, roots = 0;
    printf("%-14s %8s %8s %8s %8s %8s %8s %8s %10s\n", "kind", "polynom.", "roots",
           "sharp", "joined", "touched", "at bound", "wrong", "error");
    for (int kind = 0; kind < QUARTIC_KINDS; kind++) {
        const struct tally *tally = &tallies[kind];
        printf("%-14s %8lu %8lu %8lu %8lu %8lu %8lu %8lu %10.2g\n",
               quartic_kind_name((enum quartic_kind)kind), tally->polynomials,
               tally->roots, tally->sharp, tally->joined, tally->touched,
               tally->at_bound, tally->wrong, tally->error);
        wrong += tally->wrong;
        all += tally->polynomials;
        roots += tally->roots;
    }
    printf("%lu polynomials with %lu roots above their bounds\n", all, roots);
    return wrong;
}

struct arguments {
    uint64_t seed, each;
    enum falsi falsi;
    const char *print; /* the kind to print, or NULL */
};

static int print_kind(const struct arguments *arguments)
{
    enum quartic_kind kind = (enum quartic_kind)0;
    uint64_t state = arguments->seed;
    while (kind < QUARTIC_KINDS
           && strcmp(quartic_kind_name(kind), arguments->print) != 0)
        kind++;
    if (kind == QUARTIC_KINDS) {
        fprintf(stderr, "check_quartic: no such kind: %s\n", arguments->print);
        return 2;
    }
    for (size_t i = 0; i < arguments->each; i++) {
        struct polynomial polynomial;
        quartic_case(&polynomial, kind, &state);
        print_polynomial(&polynomial);
        putchar('\n');
    }
    return 0;
}

static unsigned long check_all(const struct polynomial *polynomials, size_t count,
                               const struct roots_options *options)
{
    FREED struct polynomial_roots *roots = test_room(count * sizeof *roots);
    struct tally tallies[QUARTIC_KINDS] = { { 0 } };
    struct half half;
    unsigned long wrong, differ;
    solve(roots, polynomials, count, options);
    half_init(&half);
    for (size_t i = 0; i < count; i++) {
        const char *why = quartic_rule(&half, &polynomials[i], &roots[i],
                                       &tallies[i % QUARTIC_KINDS]);
        if (why)
            show(&polynomials[i], &roots[i], why);
    }
    half_clear(&half);
    wrong = report(tallies);
    differ = compare_ways(polynomials, count, roots, options);
    printf("%lu polynomials differ between the forms\n", differ);
    printf("%lu passed, %lu failed\n", 2 * (unsigned long)count - wrong - differ,
           wrong + differ);
    return wrong + differ;
}

static int check(const struct arguments *arguments)
{
    size_t count = arguments->each * QUARTIC_KINDS;
    FREED struct polynomial *polynomials = test_room(count * sizeof *polynomials);
    struct roots_options options = { .mode = TRACE_SCALAR,
                                     .queue = 1,
                                     .falsi = arguments->falsi };
    uint64_t state = arguments->seed;
    SCOPED(c205_model) *model = NEEDED(
        c205_model_find("cyber205-2pipe-prior", &last_error));
    options.model = model;
    for (size_t i = 0; i < count; i++)
        quartic_case(&polynomials[i], (enum quartic_kind)(i % QUARTIC_KINDS), &state);
    unsigned long failed = check_all(polynomials, count, &options);
    return failed > 0;
}

int main(int argc, char **argv)
{
    struct arguments arguments = { RANDOM_SEED, POLYNOMIALS, FALSI_DEFAULT, NULL };
    const char *falsi = NULL;
    const struct check_option options[] = {
        { .name = "seed", .number = &arguments.seed },
        { .name = "falsi", .text = &falsi },
        { .name = "print", .text = &arguments.print },
        { .number = &arguments.each },
    };
    READ_OPTIONS(argc, argv,
                 "check_quartic [--seed N] [--falsi RULE] [--print KIND] [polynomials]",
                 options);
    if (arguments.seed == 0 || arguments.each == 0
        || (falsi && !falsi_named(falsi, &arguments.falsi)))
        give_up("wrong arguments");
    oracle_begin();
    int code = arguments.print ? print_kind(&arguments) : check(&arguments);
    oracle_end();
    mpfr_free_cache();
    return code;
}
