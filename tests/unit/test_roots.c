/* test_roots.c - the programs of rt205 quartic. Roots of 33 quartics, cubics,
 * quadratics and lines of all magnitudes are compared with their known roots, in both
 * forms and by every rule of the regula falsi. A root that is lost at a bound, a double
 * root that is counted twice, or an overflow fails here. */
#include <math.h>

#include "rt/layout/program.h"
#include "rt/roots/roots.h"
#include "tests/unit/prior_model.h"
#include "vm/text.h"

/* ---- Known roots -------------------------------------------------------- */

static const struct known {
    const char *c[5], *bound;
    const char *roots; /* separated by blanks, with an accuracy of 1e-10 */
} known[] = {
    { { "1", "-10", "35", "-50", "24" }, "0", "1 2 3 4" },
    { { "1", "-10", "35", "-50", "24" }, "1", "2 3 4" },
    { { "1", "-10", "35", "-50", "24" }, "4", "" },
    { { "1", "0", "-5", "0", "4" }, "-3", "-2 -1 1 2" },
    { { "1", "0", "-1", "0", "0" }, "-3", "-1 0 1" },
    { { "1", "0", "-1", "0", "0" }, "0", "1" },
    { { "1", "0", "0", "0", "0" }, "-1", "0" },
    { { "1", "0", "0", "0", "0" }, "0", "" },
    { { "1", "0", "0", "0", "1" }, "-9", "" },
    { { "0", "1", "-6", "11", "-6" }, "0", "1 2 3" },
    { { "0", "1", "0", "0", "-8" }, "0", "2" },
    { { "0", "0", "1", "-3", "2" }, "0", "1 2" },
    { { "0", "0", "1", "-2", "1" }, "0", "1" },
    { { "0", "0", "1", "-2", "1.01" }, "0", "" },
    { { "0", "0", "0", "2", "-3" }, "0", "1.5" },
    { { "0", "0", "0", "-2", "-3" }, "-2", "-1.5" },
    { { "0", "0", "0", "0", "7" }, "-2", "" },
    { { "0", "0", "0", "0", "0" }, "-2", "" },
    /* double, two double, triple and quadruple */
    { { "1", "-7", "17", "-17", "6" }, "0", "1 2 3" },
    { { "1", "-6", "13", "-12", "4" }, "0", "1 2" },
    { { "1", "-7", "15", "-13", "4" }, "0", "1 4" },
    { { "1", "-4", "6", "-4", "1" }, "0", "1" },
    { { "1", "-4", "6", "-4", "1" }, "1", "" },
    { { "1", "4", "6", "4", "1" }, "-5", "-1" },
    /* of any magnitude */
    { { "1e300", "-10e300", "35e300", "-50e300", "24e300" }, "0", "1 2 3 4" },
    { { "1e-300", "-10e-300", "35e-300", "-50e-300", "24e-300" }, "0", "1 2 3 4" },
    { { "1e8000", "-10e8000", "35e8000", "-50e8000", "24e8000" }, "3", "4" },
    { { "1", "0", "0", "0", "-1e400" }, "0", "1e100" },
    { { "1", "0", "0", "0", "-1e-400" }, "-1", "-1e-100 1e-100" },
    { { "1e-300", "-1", "0", "0", "1e-300" }, "0", "1e-100 1e300" },
    { { "0", "1e-8000", "-1e-8000", "0", "0" }, "0", "1" },
    { { "0", "0", "1", "-1e100", "1" }, "0", "1e-100 1e100" },
    { { "0", "0", "1e-40", "-1", "1e-40" }, "1", "1e40" },
};
enum { KNOWN = COUNT(known) };

static struct polynomial_roots *solve(const struct polynomial *polynomials,
                                      size_t count, const struct roots_options *options)
{
    struct root_search *search = roots_new(polynomials, count, options, &failure);
    struct polynomial_roots *roots = NON_NULL(calloc(count, sizeof *roots));
    REQUIRE(search && roots_run(search, &failure)
            && roots_read(search, roots, &failure));
    roots_free(search);
    return roots;
}

static c205_word number(const char *text)
{
    return c205_from_text(text, &text);
}

static void check_known(const struct known *expected,
                        const struct polynomial_roots *roots, bool first)
{
    char *text = (char *)expected->roots;
    int count = 0;
    while (*text != '\0' && !(first && count == 1)) {
        double root = strtod(text, &text);
        if (count == roots->count
            || fabs(c205_to_double(roots->root[count++]) - root) > 1e-10 * fabs(root))
            fail_msg("polynomial %zu: not the roots %s", (size_t)(expected - known),
                     expected->roots);
        text += *text == ' ';
    }
    assert_int_equal(roots->count, count);
}

static void read_known(struct polynomial polynomials[KNOWN])
{
    for (size_t i = 0; i < KNOWN; i++) {
        for (int j = 0; j < 5; j++)
            polynomials[i].c[j] = number(known[i].c[j]);
        polynomials[i].bound = number(known[i].bound);
    }
}

