/* test_library_functions.c - results of the routines of asm/lib are compared between
 * both forms, bit for bit, in strips and in place. They are also compared with exact
 * values, within the errors of docs/functions.md. A form with another rounding, or a
 * larger error, fails here.
 *
 *     test_library_functions [TRIES [SEED]]
 */
#include "tests/oracle/arithmetic_oracle.h"
#include "tests/oracle/chance.h"
#include "tests/unit/exact_functions.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/saved_machine.h"

#include <inttypes.h>
#include <limits.h>

enum { STRIP = 48, MAX = 60000, DIGITS = 200, EXPONENTS = 28672, AT_END = 60 };

static size_t tries = 6000;
static uint64_t state = RANDOM_SEED;

static const struct function {
    const char *name;
    int arguments;
    exact_function *exact;
    double units;   /* largest error in units of the last place; for power: divided by 1
                     * + |y| / 32 */
    double near[3]; /* multiples of these numbers are critical arguments */
} functions[] = {
    { "exp", 1, exact_exp, 2, { 0.34657359027997264, 19873.7, 1 } },
    { "log", 1, exact_log, 3, { 0.70710678118654757, 1, 2 } },
    { "sin", 1, exact_sin, 2, { 0.78539816339744828, 13176794, 1 } },
    { "cos", 1, exact_cos, 3, { 0.78539816339744828, 13176794, 1 } },
    { "atan2", 2, exact_atan2, 3, { 0.41421356237309503, 1, 1e-9 } },
    { "power", 2, exact_power, 4, { 1, 2, 0.70710678118654757 } },
};

enum { FUNCTIONS = COUNT(functions) };

/* ---- Arguments ----------------------------------------------------------- */

static c205_word special(void)
{
    static const uint64_t words[] = {
        0,
        C205_MACHINE_ZERO,
        C205_INDEFINITE,
        UINT64_C(0x8123456789ABCDEF),
        UINT64_C(0x7FFFFFFFFFFFFFFF),
        UINT64_C(0xFFD2400000000000), /* 1 */
        UINT64_C(0xFFD1800000000000), /* -1 */
        UINT64_C(0x6FFF7FFFFFFFFFFF),
        UINT64_C(0x6FFF800000000000),
        UINT64_C(0x9000400000000000),
        UINT64_C(0x9000000000000001),
    };
    return words[below(&state, COUNT(words))];
}

/* Returns a word within two units of the last place of a multiple of `near`. */
static c205_word beside(double near)
{
    double number = near * (double)xorshift_between(&state, -40, 40);
    if (one_in(&state, 3))
        number *= (double)xorshift_between(&state, 1, 1 << 20);
    return c205_from_double(number) + (c205_word)xorshift_between(&state, -2, 2);
}

static c205_word draw(const struct function *function)
{
    switch (below(&state, 10)) {
    case 0: return special();
    case 1: return xorshift(&state);
    case 2: return xorshift_unnormalised(&state, -70, -20);
    case 3:
        return c205_from_integer(
            xorshift_between(&state, -100, 100)
            * (one_in(&state, 4) ? xorshift_between(&state, 1, 1 << 30) : 1));
    case 4: return xorshift_normalised(&state, -EXPONENTS, EXPONENTS - 1);
    case 5:
    case 6: return beside(function->near[below(&state, 3)]);
    case 7: return xorshift_normalised(&state, -80, -23);
    default: return xorshift_normalised(&state, -50, -44);
    }
}

/* Returns a random second argument. It is equal or close to the first argument, its
 * negative, zero, or another number. */
static c205_word draw_second(const struct function *function, c205_word first)
{
    uint64_t flags = 0;
    switch (below(&state, 8)) {
    case 0: return first + (c205_word)xorshift_between(&state, -3, 3);
    case 1: return arith_subtract_normalised(0, first, &flags);
    case 2: return C205_MACHINE_ZERO;
    case 3:
        return arith_multiply_significant(first, c205_from_double(function->near[0]),
                                          &flags);
    default: return draw(function);
    }
}

/* ---- Both forms ---------------------------------------------------------- */

