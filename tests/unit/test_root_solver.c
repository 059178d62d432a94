/* test_root_solver.c - the root solver as kernels call it. Its scalar and vector
 * routines find the roots of random polynomials, with separate, double, triple and
 * quadruple roots. The results are compared bit for bit with each other, and with the
 * sign changes in small steps. A lane that ends early, or roots that are out of order,
 * fail here. */
#include <math.h>

#include "rt/layout/program.h"
#include "tests/random.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/saved_machine.h"
#include "vm/number/arith.h"
#include "vm/text.h"

/* ---- Programs that call it ---------------------------------------------- */

enum { LANES = 300, INPUTS = 8, OUTPUTS = 5 };

/* The inputs are c4 .. c0, low, high and resolution, the outputs roots and number. */
struct lanes {
    c205_word in[LANES][INPUTS], out[LANES][OUTPUTS];
};

static const char vector_program[] =
    "        .equ    INTERIORS, 0\n"
    "        .equ    KEYS, 0\n"
    "        .include \"frame/queue.s\"\n"
    "        .include \"roots/quartic_vector.s\"\n"
    "        .data\n"
    "inputs:     .space 7 * QUEUE\n"
    "resolution: .space 1\n"
    "        .code\n"
    "        .entry  start\n"
    "start:\n"
    "        .macro  input register, number\n"
    "        EX      \\register, inputs + 64 * QUEUE * \\number\n"
    "        ELEN    \\register, QUEUE\n"
    "        .endm\n"
    "        input   w0, 0\n"
    "        input   w1, 1\n"
    "        input   w2, 2\n"
    "        input   w3, 3\n"
    "        input   w4, 4\n"
    "        input   w5, 5\n"
    "        input   w6, 6\n"
    "        EX      s9, resolution\n"
    "        LOD     [s9], s9\n"
    "        EX      target, solve\n"
    "        call_quartic target, w0, w1, w2, w3, w4, w5, w6, s9\n"
    "        EXIT\n"
    "solve:  BIM     ROUTINE\n";

static const char scalar_program[] = "        .include \"frame/linkage.s\"\n"
                                     "        .include \"roots/quartic_scalar.s\"\n"
                                     "        .data\n"
                                     "handed: .space 8\n"
                                     "given:  .space 5\n"
                                     "list:   .descriptor 5, handed\n"
                                     "        .descriptor 3, handed + 64 * 5\n"
                                     "        .descriptor 5, given\n"
                                     "inputs: .space 8 * QUEUE\n"
                                     "outputs: .space 5 * QUEUE\n"
                                     "        .code\n"
                                     "        .macro  copy from, to, number\n"
                                     "        ELEN    \\from, \\number\n"
                                     "        SWAP    [\\from], r104, [r0]\n"
                                     "        ELEN    \\to, \\number\n"
                                     "        SWAP    [r0], r104, [\\to]\n"
                                     "        .endm\n"
                                     "        .entry  start\n"
                                     "start:  EX      r12, inputs\n"
                                     "        EX      r13, outputs\n"
                                     "        EX      r14, QUEUE\n"
                                     "        ES      r15, -1\n"
                                     "next:   EX      r16, handed\n"
                                     "        copy    r12, r16, 8\n"
                                     "        call    ROUTINE, list\n"
                                     "        EX      r16, given\n"
                                     "        copy    r16, r13, 5\n"
                                     "        IX      r12, 64 * 8\n"
                                     "        IX      r13, 64 * 5\n"
                                     "        IBXNE   r14, r15, r0, next, r14\n"
                                     "        EXIT\n";

static struct object *assemble(const char *text, const char *routine)
{
    const struct asm_define defines[] = { { "QUEUE", LANES }, { NULL, 0 } };
    const struct text *const texts[] = { kernel_texts, NULL };
    const struct asm_options how = { .defines = defines, .texts = texts };
    SCOPED_VALUE(diagnostics) errors = { 0 };
    struct sink sink = stream_sink(stderr);
    const char *at = strstr(text, "ROUTINE");
    const char *program = formatted("%.*s%s%s", (int)(at - text), text, routine,
                                    at + strlen("ROUTINE"));
    struct object *object = NON_NULL(assemble_text("test.s", program, &how, &errors));
    diagnostics_put(&errors, &sink);
    return object;
}

static uint64_t address_of(const struct object *object, const char *name)
{
    const struct asm_symbol *symbol = NON_NULL(object_symbol(object, name));
    return (uint64_t)symbol->value;
}

