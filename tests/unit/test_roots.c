/* The root solver: roots that are known, through the programs of rt205
 * quartic; and the solver alone, as kernels call it. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "rt/program.h"
#include "rt/roots.h"
#include "tests/random.h"
#include "vm/text.h"

static c205_model *model;

/* ---- Known roots -------------------------------------------------------- */

static const struct known {
    const char *c[5], *bound;
    const char *roots; /* blanks between them; to 1e-10 */
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
    /* of any size */
    { { "1e300", "-10e300", "35e300", "-50e300", "24e300" }, "0", "1 2 3 4" },
    { { "1e-300", "-10e-300", "35e-300", "-50e-300", "24e-300" },
      "0",
      "1 2 3 4" },
    { { "1e8000", "-10e8000", "35e8000", "-50e8000", "24e8000" }, "3", "4" },
    { { "1", "0", "0", "0", "-1e400" }, "0", "1e100" },
    { { "1", "0", "0", "0", "-1e-400" }, "-1", "-1e-100 1e-100" },
    { { "1e-300", "-1", "0", "0", "1e-300" }, "0", "1e-100 1e300" },
    { { "0", "1e-8000", "-1e-8000", "0", "0" }, "0", "1" },
    { { "0", "0", "1", "-1e100", "1" }, "0", "1e-100 1e100" },
    { { "0", "0", "1e-40", "-1", "1e-40" }, "1", "1e40" },
};
enum { KNOWN = sizeof known / sizeof *known };

static struct polynomial_roots *solve(const struct polynomial *polynomials,
                                      size_t count,
                                      const struct roots_options *options)
{
    c205_error error = { "" };
    struct root_search *search = roots_new(polynomials, count, options,
                                           &error);
    struct polynomial_roots *roots = calloc(count, sizeof *roots);

    assert_non_null(roots);
    if (search == NULL || !roots_run(search, &error)
        || !roots_read(search, roots, &error))
        fail_msg("%s", error.message);
    roots_free(search);
    return roots;
}

static c205_word number(const char *text)
{
    return c205_from_text(text, &text);
}

static bool is_root(c205_word found, const char *text, const char **end)
{
    double expected = strtod(text, (char **)end);
    double got = c205_to_double(found);

    return fabs(got - expected) <= 1e-10 * fabs(expected);
}