static const char text[] = "        .equ    F_STRIP, %d\n"
                           "        .include \"%s.s\"\n"
                           "        .data\n"
                           "        .vector xs, %zu\n"
                           "        .vector ys, %zu\n"
                           "        .vector numbers, %zu\n"
                           "        .vector rests, %zu\n"
                           "        .vector vectors, %zu\n"
                           "        .vector others, %zu\n"
                           "        .code\n"
                           "        .regs   r10, x, y, r, s, i, one, n\n"
                           "        EX      x, xs\n"
                           "        EX      y, ys\n"
                           "        EX      r, numbers\n"
                           "        EX      s, rests\n"
                           "        ES      i, 0\n"
                           "        ES      one, 1\n"
                           "        EX      n, %zu\n"
                           "        BIM     next\n"
                           "each:   LOD     [x, i], f_x\n"
                           "        LOD     [y, i], f_y\n"
                           "        call    %s, f_link, f_target\n"
                           "        STO     [r, i], f_r\n"
                           "        STO     [s, i], f_s\n"
                           "        ADDX    i, one, i\n"
                           "next:   IBXLT   i, r0, n, each\n"
                           "        descriptor f_x, xs, %zu\n"
                           "        descriptor f_y, ys, %zu\n"
                           "        descriptor f_r, %s, %zu\n"
                           "        descriptor f_s, others, %zu\n"
                           "        call    v%s, f_link, f_target\n"
                           "        EXIT\n";

/* Arguments and results of both forms. The vector form writes to a label. */
struct both {
    size_t count;
    c205_word x[MAX], y[MAX];
    c205_word number[MAX], rest[MAX], vector[MAX], other[MAX];
};

static struct both both;

static void draw_arguments(const struct function *function, size_t count)
{
    both.count = count;
    for (size_t i = 0; i < count; i++) {
        both.x[i] = draw(function);
        both.y[i] = draw_second(function, both.x[i]);
    }
}

static void copy_words(c205 *machine, const struct object *object, const char *label,
                       c205_word *words, bool in)
{
    uint64_t address = (uint64_t)object_symbol(object, label)->value;
    bool done = in ? c205_write(machine, address, words, both.count)
                   : c205_read(machine, address, words, both.count);
    assert_true(done);
}

static void compute(const char *name, const char *result)
{
    static char program[4096];
    const char *file = strcmp(name, "cos") == 0 ? "sin" : name;
    size_t n = both.count;
    snprintf(program, sizeof program, text, STRIP, file, n, n, n, n, n, n, n, name, n,
             n, result, n, n, name);
    SCOPED(object) *object = good(program);
    SCOPED(c205) *machine = machine_with(&object->program, prior_model);
    copy_words(machine, object, "xs", both.x, true);
    copy_words(machine, object, "ys", both.y, true);
    assert_int_equal(c205_run(machine, C205_NO_LIMIT).trap, C205_TRAP_NONE);
    copy_words(machine, object, "numbers", both.number, false);
    copy_words(machine, object, "rests", both.rest, false);
    copy_words(machine, object, result, both.vector, false);
    copy_words(machine, object, "others", both.other, false);
    /* The registers with the vectors' descriptors are unchanged. */
    assert_int_equal(c205_register(machine, 212) >> 48, n);
    assert_int_equal(c205_register(machine, 212) << 16 >> 16,
                     object_symbol(object, result)->value);
    assert_int_equal(c205_register(machine, 210) >> 48, n);
}

static void check_forms(const char *name)
{
    for (size_t i = 0; i < both.count; i++) {
        if (both.number[i] != both.vector[i]) {
            fail_msg("%s of %016" PRIX64 ", %016" PRIX64 ": %016" PRIX64
                     " of numbers, %016" PRIX64 " of vectors",
                     name, both.x[i], both.y[i], both.number[i], both.vector[i]);
        }
    }
}

/* ---- Errors -------------------------------------------------------------- */

struct errors {
    double least, most; /* errors in units of the last place */
    size_t count;       /* number of numeric results */
};