static void run(c205 *machine)
{
    c205_stop stop = c205_run(machine, C205_NO_LIMIT);
    assert_int_equal(stop.trap, C205_TRAP_NONE);
}

static void run_scalar(struct lanes *lanes, const char *routine)
{
    SCOPED(object) *object = assemble(scalar_program, routine);
    SCOPED(c205) *machine = machine_with(&object->program, prior_model);
    assert_true(c205_write(machine, address_of(object, "inputs"), lanes->in[0],
                           LANES * INPUTS));
    run(machine);
    assert_true(c205_read(machine, address_of(object, "outputs"), lanes->out[0],
                          LANES * OUTPUTS));
}

/* Returns true for registers that the solver may change: link_inner, s0-s9, the
 * registers that its first lines name, and the registers of the test program. */
static bool may_change(unsigned number)
{
    return number == 3 || (number >= 6 && number <= 15) || number == 31 || number == 68
           || number == 69 || (number >= 76 && number <= 79)
           || (number >= 88 && number <= 94) || (number >= 113 && number <= 115);
}

static void run_vector(struct lanes *lanes, const char *routine)
{
    SCOPED(object) *object = assemble(vector_program, routine);
    SCOPED(c205) *machine = machine_with(&object->program, prior_model);
    uint64_t inputs = address_of(object, "inputs");
    c205_word plane[LANES];
    for (unsigned j = 0; j < INPUTS - 1; j++) {
        for (unsigned i = 0; i < LANES; i++)
            plane[i] = lanes->in[i][j];
        assert_true(c205_write(machine, inputs + 64 * LANES * j, plane, LANES));
    }
    assert_true(c205_write(machine, address_of(object, "resolution"),
                           &lanes->in[0][INPUTS - 1], 1));
    for (unsigned i = 1; i < 256; i++)
        c205_set_register(machine, i, i * UINT64_C(0x1234567890ABCDF));
    run(machine);
    for (unsigned i = 1; i < 256; i++)
        if (!may_change(i))
            assert_int_equal(c205_register(machine, i),
                             i * UINT64_C(0x1234567890ABCDF));
    for (unsigned j = 0; j < OUTPUTS; j++) {
        unsigned number = j < 4 ? 76 + j : 115;
        uint64_t at = c205_register(machine, number);
        assert_int_equal(at >> 48, LANES);
        assert_true(c205_read(machine, at & UINT64_C(0xFFFFFFFFFFFF), plane, LANES));
        for (unsigned i = 0; i < LANES; i++)
            lanes->out[i][j] = plane[i];
    }
}

/* Fills the lanes with intervals about 0, like the interval of a ray about its closest
 * approach. One in eight is empty. */
static void fill(struct lanes *lanes, uint64_t *state)
{
    for (int i = 0; i < LANES; i++) {
        double half = (double)xorshift_between(state, 1, 1000) / 500;
        for (int j = 0; j < 5; j++)
            lanes->in[i][j] = c205_from_double(
                (double)xorshift_between(state, -100000, 100000) / 1e5);
        lanes->in[i][5] = c205_from_double(i % 8 == 5 ? half : -half);
        lanes->in[i][6] = c205_from_double(half);
        lanes->in[i][7] = c205_from_double(1e-12);
    }
}

static double value(const c205_word *c, double t)
{
    double f = 0;
    for (int i = 0; i < 5; i++)
        f = f * t + c205_to_double(c[i]);
    return f;
}

/* The number of sign changes in small steps must equal the number of roots. */
static void check_signs(const struct lanes *lanes, int lane, int found)
{
    enum { STEPS = 4000 };
    const c205_word *in = lanes->in[lane];
    double low = c205_to_double(in[5]), high = c205_to_double(in[6]);
    int seen = 0;
    for (int i = 0; i < STEPS && low < high; i++) {
        double a = low + (high - low) * i / STEPS;
        double b = low + (high - low) * (i + 1) / STEPS;
        if ((value(in, a) >= 0) == (value(in, b) >= 0))
            continue;
        assert_in_range(seen, 0, found - 1);
        double root = c205_to_double(lanes->out[lane][seen++]);
        assert_true(root > a - 1e-9 && root < b + 1e-9);
        assert_true(fabs(value(in, root)) < 1e-11 * 30);
    }
    assert_int_equal(seen, found);
}

