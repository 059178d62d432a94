/* test_kernel_functions.c - the powers and sines of kernels are compared with exact
 * values. Their arguments are in the ranges that kernels use. A polynomial, or a step of
 * a reduction, that is less accurate fails here.
 *
 *     test_kernel_functions [SEED]
 */
#include "rt/layout/program.h"
#include "tests/oracle/arithmetic_oracle.h"
#include "tests/oracle/chance.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/saved_machine.h"
#include "vm/text.h"

#include <math.h>

enum { COUNT = 2000, DIGITS = 200 };

static uint64_t state = RANDOM_SEED;

/* Sets `value` to a function of itself and of `exponent`. */
static const char power_routine[] = "        RTOR    value, p_x\n"
                                    "        EX      target, power\n"
                                    "        BSAVE   power_link, [target]\n"
                                    "        RTOR    p_x, value\n";
static const char two_to_routine[] = "        RTOR    value, p_x\n"
                                     "        EX      target, two_to\n"
                                     "        BSAVE   power_link, [target]\n"
                                     "        RTOR    p_x, value\n";
static const char sine_routine[] =
    "        load_words pattern_constants, PATTERN_CONSTANTS, turn\n"
    "        RTOR    value, y_0\n"
    "        sine_of_turn\n"
    "        RTOR    y_0, value\n";

static const char before[] =
    "        .include \"frame/records.s\"\n"
    "        .include \"frame/linkage.s\"\n"
    "        .include \"frame/vectors_scalar.s\"\n"
    "        .include \"light/power_constants.s\"\n"
    "        .include \"light/forms_scalar.s\"\n"
    "        .include \"light/power.s\"\n"
    "        .include \"light/pigment_scalar.s\"\n"
    "        .data\n"
    "xs:     .space  2000\n"
    "ys:     .space  2000\n"
    "        .code\n"
    "        .regs   r240, x_at, y_at, left, value\n"
    "        .entry  start\n"
    "start:  load_main_constants\n"
    "        load_words power_constants, POWER_CONSTANTS, p_47\n"
    "        EX      x_at, xs\n"
    "        EX      y_at, ys\n"
    "        EX      left, 2000\n"
    "next:   LOD     [x_at], value\n"
    "        LOD     [y_at], exponent\n";
static const char after[] = "        STO     [x_at], value\n"
                            "        IX      x_at, 64\n"
                            "        IX      y_at, 64\n"
                            "        IBXNE   left, m_index_minus_one, r0, next, left\n"
                            "        EXIT\n";

/* Replaces each x by the result of a routine. */
static void compute(const char *routine, c205_word x[COUNT], const c205_word y[COUNT])
{
    const struct asm_define defines[] = { { "PATTERNS", 1 }, { NULL, 0 } };
    const struct text *const texts[] = { kernel_texts, NULL };
    const struct asm_options how = { .defines = defines, .texts = texts };
    SCOPED_VALUE(diagnostics) errors = { 0 };
    struct sink sink = stream_sink(stderr);
    const char *text = formatted("%s%s%s", before, routine, after);
    SCOPED(object) *object = assemble_text("test.s", text, &how, &errors);
    diagnostics_put(&errors, &sink);
    assert_non_null(object);
    SCOPED(c205) *machine = machine_with(&object->program, prior_model);
    uint64_t xs = (uint64_t)object_symbol(object, "xs")->value;
    uint64_t ys = (uint64_t)object_symbol(object, "ys")->value;
    assert_true(c205_write(machine, xs, x, COUNT));
    assert_true(c205_write(machine, ys, y, COUNT));
    assert_int_equal(c205_run(machine, C205_NO_LIMIT).trap, C205_TRAP_NONE);
    assert_true(c205_read(machine, xs, x, COUNT));
}

typedef void exact_value(mpfr_t value, const mpfr_t x, const mpfr_t y);

static void exact_power(mpfr_t value, const mpfr_t x, const mpfr_t y)
{
    mpfr_pow(value, x, y, MPFR_RNDN);
}

static void exact_two_to(mpfr_t value, const mpfr_t x, const mpfr_t y)
{
    (void)y;
    mpfr_exp2(value, x, MPFR_RNDN);
}

/* sin 2 pi x */
static void exact_sine(mpfr_t value, const mpfr_t x, const mpfr_t y)
{
    (void)y;
    mpfr_const_pi(value, MPFR_RNDN);
    mpfr_mul(value, value, x, MPFR_RNDN);
    mpfr_mul_ui(value, value, 2, MPFR_RNDN);
    mpfr_sin(value, value, MPFR_RNDN);
}

/* Fails if an error is above `units` in the last place of the exact value, or of
 * numbers from 1/2 to 1 if the exact value is less and `absolute` is set. For a power
 * the error is divided by 1 + |z| + |y|, where 2^z is the exact value. */
static void check(const char *routine, exact_value *exact, double low, double high,
                  double most, double units, bool absolute)
{
    static c205_word x[COUNT], y[COUNT], result[COUNT];
    mpfr_t of_x, of_y, value, error;
    double greatest = 0;
    mpfr_inits2(DIGITS, of_x, of_y, value, error, (mpfr_ptr)NULL);
    for (size_t i = 0; i < COUNT; i++) {
        result[i] = x[i] = c205_from_double(between(&state, low, high));
        y[i] = c205_from_double(between(&state, .2, most));
    }
    compute(routine, result, y);
    for (size_t i = 0; i < COUNT; i++) {
        oracle_value(&oracle_full, of_x, x[i]);
        oracle_value(&oracle_full, of_y, y[i]);
        exact(value, of_x, of_y);
        long place = absolute ? 0 : (long)mpfr_get_exp(value);
        double factor = exact != exact_power
                            ? 1
                            : 1 + fabs(c205_to_double(y[i])) + (double)labs(place);
        oracle_value(&oracle_full, error, result[i]);
        mpfr_sub(error, error, value, MPFR_RNDN);
        mpfr_mul_2si(error, error, 47 - place, MPFR_RNDN);
        greatest = fmax(greatest, fabs(mpfr_get_d(error, MPFR_RNDN)) / factor);
    }
    mpfr_clears(of_x, of_y, value, error, (mpfr_ptr)NULL);
    printf("%5.2f units for x from %g to %g\n", greatest, low, high);
    FAIL_IF(!(greatest <= units), "off by %g units, not %g, for x from %g to %g",
            greatest, units, low, high);
}

TEST(powers)
{
    check(power_routine, exact_power, .001, 1, 10, 3, false);
    check(power_routine, exact_power, .5, 1, 400, 3, false);
}

TEST(powers_of_two)
{
    check(two_to_routine, exact_two_to, -1, 0, 1, 2, false);
    check(two_to_routine, exact_two_to, -900, 0, 1, 2, false);
}

TEST(sines)
{
    check(sine_routine, exact_sine, 0, 1, 1, 5, true);
    check(sine_routine, exact_sine, -100, 100, 1, 5, true);
}

ARGUMENTS(argc, argv)
{
    if (argc > 1)
        state ^= strtoull(argv[1], NULL, 10) * UINT64_C(0x9E3779B97F4A7C15);
}

GROUP(set_up_both, tear_down_both);
