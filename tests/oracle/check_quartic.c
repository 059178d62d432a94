/* check_quartic.c - the machine's roots against exact ones.
 *
 *     check_quartic [--seed N] [--falsi RULE] [polynomials of each kind]
 *     check_quartic [--seed N] --print KIND [polynomials]
 *
 * The second form prints polynomials for rt205 quartic.  The first checks; the
 * polynomials are taken as they are stored, in words of 47 bits.  The rule
 * (docs/quartic.md), with islands as islands.h has them:
 *
 *   1. every root found lies on an island
 *   2. on an island with n different roots above the bound, 1 to n are found;
 *      so where there is one, one.  It may be one more for each pair of
 *      complex roots too near to be told from a double root: where f' has more
 *      roots there than lie between and at those of f, or where f'' has one and
 *      the island is wider than 1e-5 of the root.
 *   3. on the island of the bound a root may be missed; a root that is the
 *      bound itself is not found
 *   4. where the island is narrower than 1e-10 of the root, the error is too
 *   5. t = 0 is found if and only if the last coefficient is 0 and the bound
 *      below 0
 *   6. scalar and vector form, with queues of any length, find the same, bit
 *      for bit; so does the search for the first root
 */
#include "arithmetic_oracle.h"
#include "islands.h"
#include "quartic_cases.h"
#include "tests/random.h"

#include <getopt.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POLYNOMIALS = 600, SHOWN_MOST = 20 };
#define ERROR_MOST 1e-10
#define CLUSTER_LEAST 1e-5

/* Results of one kind. */
struct tally {
    unsigned long polynomials, roots, sharp, joined, touched, at_bound;
    unsigned long wrong;
    double error; /* the largest relative one of a sharp root */
};

static unsigned long shown;

static void show(const struct polynomial *polynomial,
                 const struct polynomial_roots *roots, const char *why)
{
    char text[C205_TEXT_SIZE];

    if (shown++ >= SHOWN_MOST)
        return;
    printf("%s:\n   ", why);
    for (int i = 0; i < 5; i++) {
        c205_to_text(polynomial->c[i], text);
        printf("%s,", text);
    }
    c205_to_text(polynomial->bound, text);
    printf("%s\n    found", text);
    for (int i = 0; i < roots->count; i++) {
        c205_to_text(roots->root[i], text);
        printf(" %s", text);
    }
    putchar('\n');
}

/* ---- One polynomial on one side of zero --------------------------------- */

/* What is looked at: t = side x, x > 0. */
struct half {
    const struct polynomial *polynomial;
    const struct polynomial_roots *roots;
    int side; /* 1, -1 */
    mpfr_t c[EXACT_DEGREE + 1], slope[EXACT_DEGREE];
    mpfr_t curvature[EXACT_DEGREE - 1];
    mpfr_t bound, low, high, found, error;
    struct exact_roots exact, knots, bends; /* of f, f', f'' */
    struct islands islands;
};

static void half_init(struct half *half)
{
    for (int i = 0; i <= EXACT_DEGREE; i++)
        mpfr_init2(half->c[i], EXACT_BITS);
    for (int i = 0; i < EXACT_DEGREE; i++)
        mpfr_init2(half->slope[i], EXACT_BITS);
    for (int i = 0; i < EXACT_DEGREE - 1; i++)
        mpfr_init2(half->curvature[i], EXACT_BITS);
    mpfr_inits2(EXACT_BITS, half->bound, half->low, half->high, half->found,
                half->error, (mpfr_ptr)NULL);
    exact_init(&half->exact);
    exact_init(&half->knots);
    exact_init(&half->bends);
    islands_init(&half->islands);
}

static void half_clear(struct half *half)
{
    for (int i = 0; i <= EXACT_DEGREE; i++)
        mpfr_clear(half->c[i]);
    for (int i = 0; i < EXACT_DEGREE; i++)
        mpfr_clear(half->slope[i]);
    for (int i = 0; i < EXACT_DEGREE - 1; i++)
        mpfr_clear(half->curvature[i]);
    mpfr_clears(half->bound, half->low, half->high, half->found, half->error,
                (mpfr_ptr)NULL);
    exact_clear(&half->exact);
    exact_clear(&half->knots);
    exact_clear(&half->bends);
    islands_clear(&half->islands);
}

