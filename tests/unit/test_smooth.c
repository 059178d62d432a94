/* test_smooth.c - smoothed factors are compared with the solution of the full system of
 * Lagrange equations in long doubles, over random enclosures, in both forms. A row that
 * does not close, or a wrong weight, fails here. */
#include <math.h>

#include "rt/heat/smooth.h"
#include "tests/random.h"
#include "tests/unit/prior_model.h"

enum { MAX = 12, UNKNOWNS = MAX * (MAX + 1) / 2 + MAX + MAX };

/* Measured flows, their variances and the areas. */
struct found {
    size_t count;
    double areas[MAX], flows[MAX * (MAX + 1)], variances[MAX * (MAX + 1)];
};

static size_t place(const struct found *found, size_t i, size_t j)
{
    return i * (found->count + 1) + j;
}

static void put(struct found *found, size_t i, size_t j, double flow, double variance)
{
    found->flows[place(found, i, j)] = flow;
    found->variances[place(found, i, j)] = variance;
    if (j < found->count) {
        found->flows[place(found, j, i)] = flow;
        found->variances[place(found, j, i)] = variance;
    }
}

/* Makes flows with random errors. Some flows are 0, and some are exact. */
static void draw(struct found *found, uint64_t *random)
{
    memset(found, 0, sizeof *found);
    found->count = 1 + (size_t)xorshift_between(random, 0, MAX - 1);
    for (size_t i = 0; i < found->count; i++)
        for (size_t j = i; j <= found->count; j++) {
            double flow = xorshift(random) % 4 == 0 ? 0 : xorshift_real(random, 0, 1);
            double error = xorshift(random) % 5 == 0 ? 0
                                                     : .1 * xorshift_real(random, 0, 1);
            found->areas[i] += flow;
            if (j < found->count && j > i)
                found->areas[j] += flow;
            flow *= 1 + (error > 0 ? error * (xorshift_real(random, 0, 1) - .5) : 0);
            put(found, i, j, flow, flow > 0 ? error * error : 0);
        }
    for (size_t i = 0; i < found->count; i++) /* every surface has an adjustable flow */
        put(found, i, found->count, found->flows[place(found, i, found->count)] + .1,
            1e-4 * (1 + xorshift_real(random, 0, 1)));
    for (size_t i = 0; i < found->count; i++)
        found->areas[i] += .1;
}

/* ---- The oracle ------------------------------------------------------------- */

/* The unknowns are the flows, each of them once, then a multiplier for each surface. */
struct system {
    size_t flows, size;
    size_t from[UNKNOWNS], to[UNKNOWNS];
    long double words[UNKNOWNS][UNKNOWNS + 1];
};

static void list_flows(const struct found *found, struct system *system)
{
    for (size_t i = 0; i < found->count; i++)
        for (size_t j = i; j <= found->count; j++) {
            system->from[system->flows] = i;
            system->to[system->flows++] = j;
        }
    system->size = system->flows + found->count;
}

/* The equations are y - v (l_i + l_j) = x. For the flow to the surface itself and to
 * the outside they are y - v l_i = x. The sums of flows are the areas. */
static void put_equations(const struct found *found, struct system *system)
{
    for (size_t k = 0; k < system->flows; k++) {
        size_t i = system->from[k], j = system->to[k];
        size_t at = place(found, i, j), first = system->flows;
        system->words[k][k] = 1;
        system->words[k][first + i] = -found->variances[at];
        system->words[first + i][k] = 1;
        if (j != i && j < found->count) {
            system->words[k][first + j] = -found->variances[at];
            system->words[first + j][k] = 1;
        }
        system->words[k][system->size] = found->flows[at];
    }
    for (size_t i = 0; i < found->count; i++)
        system->words[system->flows + i][system->size] = found->areas[i];
}

static void exchange_rows(struct system *system, size_t a, size_t b)
{
    for (size_t j = 0; a != b && j <= system->size; j++) {
        long double word = system->words[a][j];
        system->words[a][j] = system->words[b][j];
        system->words[b][j] = word;
    }
}

static void solve(struct system *system)
{
    for (size_t k = 0; k < system->size; k++) {
        size_t best = k;
        for (size_t i = k; i < system->size; i++)
            if (fabsl(system->words[i][k]) > fabsl(system->words[best][k]))
                best = i;
        exchange_rows(system, k, best);
        for (size_t i = 0; i < system->size; i++) {
            long double factor = i == k ? 0 : system->words[i][k] / system->words[k][k];
            for (size_t j = k; factor != 0 && j <= system->size; j++)
                system->words[i][j] -= factor * system->words[k][j];
        }
    }
}