/* The number of roots and all roots must be equal bit for bit. */
static void assert_same_roots(const c205_word *a, const c205_word *b)
{
    assert_int_equal(a[4], b[4]);
    for (int i = 0; i < (int)c205_to_double(a[4]); i++)
        assert_int_equal(a[i], b[i]);
}

TEST(alone)
{
    static struct lanes scalar, vector, first;
    uint64_t seed = RANDOM_SEED;
    fill(&scalar, &seed);
    vector = first = scalar;
    run_scalar(&scalar, "solve_quartic_all");
    run_vector(&vector, "solve_quartic_all");
    run_scalar(&first, "solve_quartic");
    for (int i = 0; i < LANES; i++) {
        int found = (int)c205_to_double(scalar.out[i][4]);
        assert_same_roots(scalar.out[i], vector.out[i]);
        assert_int_equal(c205_to_double(first.out[i][4]), found > 0);
        assert_int_equal(first.out[i][0], scalar.out[i][0]);
        check_signs(&scalar, i, found);
    }
    run_vector(&vector, "solve_quartic");
    for (int i = 0; i < LANES; i++) {
        assert_int_equal(first.out[i][4], vector.out[i][4]);
        assert_int_equal(first.out[i][0], vector.out[i][0]);
    }
}

/* ---- By signs alone ----------------------------------------------------- */

enum { ROOTS = 4, ROUNDS = 8 };

/* A polynomial's roots. `above`: a pair's squared distance from the real axis. */
struct factors {
    double root[ROOTS], above[ROOTS / 2];
};

static double tiny(uint64_t *state, int least)
{
    double power = ldexp(1, -(int)xorshift_between(state, 5, least));
    return xorshift(state) & 1 ? power : -power;
}

/* A kind of polynomial: the root that each root equals or is near to, the complex
 * pairs, and whether roots are integers, with zeros at ends, extrema and knots. */
static const struct kind {
    int like[ROOTS];
    bool near, above[ROOTS / 2], whole;
} kinds[] = {
    { .like = { 0, 1, 2, 3 } },
    { .like = { 0, 0, 2, 3 } },
    { .like = { 0, 0, 2, 2 } },
    { .like = { 0, 0, 0, 3 } },
    { .like = { 0, 0, 0, 0 } },
    { .like = { 0, 0, 0, 0 }, .near = true },
    { .like = { 0, 0, 2, 3 }, .above = { true } },
    { .like = { 0, 0, 2, 2 }, .above = { true, true } },
    { .like = { 0, 1, 2, 3 }, .whole = true },
};
enum { KINDS = COUNT(kinds) };

static void draw_factors(const struct kind *kind, struct factors *f, uint64_t *state)
{
    for (int i = 0; i < ROOTS; i++)
        f->root[i] = kind->whole
                         ? (double)xorshift_between(state, -3, 3)
                         : (double)xorshift_between(state, -2000000, 2000000) / 1e6;
    for (int i = 0; i < ROOTS; i++)
        if (kind->like[i] != i)
            f->root[i] = f->root[kind->like[i]] + (kind->near ? tiny(state, 14) : 0);
    for (int i = 0; i < ROOTS / 2; i++)
        f->above[i] = kind->above[i] ? tiny(state, 44) : 0;
}

/* Expands (t - a) (t - b) + above. */
static void quadratic(double a, double b, double above, double c[3])
{
    c[0] = 1;
    c[1] = -(a + b);
    c[2] = a * b + above;
}

static void expand(const struct factors *f, double scale, c205_word c[5])
{
    double p[3], q[3], sum[5] = { 0 };
    quadratic(f->root[0], f->root[1], f->above[0], p);
    quadratic(f->root[2], f->root[3], f->above[1], q);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            sum[i + j] += p[i] * q[j];
    for (int i = 0; i < 5; i++)
        c[i] = c205_from_double(scale * sum[i]);
}

/* Returns true if the machine's value at t is not negative. */
static bool is_positive(const c205_word *c, c205_word t)
{
    uint64_t flags = 0;
    c205_word f = c[0];
    for (int i = 1; i < 5; i++)
        f = arith_add_normalised(arith_multiply_significant(f, t, &flags), c[i],
                                 &flags);
    return arith_not_less(f, C205_MACHINE_ZERO);
}