static void half_take(struct half *half, const struct polynomial *polynomial,
                      const struct polynomial_roots *roots, int side)
{
    half->polynomial = polynomial;
    half->roots = roots;
    half->side = side;
    for (int i = 0; i <= EXACT_DEGREE; i++) {
        oracle_value(&oracle_full, half->c[i],
                     polynomial->c[EXACT_DEGREE - i]);
        if (side < 0 && i % 2 == 1)
            mpfr_neg(half->c[i], half->c[i], MPFR_RNDN);
    }
    oracle_value(&oracle_full, half->bound, polynomial->bound);
    mpfr_mul_si(half->bound, half->bound, side, MPFR_RNDN);
    for (int i = 0; i < EXACT_DEGREE; i++)
        mpfr_mul_si(half->slope[i], half->c[i + 1], i + 1, MPFR_RNDN);
    for (int i = 0; i < EXACT_DEGREE - 1; i++)
        mpfr_mul_si(half->curvature[i], half->slope[i + 1], i + 1, MPFR_RNDN);
    exact_positive_roots(&half->exact, half->c, EXACT_DEGREE);
    exact_positive_roots(&half->knots, half->slope, EXACT_DEGREE - 1);
    exact_positive_roots(&half->bends, half->curvature, EXACT_DEGREE - 2);
    islands_find(&half->islands, half->c, EXACT_DEGREE);
}

/* Is x on this side above the bound? */
static bool is_above(const struct half *half, const mpfr_t x)
{
    int order = mpfr_cmp(x, half->bound);

    return half->side > 0 ? order > 0 : order < 0;
}

static bool is_between(const mpfr_t x, const mpfr_t low, const mpfr_t high)
{
    return mpfr_lessequal_p(low, x) && mpfr_lessequal_p(x, high);
}

/* A little around the island: the last bits of its root. */
static void take_shores(struct half *half, const struct island *island)
{
    mpfr_mul_d(half->low, island->low, 1 - 0x1p-40, MPFR_RNDD);
    mpfr_mul_d(half->high, island->high, 1 + 0x1p-40, MPFR_RNDU);
}

static int count_found(struct half *half)
{
    int count = 0;

    for (int i = 0; i < half->roots->count; i++) {
        oracle_value(&oracle_full, half->found, half->roots->root[i]);
        mpfr_mul_si(half->found, half->found, half->side, MPFR_RNDN);
        count += is_between(half->found, half->low, half->high);
    }
    return count;
}

/* Relative to the exact root i; half->found is the last one looked at. */
static double relative_error(struct half *half, size_t i)
{
    mpfr_sub(half->error, half->found, half->exact.x[i], MPFR_RNDN);
    mpfr_div(half->error, half->error, half->exact.x[i], MPFR_RNDN);
    return mpfr_get_d(half->error, MPFR_RNDN);
}

static double error_of_only_root(struct half *half, size_t exact)
{
    for (int i = 0; i < half->roots->count; i++) {
        oracle_value(&oracle_full, half->found, half->roots->root[i]);
        mpfr_mul_si(half->found, half->found, half->side, MPFR_RNDN);
        if (is_between(half->found, half->low, half->high))
            break;
    }
    double error = relative_error(half, exact);
    return error < 0 ? -error : error;
}

static bool is_narrower(struct half *half, const struct island *island,
                        double width)
{
    mpfr_sub(half->error, island->high, island->low, MPFR_RNDU);
    mpfr_div(half->error, half->error, island->low, MPFR_RNDU);
    return mpfr_cmp_d(half->error, width) < 0;
}

/* What is known exactly of an island, as take_shores has left it. */
struct facts {
    int roots, multiple; /* on it; a multiple root is a knot as well */
    int knots, bends;    /* roots of f' and f'' on it */
    int above, at_bound;        /* roots above the bound, roots there */
    size_t root;                /* one of those above */
    bool bounded;               /* the bound lies on it */
};

static struct facts find_facts(const struct half *half)
{
    struct facts facts = { 0 };

    facts.bounded = is_between(half->bound, half->low, half->high);
    for (size_t i = 0; i < half->knots.count; i++)
        facts.knots += is_between(half->knots.x[i], half->low, half->high);
    for (size_t i = 0; i < half->bends.count; i++)
        facts.bends += is_between(half->bends.x[i], half->low, half->high);
    for (size_t i = 0; i < half->exact.count; i++) {
        if (!is_between(half->exact.x[i], half->low, half->high))
            continue;
        facts.roots++;
        facts.multiple += half->exact.multiple[i];
        facts.at_bound += mpfr_equal_p(half->exact.x[i], half->bound) != 0;
        if (is_above(half, half->exact.x[i])) {
            facts.above++;
            facts.root = i;
        }
    }
    return facts;
}

/* Between n roots, multiple ones included, there are n - 1 knots and those
 * that are roots; each pair of complex roots nearby has two more, or one if
 * there is no root.  A bend on a wide island shows one as well: it is that of
 * nearly a triple root. */
static int most_roots(struct half *half, const struct island *island,
                      const struct facts *facts)
{
    int more = facts->knots - (facts->roots - 1 + facts->multiple);
    int pairs = more > 0 ? (more + 1) / 2 : 0;

    if (pairs == 0 && facts->bends > 0
        && !is_narrower(half, island, CLUSTER_LEAST))
        pairs = 1;
    return facts->roots + pairs;
}