static void check_oracle(const struct found *found, const double *smooth)
{
    FREED struct system *system = NON_NULL(calloc(1, sizeof *system));
    list_flows(found, system);
    put_equations(found, system);
    solve(system);
    for (size_t k = 0; k < system->flows; k++) {
        double expected = (double)(system->words[k][system->size]
                                   / system->words[k][k]);
        double flow = smooth[place(found, system->from[k], system->to[k])];
        FAIL_IF(!(fabs(flow - expected) < 1e-10),
                "%zu surfaces, from %zu to %zu: %.15g, not %.15g", found->count,
                system->from[k] + 1, system->to[k] + 1, flow, expected);
    }
}

/* ---- Random enclosures ----------------------------------------------------- */

static struct smooth_given given_of(const struct found *found, enum trace_mode mode)
{
    return (struct smooth_given)ON_PRIOR(.mode = mode, .count = found->count,
                                         .flows = found->flows,
                                         .variances = found->variances,
                                         .areas = found->areas);
}

static bool run(const struct found *found, enum trace_mode mode, double *smooth,
                c205_error *error)
{
    struct smooth_given given = given_of(found, mode);
    SCOPED_VALUE(accounts) accounts = { .model = prior_model };
    bool good = smooth_flows(&given, smooth, &accounts, error);
    assert_true(accounts.clocks > 0);
    return good;
}

/* Reciprocity holds to the last bit, and closure up to rounding. */
static void check_rules(const struct found *found, const double *smooth)
{
    for (size_t i = 0; i < found->count; i++) {
        double sum = 0;
        for (size_t j = 0; j <= found->count; j++)
            sum += smooth[place(found, i, j)];
        assert_float_equal(sum, found->areas[i], 1e-11);
        for (size_t j = 0; j < i; j++)
            assert_true(smooth[place(found, i, j)] == smooth[place(found, j, i)]);
    }
}

TEST(by_chance)
{
    uint64_t random = 19841115;
    for (int i = 0; i < 60; i++) {
        struct found found;
        double scalar[MAX * (MAX + 1)], vector[MAX * (MAX + 1)];
        draw(&found, &random);
        REQUIRE(run(&found, TRACE_SCALAR, scalar, &failure)
                && run(&found, TRACE_VECTOR, vector, &failure));
        assert_memory_equal(scalar, vector,
                            found.count * (found.count + 1) * sizeof *scalar);
        check_rules(&found, vector);
        check_oracle(&found, vector);
    }
}

/* Exact flows do not change. Neither do flows that are closed. */
TEST(left_alone)
{
    const struct found exact = { .count = 2,
                                 .areas = { 1, 4 },
                                 .flows = { 0, 1, 0, 1, 3, 0 } };
    const struct found closed = { .count = 2,
                                  .areas = { 1, 2 },
                                  .flows = { 0, .5, .5, .5, 0, 1.5 },
                                  .variances = { 0, .1, .2, .1, 0, .3 } };
    double smooth[6];
    assert_true(run(&exact, TRACE_VECTOR, smooth, &failure));
    assert_memory_equal(smooth, exact.flows, sizeof smooth);
    assert_true(run(&closed, TRACE_SCALAR, smooth, &failure));
    assert_memory_equal(smooth, closed.flows, sizeof smooth);
}

/* ---- Errors ------------------------------------------------------------------- */

static void refuses(const struct found *found, const char *message)
{
    static const char *const names[] = { "1", "2" };
    for (int mode = 0; mode < TRACE_FORMS; mode++) {
        struct smooth_given given = given_of(found, (enum trace_mode)mode);
        SCOPED_VALUE(accounts) accounts = { .model = prior_model };
        double smooth[MAX * (MAX + 1)];
        c205_error error = { "" };
        given.names = names;
        assert_false(smooth_flows(&given, smooth, &accounts, &error));
        FAIL_IF(!strstr(error.message, message), "%s: %s", message, error.message);
    }
}

TEST(refused)
{
    const struct found pair = { .count = 2,
                                .areas = { 1, 1.1 },
                                .flows = { 0, 1, 0, 1, 0, 0 },
                                .variances = { 0, .1, 0, .1, 0, 0 } };
    struct found other = pair;
    refuses(&pair, "surface 2 belongs to a group that sees only itself");
    other.areas[1] = 0;
    refuses(&other, "surface 2 has no area");
    other = pair;
    other.variances[3] = -1;
    refuses(&other, "a flow of surface 2 or its variance is below 0");
    other = pair;
    other.flows[0] = NAN;
    refuses(&other, "a flow of surface 1 or its variance is below 0");
    other.count = 0;
    refuses(&other, "0 surfaces: the number must be between 1 and 1024");
}