/* Returns true if the result must be indefinite. */
static bool has_none(const struct function *function, const mpfr_t x, const mpfr_t y)
{
    if (mpfr_nan_p(x) || (function->arguments == 2 && mpfr_nan_p(y)))
        return true;
    if (function->exact == exact_log)
        return mpfr_sgn(x) <= 0;
    if (function->exact == exact_sin || function->exact == exact_cos)
        return mpfr_cmp_ui(x, 13176794) > 0 || mpfr_cmp_si(x, -13176794) < 0;
    if (function->exact == exact_atan2)
        return mpfr_zero_p(x) && mpfr_zero_p(y);
    if (function->exact == exact_power)
        return mpfr_sgn(x) < 0 || (mpfr_zero_p(x) && mpfr_sgn(y) <= 0);
    return false;
}

/* Returns the exponent of a word with this value, the least one for zero. */
static long exponent_of(const mpfr_t exact)
{
    return mpfr_zero_p(exact) ? LONG_MIN / 2 : (long)mpfr_get_exp(exact) - 47;
}

static void check_value(const struct function *function, size_t i, const mpfr_t exact,
                        const mpfr_t y, struct errors *errors)
{
    c205_word word = both.number[i];
    double error, factor = 1; /* factor by which the error of a power grows */
    mpfr_t difference;
    mpfr_init2(difference, DIGITS);
    oracle_value(&oracle_full, difference, word);
    mpfr_sub(difference, difference, exact, MPFR_RNDN);
    mpfr_mul_2si(difference, difference, 47 - (long)mpfr_get_exp(exact), MPFR_RNDN);
    if (function->exact == exact_power)
        factor += fabs(mpfr_get_d(y, MPFR_RNDN)) / 32;
    error = mpfr_get_d(difference, MPFR_RNDN) / factor;
    mpfr_clear(difference);
    if (!(fabs(error) <= function->units)) {
        fail_msg("%s of %016" PRIX64 ", %016" PRIX64 " is %016" PRIX64
                 ", off by %g units of the last place",
                 function->name, both.x[i], both.y[i], word, error);
    }
    errors->least = fmin(errors->least, error);
    errors->most = fmax(errors->most, error);
    errors->count++;
}

/* Sets `value` to a word's value, or to 0 if it is too small to be normalised. */
static void value_of(mpfr_t value, c205_word word)
{
    uint64_t flags = 0;
    oracle_value(&oracle_full, value,
                 oracle_add_normalised(&oracle_full, word, C205_MACHINE_ZERO, &flags));
}

static void check_result(const struct function *function, size_t i,
                         struct errors *errors)
{
    c205_word word = both.number[i];
    mpfr_t x, y, exact;
    bool good = true, overflows = false;
    mpfr_inits2(DIGITS, x, y, exact, (mpfr_ptr)NULL);
    value_of(x, both.x[i]);
    value_of(y, both.y[i]);
    if (has_none(function, x, y)) {
        good = word == C205_INDEFINITE;
    } else {
        function->exact(exact, x, y);
        /* In atan2 a sum, and in power a product, may be out of range. */
        if (function->exact == exact_atan2)
            overflows = (!mpfr_zero_p(x) && labs(exponent_of(x)) >= EXPONENTS - AT_END)
                        || (!mpfr_zero_p(y)
                            && labs(exponent_of(y)) >= EXPONENTS - AT_END);
        if (function->exact == exact_power)
            overflows = exponent_of(y) >= EXPONENTS - AT_END;
        if (overflows)
            good = true;
        else if (mpfr_inf_p(exact) || exponent_of(exact) > EXPONENTS + AT_END)
            good = word == C205_INDEFINITE;
        else if (exponent_of(exact) < -EXPONENTS - AT_END)
            good = word == C205_MACHINE_ZERO;
        else if (labs(exponent_of(exact)) > EXPONENTS - AT_END)
            good = true; /* either result is allowed near the limit */
        else
            check_value(function, i, exact, y, errors);
    }
    mpfr_clears(x, y, exact, (mpfr_ptr)NULL);
    if (!good) {
        fail_msg("%s of %016" PRIX64 ", %016" PRIX64 " is %016" PRIX64, function->name,
                 both.x[i], both.y[i], word);
    }
}