static const char *check_count(struct half *half, const struct island *island,
                               const struct facts *facts, int found)
{
    if (facts->at_bound > 0 && facts->above == 0 && found > 0)
        return "the bound itself is found";
    if (found > most_roots(half, island, facts))
        return "too many on an island";
    if (found > 0 && !facts->bounded && !is_above(half, island->low))
        return "a root below the bound";
    if (facts->above > 0 && found == 0 && !facts->bounded)
        return "a root is missed";
    return NULL;
}

static const char *check_island(struct half *half,
                                const struct island *island,
                                struct tally *tally)
{
    struct facts facts;
    const char *why;
    double error;
    int found;

    take_shores(half, island);
    facts = find_facts(half);
    found = count_found(half);
    why = check_count(half, island, &facts, found);
    if (why != NULL)
        return why;
    tally->roots += (unsigned long)facts.above;
    tally->at_bound += facts.bounded && facts.above > found;
    tally->joined += !facts.bounded && facts.above > found;
    tally->touched += facts.above < found;
    if (facts.above != 1 || found != 1 || !is_narrower(half, island, ERROR_MOST))
        return NULL;
    error = error_of_only_root(half, facts.root);
    tally->sharp++;
    if (error > tally->error)
        tally->error = error;
    return error <= ERROR_MOST ? NULL : "not exact enough";
}

static const char *check_half(struct half *half, struct tally *tally)
{
    int on_side = 0, on_islands = 0;

    for (int i = 0; i < half->roots->count; i++) {
        oracle_value(&oracle_full, half->found, half->roots->root[i]);
        on_side += mpfr_sgn(half->found) == half->side;
    }
    for (size_t i = 0; i < half->islands.count; i++) {
        const char *why = check_island(half, &half->islands.island[i],
                                       tally);

        if (why != NULL)
            return why;
        on_islands += count_found(half);
    }
    return on_islands < on_side ? "a root on no island" : NULL;
}

/* ---- One polynomial ----------------------------------------------------- */

/* Ascending, above the bound, and 0 where 0 is a root. */
static const char *check_order(const struct polynomial *polynomial,
                               const struct polynomial_roots *roots)
{
    c205_word last = polynomial->bound;
    uint64_t flags = 0;
    int zeros = 0, wanted = 0;

    if (roots->count < 0)
        return "refused";
    for (int i = 0; i < roots->count; i++) {
        if (!oracle_less(&oracle_full, last, roots->root[i], &flags))
            return "not ascending from the bound";
        last = roots->root[i];
        zeros += (int)oracle_equal(&oracle_full, last, C205_MACHINE_ZERO,
                                   &flags);
    }
    if (oracle_equal(&oracle_full, polynomial->c[4], C205_MACHINE_ZERO,
                     &flags)
        && oracle_less(&oracle_full, polynomial->bound, C205_MACHINE_ZERO,
                       &flags))
        for (int i = 0; i < 4; i++)
            wanted |= polynomial->c[i] != C205_MACHINE_ZERO;
    return zeros != wanted ? "zero" : NULL;
}

static void check_polynomial(struct half *half,
                             const struct polynomial *polynomial,
                             const struct polynomial_roots *roots,
                             struct tally *tally)
{
    const char *why = check_order(polynomial, roots);

    tally->polynomials++;
    for (int side = -1; why == NULL && side <= 1; side += 2) {
        half_take(half, polynomial, roots, side);
        why = check_half(half, tally);
    }
    if (why != NULL) {
        tally->wrong++;
        show(polynomial, roots, why);
    }
}

/* ---- The machine -------------------------------------------------------- */

static void *allocate(size_t count, size_t size)
{
    void *room = calloc(count, size);

    if (room == NULL) {
        fputs("check_quartic: no memory\n", stderr);
        exit(2);
    }
    return room;
}