/* Uses all kinds in turn. One in two is positive at both ends, one in 16 is empty. */
static void fill_touching(struct lanes *lanes, struct factors *factors,
                          double resolution, uint64_t *state)
{
    for (int i = 0; i < LANES; i++) {
        struct factors f;
        c205_word *in = lanes->in[i];
        draw_factors(&kinds[i % KINDS], &f, state);
        expand(&f, i & 1 ? -1 : 1, in);
        in[5] = c205_from_double(i % 16 == 7 ? 3 : -3);
        in[6] = c205_from_double(i % 16 == 7 ? -3 : 3);
        in[7] = c205_from_double(resolution);
        factors[i] = f;
    }
}

/* Roots must be in ascending order, followed by padding. The sign must change exactly
 * between two roots, as far as roots with this resolution can show it. */
static void check_order(const c205_word *in, const c205_word *out, int found)
{
    double small = 1e-9 + 1000 * c205_to_double(in[7]);
    bool positive = is_positive(in, in[5]);
    for (int i = 0; i < ROOTS; i++) {
        double root = c205_to_double(out[i]);
        double next = i + 1 < found ? c205_to_double(out[i + 1]) : 3;
        double middle = value(in, (root + next) / 2);
        if (i >= found) {
            assert_true(root > 0.999e30);
            continue;
        }
        assert_true(root > -3 - small && root < 3 + small);
        assert_true(i + 1 == found || root <= next);
        assert_true(fabs(value(in, root)) < small);
        positive = !positive;
        if (fabs(middle) > small)
            assert_int_equal(middle > 0, positive);
    }
}

/* Returns true if all roots are separate enough to be found. */
static bool are_far(const struct factors *f)
{
    for (int i = 0; i < ROOTS; i++)
        for (int j = 0; j < i; j++)
            if (fabs(f->root[i] - f->root[j]) < 0.1)
                return false;
    return true;
}

static void check_parity(const c205_word *in, const c205_word *out)
{
    int found = (int)c205_to_double(out[4]);
    bool filled = c205_to_double(in[5]) < c205_to_double(in[6]);
    bool agree = is_positive(in, in[5]) == is_positive(in, in[6]);
    assert_in_range(found, 0, ROOTS);
    if (!filled)
        assert_int_equal(found, 0);
    else
        assert_int_equal(found % 2 == 0, agree);
    check_order(in, out, found);
}

TEST(signs)
{
    static struct lanes scalar, vector;
    static struct factors factors[LANES];
    static const double resolutions[] = { 0, 1e-12, 1e-7, 1e-3 };
    uint64_t seed = RANDOM_SEED;
    for (int round = 0; round < ROUNDS; round++) {
        fill_touching(&scalar, factors, resolutions[round % 4], &seed);
        vector = scalar;
        run_scalar(&scalar, "solve_quartic_signs");
        run_vector(&vector, "solve_quartic_signs");
        for (int i = 0; i < LANES; i++) {
            const c205_word *out = scalar.out[i];
            bool filled = i % 16 != 7;
            assert_memory_equal(out, vector.out[i], sizeof scalar.out[i]);
            check_parity(scalar.in[i], out);
            if (i % KINDS == 0 && filled && are_far(&factors[i]))
                assert_int_equal(c205_to_double(out[4]), ROOTS);
        }
    }
}

/* Two roots nearer than the resolution of 1e-3 could come in the wrong order. */
TEST(signs_ascend)
{
    static const double c[INPUTS] = { 1,
                                      3.3128990156249927,
                                      4.1157368395001868,
                                      2.2725027378114078,
                                      0.47053554310699042,
                                      -3,
                                      3,
                                      1e-3 };
    static struct lanes scalar, vector;
    for (int i = 0; i < LANES; i++)
        for (int j = 0; j < INPUTS; j++)
            scalar.in[i][j] = c205_from_double(c[j]);
    vector = scalar;
    run_scalar(&scalar, "solve_quartic_signs");
    run_vector(&vector, "solve_quartic_signs");
    assert_memory_equal(scalar.out, vector.out, sizeof scalar.out);
    assert_int_equal(c205_to_double(scalar.out[0][4]), 2);
    check_parity(scalar.in[0], scalar.out[0]);
}

/* Both entry points have the same result if there are no double roots. */
TEST(signs_of_sharp)
{
    static struct lanes all, signs;
    uint64_t seed = RANDOM_SEED;
    fill(&all, &seed);
    signs = all;
    run_scalar(&all, "solve_quartic_all");
    run_scalar(&signs, "solve_quartic_signs");
    for (int i = 0; i < LANES; i++)
        assert_same_roots(all.out[i], signs.out[i]);
}
