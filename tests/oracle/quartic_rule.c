/* quartic_rule.c - compares roots with exact roots and islands (quartic_rule.h). */
#include "quartic_rule.h"

#include "arithmetic_oracle.h"

#define MAX_ERROR 1e-10
#define MIN_CLUSTER 1e-5

/* ---- One side of zero --------------------------------------------------- */

void half_init(struct half *half)
{
    for (int i = 0; i <= EXACT_DEGREE; i++)
        mpfr_inits2(EXACT_BITS, half->c[i], half->slope[i], half->curvature[i],
                    (mpfr_ptr)NULL);
    mpfr_inits2(EXACT_BITS, half->bound, half->low, half->high, half->found,
                half->error, (mpfr_ptr)NULL);
    exact_init(&half->exact);
    exact_init(&half->knots);
    exact_init(&half->bends);
    islands_init(&half->islands);
}

void half_clear(struct half *half)
{
    for (int i = 0; i <= EXACT_DEGREE; i++)
        mpfr_clears(half->c[i], half->slope[i], half->curvature[i], (mpfr_ptr)NULL);
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
        oracle_value(&oracle_full, half->c[i], polynomial->c[EXACT_DEGREE - i]);
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

/* Returns true if x, on this side of zero, is above the bound. */
static bool is_above(const struct half *half, const mpfr_t x)
{
    int order = mpfr_cmp(x, half->bound);
    return half->side > 0 ? order > 0 : order < 0;
}

static bool is_between(const mpfr_t x, const mpfr_t low, const mpfr_t high)
{
    return mpfr_lessequal_p(low, x) && mpfr_lessequal_p(x, high);
}

/* Sets low and high to the ends of the island, widened by the last bits of its root. */
static void take_shores(struct half *half, const struct island *island)
{
    mpfr_mul_d(half->low, island->low, 1 - 0x1p-40, MPFR_RNDD);
    mpfr_mul_d(half->high, island->high, 1 + 0x1p-40, MPFR_RNDU);
}

/* Sets half->found to a computed root. Returns true if it is on the island. */
static bool take_found(struct half *half, int i)
{
    oracle_value(&oracle_full, half->found, half->roots->root[i]);
    mpfr_mul_si(half->found, half->found, half->side, MPFR_RNDN);
    return is_between(half->found, half->low, half->high);
}

static int count_found(struct half *half)
{
    int count = 0;
    for (int i = 0; i < half->roots->count; i++)
        count += take_found(half, i);
    return count;
}

/* Returns the error of the computed root on the island, relative to an exact root. */
static double error_of_only_root(struct half *half, size_t exact)
{
    for (int i = 0; i < half->roots->count && !take_found(half, i); i++)
        continue;
    mpfr_sub(half->error, half->found, half->exact.x[exact], MPFR_RNDN);
    mpfr_div(half->error, half->error, half->exact.x[exact], MPFR_RNDN);
    double error = mpfr_get_d(half->error, MPFR_RNDN);
    return error < 0 ? -error : error;
}

static bool is_narrower(struct half *half, const struct island *island, double width)
{
    mpfr_sub(half->error, island->high, island->low, MPFR_RNDU);
    mpfr_div(half->error, half->error, island->low, MPFR_RNDU);
    return mpfr_cmp_d(half->error, width) < 0;
}

/* Properties of an island, computed exactly within the ends of take_shores. */
struct facts {
    int roots, multiple; /* number of roots on the island, and of multiple roots, which
                          * are also knots */
    int knots, bends;    /* number of roots of f' and of f'' on the island */
    int above, at_bound; /* number of roots above the bound, and equal to the bound */
    size_t root;         /* index of a root above the bound */
    bool bounded;        /* the bound is on the island */
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

/* Returns the largest number of roots that may be computed on an island. n roots,
 * counted with multiplicity, have n - 1 knots between them; multiple roots are knots,
 * too. A pair of complex roots nearby adds two knots, or one if there is no real root.
 * A bend on a wide island also indicates a pair, as for a root that is nearly
 * triple. */
static int most_roots(struct half *half, const struct island *island,
                      const struct facts *facts)
{
    int more = facts->knots - (facts->roots - 1 + facts->multiple);
    int pairs = more > 0 ? (more + 1) / 2 : 0;
    if (pairs == 0 && facts->bends > 0 && !is_narrower(half, island, MIN_CLUSTER))
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

static const char *check_island(struct half *half, const struct island *island,
                                struct tally *tally)
{
    take_shores(half, island);
    struct facts facts = find_facts(half);
    int found = count_found(half);
    const char *why = check_count(half, island, &facts, found);
    if (why)
        return why;
    tally->roots += (unsigned long)facts.above;
    tally->at_bound += facts.bounded && facts.above > found;
    tally->joined += !facts.bounded && facts.above > found;
    tally->touched += facts.above < found;
    if (facts.above != 1 || found != 1 || !is_narrower(half, island, MAX_ERROR))
        return NULL;
    double error = error_of_only_root(half, facts.root);
    tally->sharp++;
    if (error > tally->error)
        tally->error = error;
    return error <= MAX_ERROR ? NULL : "not exact enough";
}

static const char *check_half(struct half *half, struct tally *tally)
{
    int on_side = 0, on_islands = 0;
    for (int i = 0; i < half->roots->count; i++) {
        oracle_value(&oracle_full, half->found, half->roots->root[i]);
        on_side += mpfr_sgn(half->found) == half->side;
    }
    for (size_t i = 0; i < half->islands.count; i++) {
        const char *why = check_island(half, &half->islands.island[i], tally);
        if (why)
            return why;
        on_islands += count_found(half);
    }
    return on_islands < on_side ? "a root on no island" : NULL;
}

/* ---- One polynomial ----------------------------------------------------- */

/* Checks that the roots ascend, are above the bound, and include 0 if 0 is a root. */
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
        zeros += (int)oracle_equal(&oracle_full, last, C205_MACHINE_ZERO, &flags);
    }
    if (oracle_equal(&oracle_full, polynomial->c[4], C205_MACHINE_ZERO, &flags)
        && oracle_less(&oracle_full, polynomial->bound, C205_MACHINE_ZERO, &flags))
        for (int i = 0; i < 4; i++)
            wanted |= polynomial->c[i] != C205_MACHINE_ZERO;
    return zeros != wanted ? "zero" : NULL;
}

const char *quartic_rule(struct half *half, const struct polynomial *polynomial,
                         const struct polynomial_roots *roots, struct tally *tally)
{
    const char *why = check_order(polynomial, roots);
    tally->polynomials++;
    for (int side = -1; !why && side <= 1; side += 2) {
        half_take(half, polynomial, roots, side);
        why = check_half(half, tally);
    }
    tally->wrong += why != NULL;
    return why;
}