TEST(known)
{
    struct roots_options options = { .queue = 10, .model = prior_model };
    struct polynomial polynomials[KNOWN];
    read_known(polynomials);
    for (int way = 0; way < 2 * 2 * FALSI_RULES; way++) {
        options.mode = way % 2 ? TRACE_VECTOR : TRACE_SCALAR;
        options.first = way / 2 % 2;
        options.falsi = (enum falsi)(way / 4);
        FREED struct polynomial_roots *roots = solve(polynomials, KNOWN, &options);
        for (size_t i = 0; i < KNOWN; i++)
            check_known(&known[i], &roots[i], options.first);
    }
}

/* The progress never decreases, and ends with the number of all polynomials. */
static bool note_progress(void *context, size_t done, size_t all)
{
    size_t *last = context;
    assert_int_equal(all, KNOWN);
    assert_in_range(done, *last, all);
    *last = done;
    return true;
}

TEST(progress)
{
    size_t last = 0;
    struct roots_options options = ON_PRIOR(.queue = 1, .progress = note_progress,
                                            .context = &last);
    struct polynomial polynomials[KNOWN];
    read_known(polynomials);
    for (int mode = 0; mode < TRACE_FORMS; mode++) {
        last = 0;
        options.mode = (enum trace_mode)mode;
        free(solve(polynomials, KNOWN, &options));
        assert_int_equal(last, KNOWN);
    }
}

/* The constants of enum falsi must equal the constants of the kernels. */
TEST(falsi)
{
    static const struct {
        const char *name;
        enum falsi rule;
    } rules[FALSI_RULES] = { { "PAPER", FALSI_PAPER },
                             { "ILLINOIS", FALSI_ILLINOIS },
                             { "PEGASUS", FALSI_PEGASUS },
                             { "ANDERSON_BJORCK", FALSI_ANDERSON_BJORCK } };
    const struct asm_define defines[] = { { "QUEUE", 1 }, { NULL, 0 } };
    SCOPED(object) *program = NON_NULL(
        program_assemble("roots/roots.s", defines, &failure));
    for (int i = 0; i < FALSI_RULES; i++)
        assert_int_equal(object_symbol(program, rules[i].name)->value, rules[i].rule);
}

/* A polynomial that exceeds the machine's exponents is rejected. */
TEST(refused)
{
    struct roots_options options = { .queue = 1, .model = prior_model };
    struct polynomial polynomials[2] = { { { C205_ONE, 0, C205_ONE, 0, C205_ONE },
                                           C205_MACHINE_ZERO },
                                         { { 0, 0, 0, 0, 0 }, C205_MACHINE_ZERO } };
    for (int i = 0; i < 5; i++)
        polynomials[1].c[i] = C205_MACHINE_ZERO;
    polynomials[0].c[1] = number("1e4000");
    polynomials[0].c[3] = C205_MACHINE_ZERO;
    polynomials[1].c[3] = number("1e8000");
    polynomials[1].c[4] = number("-1e-8000");
    for (int mode = 0; mode < TRACE_FORMS; mode++) {
        options.mode = (enum trace_mode)mode;
        FREED struct polynomial_roots *roots = solve(polynomials, 2, &options);
        assert_int_equal(roots[0].count, ROOTS_REFUSED);
        assert_int_equal(roots[1].count, ROOTS_REFUSED);
    }
}

static struct iterations watched(enum trace_mode mode, size_t queue)
{
    struct roots_options options = ON_PRIOR(.mode = mode, .queue = queue);
    struct polynomial polynomials[KNOWN];
    struct iterations iterations;
    read_known(polynomials);
    struct root_search *search = roots_new(polynomials, KNOWN, &options, &failure);
    REQUIRE(search && roots_watch(search, &iterations) && roots_run(search, &failure));
    roots_free(search);
    return iterations;
}

/* In every form and with every queue, the same brackets are refined in the same number
 * of steps. A lane in the loop may be finished. */
TEST(iterations)
{
    static const size_t queues[] = { 1, 7, 2000 };
    struct iterations scalar = watched(TRACE_SCALAR, 1);
    for (size_t i = 0; i < COUNT(queues); i++) {
        struct iterations vector = watched(TRACE_VECTOR, queues[i]);
        for (int k = 0; k < STAGES; k++) {
            const struct stage_count *one = &scalar.stage[k];
            const struct stage_count *many = &vector.stage[k];
            assert_true(one->brackets > 0);
            assert_int_equal(many->brackets, one->brackets);
            assert_int_equal(many->steps, one->steps);
            assert_int_equal(many->halvings, one->halvings);
            assert_int_equal(one->lanes, one->steps);
            assert_int_equal(one->passes, one->steps);
            assert_true(many->lanes >= many->steps);
            assert_true(many->passes <= one->passes);
        }
    }
}