TEST(errors)
{
    static const char *const results[] = { "vectors", "xs", "ys" };
    printf("function   results   off by, units of the last place\n");
    for (size_t f = 0; f < FUNCTIONS; f++) {
        struct errors errors = { 0, 0, 0 };
        draw_arguments(&functions[f], tries);
        for (size_t k = 0; k < 3; k++) {
            compute(functions[f].name, results[k]);
            check_forms(functions[f].name);
        }
        for (size_t i = 0; i < tries; i++)
            check_result(&functions[f], i, &errors);
        assert_true(errors.count > tries / 20);
        printf("%-8s %9zu   %5.2f to %4.2f\n", functions[f].name, errors.count,
               errors.least, errors.most);
    }
}

/* Vectors of all lengths near multiples of the length of a strip. */
TEST(lengths)
{
    for (size_t count = 0; count < 3 * STRIP; count += count % 7 + 1) {
        const struct function *function = &functions[below(&state, FUNCTIONS)];
        draw_arguments(function, count);
        compute(function->name, "vectors");
        check_forms(function->name);
    }
}

/* (2^a)^n is exact. */
TEST(powers_of_two)
{
    both.count = 500;
    for (size_t i = 0; i < both.count; i++) {
        both.x[i] = c205_from_double(ldexp(1, (int)xorshift_between(&state, -20, 20)));
        both.y[i] = c205_from_integer(xorshift_between(&state, -40, 40));
    }
    compute("power", "vectors");
    check_forms("power");
    for (size_t i = 0; i < both.count; i++) {
        double exact = pow(c205_to_double(both.x[i]),
                           (double)c205_to_integer(both.y[i]));
        assert_int_equal(both.number[i], c205_from_double(exact));
    }
}

/* ---- Integers ------------------------------------------------------------ */

static int64_t draw_integer(void)
{
    int64_t most = (INT64_C(1) << xorshift_between(&state, 1, 47)) - 1;
    return one_in(&state, 6) ? most : xorshift_between(&state, -most, most);
}

/* Truncates a word to an integer. Returns false if its magnitude is 2^47 or more. */
static bool is_integer(c205_word word, int64_t *integer)
{
    uint64_t flags = 0;
    c205_word cut = oracle_truncate(&oracle_full,
                                    oracle_add_normalised(&oracle_full, word,
                                                          C205_MACHINE_ZERO, &flags),
                                    0, &flags);
    *integer = 0;
    if (word >> 60 == 7 || fabs(c205_to_double(cut)) >= 0x1p47)
        return false;
    *integer = (int64_t)c205_to_double(cut);
    return true;
}

TEST(quotients)
{
    both.count = tries;
    for (size_t i = 0; i < tries; i++) {
        int64_t y = draw_integer();
        int64_t times = y ? draw_integer() / y : 0;
        int64_t x = one_in(&state, 2) ? times * y : draw_integer();
        x += xorshift_between(&state, -1, 1);
        x = x >= INT64_C(1) << 47 || -x >= INT64_C(1) << 47 ? y : x;
        both.x[i] = c205_from_integer(x);
        both.y[i] = c205_from_integer(one_in(&state, 50) ? 0 : y);
        if (one_in(&state, 4))
            both.x[i] = c205_from_double((double)x + between(&state, -1, 1));
        if (one_in(&state, 20))
            both.x[i] = one_in(&state, 2) ? special() : xorshift(&state);
        if (one_in(&state, 20))
            both.y[i] = one_in(&state, 2) ? special() : xorshift(&state);
        if (one_in(&state, 50))
            both.x[i] = UINT64_C(0x0000800000000000); /* -2^47 */
    }
    compute("divide", "vectors");
    check_forms("divide");
    for (size_t i = 0; i < tries; i++) {
        int64_t x, y;
        bool good = is_integer(both.x[i], &x) & is_integer(both.y[i], &y);
        c205_word quotient = good && y ? c205_from_integer(x / y) : C205_INDEFINITE;
        c205_word rest = good && y ? c205_from_integer(x % y) : C205_INDEFINITE;
        if (both.number[i] != quotient || both.rest[i] != rest
            || both.other[i] != rest) {
            fail_msg("%" PRId64 " / %" PRId64 " is %016" PRIX64 ", remains %016" PRIX64
                     " of numbers, %016" PRIX64 " of vectors",
                     x, y, both.number[i], both.rest[i], both.other[i]);
        }
    }
}