static void solve(struct polynomial_roots *roots,
                  const struct polynomial *polynomials, size_t count,
                  const struct roots_options *options)
{
    c205_error error = { "" };
    struct root_search *search = roots_new(polynomials, count, options,
                                           &error);

    if (search == NULL || !roots_run(search, &error)
        || !roots_read(search, roots, &error)) {
        fprintf(stderr, "check_quartic: %s\n", error.message);
        exit(2);
    }
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

/* Another way to the same roots: how many polynomials differ. */
static unsigned long compare(const struct polynomial *polynomials,
                             size_t count,
                             const struct polynomial_roots *expected,
                             const struct roots_options *options)
{
    struct polynomial_roots *roots = allocate(count, sizeof *roots);
    unsigned long differ = 0;

    solve(roots, polynomials, count, options);
    for (size_t i = 0; i < count; i++)
        if (!same_roots(&expected[i], &roots[i],
                        options->first ? 1 : ROOTS_MOST)) {
            show(&polynomials[i], &roots[i], "scalar, all");
            show(&polynomials[i], &roots[i], trace_mode_name(options->mode));
            differ++;
        }
    free(roots);
    return differ;
}

static unsigned long compare_ways(const struct polynomial *polynomials,
                                  size_t count,
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

/* ---- All ---------------------------------------------------------------- */

static unsigned long report(const struct tally *tallies)
{
    unsigned long wrong = 0, all = 0, roots = 0;

    printf("%-14s %8s %8s %8s %8s %8s %8s %8s %10s\n", "kind", "polynom.",
           "roots", "sharp", "joined", "touched", "at bound", "wrong",
           "error");
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
    uint64_t seed;
    size_t each;
    enum falsi falsi;
    const char *print; /* a kind, or NULL */
};

static bool parse(int argc, char **argv, struct arguments *arguments)
{
    static const struct option options[] = {
        { "seed", required_argument, NULL, 's' },
        { "falsi", required_argument, NULL, 'f' },
        { "print", required_argument, NULL, 'p' },
        { NULL, 0, NULL, 0 },
    };
    int letter;

    while ((letter = getopt_long(argc, argv, "", options, NULL)) != -1)
        if (letter == 's')
            arguments->seed = strtoull(optarg, NULL, 0);
        else if (letter == 'p')
            arguments->print = optarg;
        else if (letter != 'f' || !falsi_named(optarg, &arguments->falsi))
            return false;
    if (optind < argc)
        arguments->each = strtoul(argv[optind], NULL, 10);
    return arguments->seed != 0 && arguments->each > 0;
}

static int print_kind(const struct arguments *arguments)
{
    enum quartic_kind kind = (enum quartic_kind)0;
    uint64_t state = arguments->seed;

    while (kind < QUARTIC_KINDS
           && strcmp(quartic_kind_name(kind), arguments->print) != 0)
        kind++;
    if (kind == QUARTIC_KINDS) {
        fprintf(stderr, "check_quartic: no such kind: %s\n",
                arguments->print);
        return 2;
    }
    for (size_t i = 0; i < arguments->each; i++) {
        struct polynomial polynomial;
        char text[C205_TEXT_SIZE];

        quartic_case(&polynomial, kind, &state);
        for (int j = 0; j < 5; j++) {
            c205_to_text(polynomial.c[j], text);
            printf("%s,", text);
        }
        c205_to_text(polynomial.bound, text);
        puts(text);
    }
    return 0;
}

static unsigned long check_all(const struct polynomial *polynomials,
                               size_t count,
                               const struct roots_options *options)
{
    struct polynomial_roots *roots = allocate(count, sizeof *roots);
    struct tally tallies[QUARTIC_KINDS] = { { 0 } };
    struct half half;
    unsigned long wrong, differ;

    solve(roots, polynomials, count, options);
    half_init(&half);
    for (size_t i = 0; i < count; i++)
        check_polynomial(&half, &polynomials[i], &roots[i],
                         &tallies[i % QUARTIC_KINDS]);
    half_clear(&half);
    wrong = report(tallies);
    differ = compare_ways(polynomials, count, roots, options);
    printf("%lu polynomials differ between the forms\n", differ);
    printf("%lu passed, %lu failed\n",
           2 * (unsigned long)count - wrong - differ, wrong + differ);
    free(roots);
    return wrong + differ;
}

static int check(const struct arguments *arguments)
{
    size_t count = arguments->each * QUARTIC_KINDS;
    struct polynomial *polynomials = allocate(count, sizeof *polynomials);
    struct roots_options options = { .mode = TRACE_SCALAR, .queue = 1,
                                     .falsi = arguments->falsi };
    uint64_t state = arguments->seed;
    unsigned long failed;
    c205_error error;
    c205_model *model = c205_model_find("cyber205-2pipe", &error);

    if (model == NULL) {
        fprintf(stderr, "check_quartic: %s\n", error.message);
        return 2;
    }
    options.model = model;
    for (size_t i = 0; i < count; i++)
        quartic_case(&polynomials[i],
                     (enum quartic_kind)(i % QUARTIC_KINDS), &state);
    failed = check_all(polynomials, count, &options);
    free(polynomials);
    c205_model_free(model);
    return failed > 0;
}

int main(int argc, char **argv)
{
    struct arguments arguments = { RANDOM_SEED, POLYNOMIALS, FALSI_DEFAULT,
                                   NULL };
    int code;

    if (!parse(argc, argv, &arguments)) {
        fputs("check_quartic [--seed N] [--falsi RULE] [--print KIND] "
              "[polynomials]\n", stderr);
        return 2;
    }
    oracle_begin();
    code = arguments.print != NULL ? print_kind(&arguments)
                                   : check(&arguments);
    oracle_end();
    mpfr_free_cache();
    return code;
}