static void check_known(const struct known *expected,
                        const struct polynomial_roots *roots, bool first)
{
    const char *text = expected->roots;
    int count = 0;

    while (*text != '\0' && !(first && count == 1)) {
        if (count == roots->count
            || !is_root(roots->root[count++], text, &text))
            fail_msg("polynomial %zu: not the roots %s",
                     (size_t)(expected - known), expected->roots);
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

static void test_known(void **state)
{
    struct roots_options options = { .queue = 10, .model = model };
    struct polynomial polynomials[KNOWN];

    (void)state;
    read_known(polynomials);
    for (int way = 0; way < 2 * 2 * FALSI_RULES; way++) {
        struct polynomial_roots *roots;

        options.mode = way % 2 ? TRACE_VECTOR : TRACE_SCALAR;
        options.first = way / 2 % 2;
        options.falsi = (enum falsi)(way / 4);
        roots = solve(polynomials, KNOWN, &options);
        for (size_t i = 0; i < KNOWN; i++)
            check_known(&known[i], &roots[i], options.first);
        free(roots);
    }
}

/* Ever more, and in the end all. */
static bool note_progress(void *context, size_t done, size_t all)
{
    size_t *last = context;

    assert_int_equal(all, KNOWN);
    assert_in_range(done, *last, all);
    *last = done;
    return true;
}

static void test_progress(void **state)
{
    size_t last = 0;
    struct roots_options options = { .queue = 1,
                                     .model = model,
                                     .progress = note_progress,
                                     .context = &last };
    struct polynomial polynomials[KNOWN];

    (void)state;
    read_known(polynomials);
    for (int mode = 0; mode < TRACE_MODES; mode++) {
        last = 0;
        options.mode = (enum trace_mode)mode;
        free(solve(polynomials, KNOWN, &options));
        assert_int_equal(last, KNOWN);
    }
}

/* The numbers of falsi.h are those of the kernels. */
static void test_falsi(void **state)
{
    static const struct {
        const char *name;
        enum falsi rule;
    } rules[FALSI_RULES] = { { "PAPER", FALSI_PAPER },
                             { "ILLINOIS", FALSI_ILLINOIS },
                             { "PEGASUS", FALSI_PEGASUS },
                             { "ANDERSON_BJORCK", FALSI_ANDERSON_BJORCK } };
    const struct asm_define defines[] = { { "QUEUE", 1 }, { NULL, 0 } };
    c205_error error = { "" };
    struct object *program = program_assemble("roots_vector.s", defines,
                                              &error);

    (void)state;
    if (program == NULL)
        fail_msg("%s", error.message);
    for (int i = 0; i < FALSI_RULES; i++)
        assert_int_equal(object_symbol(program, rules[i].name)->value,
                         rules[i].rule);
    object_free(program);
}

/* What no exponent of the machine can hold is refused, not guessed. */
static void test_refused(void **state)
{
    struct roots_options options = { .queue = 1, .model = model };
    struct polynomial polynomials[2] = {
        { { C205_ONE, 0, C205_ONE, 0, C205_ONE }, C205_MACHINE_ZERO },
        { { 0, 0, 0, 0, 0 }, C205_MACHINE_ZERO }
    };

    (void)state;
    for (int i = 0; i < 5; i++)
        polynomials[1].c[i] = C205_MACHINE_ZERO;
    polynomials[0].c[1] = number("1e4000");
    polynomials[0].c[3] = C205_MACHINE_ZERO;
    polynomials[1].c[3] = number("1e8000");
    polynomials[1].c[4] = number("-1e-8000");
    for (int mode = 0; mode < TRACE_MODES; mode++) {
        struct polynomial_roots *roots;

        options.mode = (enum trace_mode)mode;
        roots = solve(polynomials, 2, &options);
        assert_int_equal(roots[0].count, ROOTS_REFUSED);
        assert_int_equal(roots[1].count, ROOTS_REFUSED);
        free(roots);
    }
}

/* ---- The solver alone --------------------------------------------------- */

enum { LANES = 300, INPUTS = 8, OUTPUTS = 5 };

/* c4 .. c0, low, high, resolution; and four roots, their number. */
struct lanes {
    c205_word in[LANES][INPUTS], out[LANES][OUTPUTS];
};

static const char vector_program[] =
    "        .include \"queue.s\"\n"
    "        .include \"quartic_vector.s\"\n"
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

static const char scalar_program[] =
    "        .include \"linkage.s\"\n"
    "        .include \"quartic_scalar.s\"\n"
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
    struct asm_errors errors = { 0, NULL };
    struct sink sink = stream_sink(stderr);
    char program[4096];
    const char *at = strstr(text, "ROUTINE");
    struct object *object;

    snprintf(program, sizeof program, "%.*s%s%s", (int)(at - text), text,
             routine, at + strlen("ROUTINE"));
    object = assemble_text("test.s", program, &how, &errors);
    asm_errors_print(&errors, &sink);
    assert_non_null(object);
    asm_errors_free(&errors);
    return object;
}

static uint64_t address_of(const struct object *object, const char *name)
{
    const struct asm_symbol *symbol = object_symbol(object, name);

    assert_non_null(symbol);
    return (uint64_t)symbol->value;
}

static c205 *load(const struct object *object)
{
    c205_error error;
    c205 *machine = c205_new(model, &error);

    assert_non_null(machine);
    assert_true(c205_load(machine, &object->program, &error));
    return machine;
}

static void run(c205 *machine)
{
    c205_stop stop = c205_run(machine, C205_NO_LIMIT);

    assert_int_equal(stop.trap, C205_TRAP_NONE);
}

static void run_scalar(struct lanes *lanes, const char *routine)
{
    struct object *object = assemble(scalar_program, routine);
    c205 *machine = load(object);

    assert_true(c205_write(machine, address_of(object, "inputs"),
                           lanes->in[0], LANES * INPUTS));
    run(machine);
    assert_true(c205_read(machine, address_of(object, "outputs"),
                          lanes->out[0], LANES * OUTPUTS));
    c205_free(machine);
    object_free(object);
}

/* Registers that the solver may change: link_inner, s0-s9, what its head
 * names, and those that the program itself uses. */
static bool may_change(unsigned number)
{
    return number == 3 || (number >= 6 && number <= 15) || number == 31
           || number == 68 || number == 69 || (number >= 76 && number <= 79)
           || (number >= 97 && number <= 103)
           || (number >= 113 && number <= 115);
}

static void run_vector(struct lanes *lanes, const char *routine)
{
    struct object *object = assemble(vector_program, routine);
    c205 *machine = load(object);
    uint64_t inputs = address_of(object, "inputs");
    c205_word plane[LANES];

    for (unsigned j = 0; j < INPUTS - 1; j++) {
        for (unsigned i = 0; i < LANES; i++)
            plane[i] = lanes->in[i][j];
        assert_true(
            c205_write(machine, inputs + 64 * LANES * j, plane, LANES));
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
        assert_true(
            c205_read(machine, at & UINT64_C(0xFFFFFFFFFFFF), plane, LANES));
        for (unsigned i = 0; i < LANES; i++)
            lanes->out[i][j] = plane[i];
    }
    c205_free(machine);
    object_free(object);
}

/* Intervals about 0, as those of a ray about its closest approach; one in
 * eight is empty. */
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

/* Where the sign changes in small steps there is one root, and it is one. */
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

static void test_alone(void **state)
{
    static struct lanes scalar, vector, first;
    uint64_t seed = RANDOM_SEED;

    (void)state;
    fill(&scalar, &seed);
    vector = first = scalar;
    run_scalar(&scalar, "solve_quartic_all");
    run_vector(&vector, "solve_quartic_all");
    run_scalar(&first, "solve_quartic");
    for (int i = 0; i < LANES; i++) {
        int found = (int)c205_to_double(scalar.out[i][4]);

        assert_int_equal(scalar.out[i][4], vector.out[i][4]);
        for (int j = 0; j < found; j++)
            assert_int_equal(scalar.out[i][j], vector.out[i][j]);
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_known),
        cmocka_unit_test(test_progress),
        cmocka_unit_test(test_falsi),
        cmocka_unit_test(test_refused),
        cmocka_unit_test(test_alone),
    };
    c205_error error;
    int failed;

    model = c205_model_find("cyber205-2pipe", &error);
    if (model == NULL)
        return 2;
    failed = cmocka_run_group_tests(tests, NULL, NULL);
    c205_model_free(model);
    return failed;
}