/* ---- Constants ----------------------------------------------------------- */

/* Returns the largest word not above a value, as the assembler converts decimals. */
static c205_word word_below(const mpfr_t value)
{
    mpfr_t cut;
    mpfr_init2(cut, 47);
    mpfr_set(cut, value, MPFR_RNDD);
    c205_word word = oracle_word(&oracle_full, cut);
    mpfr_clear(cut);
    return word;
}

TEST(polynomials)
{
    SCOPED(object) *object = good(
        "        .include \"exp.s\"\n        .include \"log.s\"\n"
        "        .include \"sin.s\"\n        .include \"atan2.s\"\n"
        "        .include \"power.s\"\n        EXIT\n");
    const struct exact_polynomial *polynomial;
    for (size_t i = 0; (polynomial = exact_polynomial_at(i)) != NULL; i++) {
        mpfr_t exact[EXACT_COEFFICIENTS];
        uint64_t at = (uint64_t)object_symbol(object, polynomial->label)->value;
        exact_coefficients(polynomial, exact);
        for (size_t k = 0; k < polynomial->count; k++) {
            c205_word word = word_of(&object->program, at + 64 * k);
            if (word != word_below(exact[k])) {
                fail_msg("%s, %zu: %016" PRIX64 " should be %016" PRIX64,
                         polynomial->label, k, word, word_below(exact[k]));
            }
            mpfr_clear(exact[k]);
        }
    }
}

/* The factors of power.s, and their logarithms in two parts: the first 30 binary digits
 * after the point, and the rest. */
TEST(factors)
{
    enum { FACTORS = 33 };
    SCOPED(object) *object = good("        .include \"power.s\"\n        EXIT\n");
    const c205_program *program = &object->program;
    uint64_t c = (uint64_t)object_symbol(object, "power.factors")->value;
    uint64_t high = (uint64_t)object_symbol(object, "power.high")->value;
    uint64_t low = (uint64_t)object_symbol(object, "power.low")->value;
    mpfr_t exact, part;
    mpfr_inits2(DIGITS, exact, part, (mpfr_ptr)NULL);
    for (uint64_t j = 0; j < FACTORS; j++) {
        double factor = floor(64 * 32 / (32.0 + (double)j) + 0.5) / 64;
        assert_int_equal(word_of(program, c + 64 * j), c205_from_double(factor));
        mpfr_set_ui(exact, 1, MPFR_RNDN);
        mpfr_div_d(exact, exact, factor, MPFR_RNDN);
        mpfr_log2(exact, exact, MPFR_RNDN);
        mpfr_mul_2si(part, exact, 30, MPFR_RNDN);
        mpfr_floor(part, part);
        mpfr_div_2si(part, part, 30, MPFR_RNDN);
        assert_int_equal(word_of(program, high + 64 * j), word_below(part));
        mpfr_sub(part, exact, part, MPFR_RNDN);
        assert_int_equal(word_of(program, low + 64 * j), word_below(part));
    }
    mpfr_clears(exact, part, (mpfr_ptr)NULL);
}

FIXTURE(begin_all)
{
    oracle_begin();
    mpfr_set_emin(mpfr_get_emin_min());
    mpfr_set_emax(mpfr_get_emax_max());
    return set_up_model(test_state);
}

FIXTURE(end_all)
{
    oracle_end();
    return tear_down_model(test_state);
}

ARGUMENTS(argc, argv)
{
    if (argc > 1) {
        tries = (size_t)strtoul(argv[1], NULL, 10);
        tries = tries < MAX ? tries : MAX;
    }
    if (argc > 2)
        state ^= strtoull(argv[2], NULL, 10) * UINT64_C(0x9E3779B97F4A7C15);
}

GROUP(begin_all, end_all);
