/* arithmetic_oracle.c - the rules of docs/arithmetic.md, computed with GMP and MPFR. */
#include "arithmetic_oracle.h"

#include <assert.h>
#include <gmp.h>

/* GMP's short operands have type long, so the host's long must have 64 bits. */
typedef char long_holds_a_word[sizeof(long) == sizeof(c205_word) ? 1 : -1];

const struct oracle_format oracle_full = { 64, 47, -28672, 28671 };
const struct oracle_format oracle_half = { 32, 23, -112, 111 };
const struct oracle_format oracle_narrow = { 14, 7, -28, 27 };

/* ---- Numbers ------------------------------------------------------------ */

enum kind { MACHINE_ZERO, NUMBER, INDEFINITE };

struct number {
    enum kind kind;
    long exponent;
    mpz_t coefficient;
};

/* The operands and a long register. All rules use these variables. */
static struct number left, right;
static mpz_t wide, aligned, complement;
static c205_word special; /* the result, if it is a special result of a product or
                           * quotient */
static mpfr_t left_value, right_value, radicand, root;

void oracle_begin(void)
{
    mpz_inits(left.coefficient, right.coefficient, wide, aligned, complement, NULL);
    mpfr_inits2(48, left_value, right_value, (mpfr_ptr)NULL);
    mpfr_init2(radicand, 96);
    mpfr_init(root);
}

void oracle_end(void)
{
    mpz_clears(left.coefficient, right.coefficient, wide, aligned, complement, NULL);
    mpfr_clears(left_value, right_value, radicand, root, (mpfr_ptr)NULL);
    mpfr_free_cache();
}

/* Returns the first bits as a two's complement number. */
static long first_bits(c205_word word, long bits)
{
    long number = (long)(word >> (64 - bits));
    return word >> 63 == 1 ? number - (1l << bits) : number;
}

static void take(struct number *number, const struct oracle_format *format,
                 c205_word word)
{
    long exponent_bits = format->width - format->digits - 1;
    number->kind = word >> 60 == 8   ? MACHINE_ZERO
                   : word >> 60 == 7 ? INDEFINITE
                                     : NUMBER;
    number->exponent = first_bits(word, exponent_bits);
    mpz_set_si(number->coefficient,
               first_bits(word << exponent_bits, format->digits + 1));
}

static void take_both(const struct oracle_format *format, c205_word a, c205_word b)
{
    take(&left, format, a);
    take(&right, format, b);
}

static bool either(enum kind kind)
{
    return left.kind == kind || right.kind == kind;
}

/* ---- Results ------------------------------------------------------------ */

static c205_word machine_zero(uint64_t *flags)
{
    *flags |= FLAG_MACHINE_ZERO;
    return C205_MACHINE_ZERO;
}

static c205_word indefinite(uint64_t cause, uint64_t *flags)
{
    *flags |= cause | FLAG_INDEFINITE;
    return C205_INDEFINITE;
}

/* Returns the result of an operation that replaces special operands by standard
 * ones. */
static c205_word plain(enum kind kind, uint64_t *flags)
{
    return kind == INDEFINITE ? indefinite(0, flags) : machine_zero(flags);
}

/* Returns a machine zero or an indefinite unchanged, and sets its flag. */
static c205_word kept(c205_word word, enum kind kind, uint64_t *flags)
{
    if (kind == MACHINE_ZERO)
        *flags |= FLAG_MACHINE_ZERO;
    if (kind == INDEFINITE)
        *flags |= FLAG_INDEFINITE;
    return word;
}

/* Returns the least n for which -2^n <= c < 2^n. */
static long significant_bits(const mpz_t c)
{
    if (mpz_sgn(c) == 0 || mpz_cmp_si(c, -1) == 0)
        return 0;
    if (mpz_sgn(c) > 0)
        return (long)mpz_sizeinbase(c, 2);
    mpz_com(complement, c); /* -2^n <= c is equivalent to -c - 1 < 2^n */
    return (long)mpz_sizeinbase(complement, 2);
}

/* Applies the range rule to a coefficient that fits, and returns the word. */
static c205_word make(const struct oracle_format *format, const mpz_t coefficient,
                      long exponent, uint64_t *flags)
{
    long coefficient_bits = format->digits + 1;
    c205_word end = 1ul << (coefficient_bits - 1) << 1;
    if (exponent > format->exponent_max)
        return indefinite(FLAG_EXPONENT_OVERFLOW, flags);
    if (exponent < format->exponent_min)
        return machine_zero(flags);
    assert(significant_bits(coefficient) <= format->digits);
    c205_word c = (c205_word)mpz_get_si(coefficient) % end;
    return ((c205_word)exponent * end + c) << (64 - format->width);
}

/* Sets c to floor(c / 2^k). k may be negative. */
static void scale_down(mpz_t c, long k)
{
    if (k >= 0)
        mpz_fdiv_q_2exp(c, c, (mp_bitcnt_t)k);
    else
        mpz_mul_2exp(c, c, (mp_bitcnt_t)-k);
}

/* Shortens a coefficient that is one bit too long. Returns its exponent. */
static long shorten(const struct oracle_format *format, mpz_t c, long exponent)
{
    if (significant_bits(c) <= format->digits)
        return exponent;
    scale_down(c, 1);
    return exponent + 1;
}

/* Returns the word of wide * 2^exponent with the given number of significant bits. */
static c205_word make_significant(const struct oracle_format *format, long bits,
                                  long exponent, uint64_t *flags)
{
    long k = significant_bits(wide) - bits;
    if (mpz_sgn(wide) == 0)
        return machine_zero(flags);
    scale_down(wide, k);
    assert(significant_bits(wide) == bits);
    return make(format, wide, exponent + k, flags);
}

static long less_significant_operand(void)
{
    long a = significant_bits(left.coefficient);
    long b = significant_bits(right.coefficient);
    long s = a < b ? a : b;
    return s < 1 ? 1 : s;
}

/* ---- Add, subtract ------------------------------------------------------ */

enum form { UPPER, LOWER, NORMALISED };

/* Shifts a coefficient to the position of the larger exponent. Bits shifted out of the
 * register's high part go to its low part. Bits below it are lost. */
static void align(mpz_t place, const struct oracle_format *format,
                  const struct number *number, long exponent)
{
    mpz_mul_2exp(place, number->coefficient, (mp_bitcnt_t)format->digits);
    scale_down(place, exponent - number->exponent);
}

/* Replaces a machine zero by the coefficient 0 with the exponent of the other operand. */
static void weaken(struct number *number, long exponent)
{
    number->exponent = exponent;
    mpz_set_si(number->coefficient, 0);
}

/* Computes the exact sum or difference in a signed register. Returns its exponent. */
static long add_aligned(const struct oracle_format *format, bool subtract)
{
    if (left.kind == MACHINE_ZERO)
        weaken(&left, right.exponent);
    if (right.kind == MACHINE_ZERO)
        weaken(&right, left.exponent);
    long exponent = left.exponent > right.exponent ? left.exponent : right.exponent;
    align(wide, format, &left, exponent);
    align(aligned, format, &right, exponent);
    if (subtract)
        mpz_sub(wide, wide, aligned);
    else
        mpz_add(wide, wide, aligned);
    if (significant_bits(wide) <= 2 * format->digits)
        return exponent;
    scale_down(wide, 1);
    return exponent + 1;
}

static c205_word normalised_sum(const struct oracle_format *format, long exponent,
                                uint64_t *flags)
{
    if (mpz_sgn(wide) == 0)
        return machine_zero(flags);
    long places = 2 * format->digits - significant_bits(wide);
    scale_down(wide, -places);
    scale_down(wide, format->digits);
    return make(format, wide, exponent - places, flags);
}

static c205_word add(const struct oracle_format *format, c205_word a, c205_word b,
                     bool subtract, enum form form, uint64_t *flags)
{
    take_both(format, a, b);
    if (either(INDEFINITE))
        return indefinite(0, flags);
    if (left.kind == MACHINE_ZERO && right.kind == MACHINE_ZERO)
        return machine_zero(flags);
    long exponent = add_aligned(format, subtract);
    if (form == NORMALISED)
        return normalised_sum(format, exponent, flags);
    if (form == LOWER) {
        mpz_fdiv_r_2exp(wide, wide, (mp_bitcnt_t)format->digits);
        return make(format, wide, exponent - format->digits, flags);
    }
    scale_down(wide, format->digits);
    return make(format, wide, exponent, flags);
}

#define SUM(name, subtract, form) \
    ORACLE_RULE(name) \
    { \
        return add(format, a, b, subtract, form, flags); \
    }

SUM(add_upper, false, UPPER)
SUM(add_lower, false, LOWER)
SUM(add_normalised, false, NORMALISED)
SUM(subtract_upper, true, UPPER)
SUM(subtract_lower, true, LOWER)
SUM(subtract_normalised, true, NORMALISED)

static c205_word halve(const struct oracle_format *format, c205_word sum,
                       uint64_t *flags)
{
    take(&left, format, sum);
    if (left.kind != NUMBER)
        return sum;
    return make(format, left.coefficient, left.exponent - 1, flags);
}

ORACLE_RULE(average)
{
    return halve(format, oracle_add_normalised(format, a, b, flags), flags);
}

ORACLE_RULE(average_difference)
{
    return halve(format, oracle_subtract_normalised(format, a, b, flags), flags);
}

/* ---- Multiply ----------------------------------------------------------- */

/* Computes the product in `wide`. Returns false after setting a special result. */
static bool multiply(const struct oracle_format *format, c205_word a, c205_word b,
                     uint64_t *flags)
{
    take_both(format, a, b);
    if (either(INDEFINITE))
        special = indefinite(0, flags);
    else if (either(MACHINE_ZERO))
        special = machine_zero(flags);
    else
        mpz_mul(wide, left.coefficient, right.coefficient);
    return !either(INDEFINITE) && !either(MACHINE_ZERO);
}

ORACLE_RULE(multiply_upper)
{
    if (!multiply(format, a, b, flags))
        return special;
    long exponent = left.exponent + right.exponent + format->digits;
    scale_down(wide, format->digits);
    return make(format, wide, shorten(format, wide, exponent), flags);
}

ORACLE_RULE(multiply_lower)
{
    if (!multiply(format, a, b, flags))
        return special;
    mpz_fdiv_r_2exp(wide, wide, (mp_bitcnt_t)format->digits);
    return make(format, wide, left.exponent + right.exponent, flags);
}

ORACLE_RULE(multiply_significant)
{
    if (!multiply(format, a, b, flags))
        return special;
    return make_significant(format, less_significant_operand(),
                            left.exponent + right.exponent, flags);
}

/* ---- Divide ------------------------------------------------------------- */

/* Computes the quotient in `wide`. Returns false after setting a special result. */
static bool divide(const struct oracle_format *format, c205_word a, c205_word b,
                   uint64_t *flags)
{
    take_both(format, a, b);
    if (either(INDEFINITE))
        special = indefinite(0, flags);
    else if (right.kind == MACHINE_ZERO || mpz_sgn(right.coefficient) == 0)
        special = indefinite(FLAG_DIVIDE_FAULT, flags);
    else if (left.kind == MACHINE_ZERO)
        special = machine_zero(flags);
    else {
        mpz_mul_2exp(wide, left.coefficient, (mp_bitcnt_t)format->digits);
        mpz_tdiv_q(wide, wide, right.coefficient);
        return true;
    }
    return false;
}

ORACLE_RULE(divide_upper)
{
    if (!divide(format, a, b, flags))
        return special;
    long exponent = left.exponent - right.exponent - format->digits;
    for (; significant_bits(wide) > format->digits; exponent++)
        scale_down(wide, 1);
    return make(format, wide, exponent, flags);
}

ORACLE_RULE(divide_significant)
{
    if (!divide(format, a, b, flags))
        return special;
    return make_significant(format, less_significant_operand(),
                            left.exponent - right.exponent - format->digits, flags);
}

/* ---- Square root -------------------------------------------------------- */

ORACLE_RULE(square_root)
{
    take(&left, format, a);
    if (left.kind == INDEFINITE)
        return indefinite(0, flags);
    if (left.kind == MACHINE_ZERO || mpz_sgn(left.coefficient) == 0)
        return machine_zero(flags);
    if (mpz_sgn(left.coefficient) < 0)
        return indefinite(FLAG_IMAGINARY_ROOT, flags);
    long places = format->digits - significant_bits(left.coefficient);
    scale_down(left.coefficient, -places);
    long exponent = left.exponent - places;
    long odd = (exponent - format->digits) % 2 != 0;
    long k = format->digits - odd;
    /* The root has exactly this number of digits, so rounding down gives the floor. */
    mpfr_set_prec(root, format->digits);
    mpfr_set_z_2exp(radicand, left.coefficient, k, MPFR_RNDD);
    mpfr_sqrt(root, radicand, MPFR_RNDD);
    mpfr_get_z(wide, root, MPFR_RNDD);
    scale_down(wide, places);
    return make(format, wide, (exponent - k) / 2 + places, flags);
}

/* ---- Parts of a number, sign -------------------------------------------- */

typedef void cut_fraction(mpz_t q, const mpz_t n, mp_bitcnt_t places);

static c205_word integer_part(const struct oracle_format *format, c205_word a,
                              cut_fraction *cut, uint64_t *flags)
{
    take(&left, format, a);
    if (left.kind != NUMBER || left.exponent >= 0)
        return kept(a, left.kind, flags);
    cut(wide, left.coefficient, (mp_bitcnt_t)-left.exponent);
    return make(format, wide, 0, flags);
}

#define INTEGER_PART(name, cut) \
    ORACLE_RULE(name) \
    { \
        return integer_part(format, a, cut, flags); \
    }

INTEGER_PART(truncate, mpz_tdiv_q_2exp)
INTEGER_PART(floor, mpz_fdiv_q_2exp)
INTEGER_PART(ceiling, mpz_cdiv_q_2exp)

/* Special words are negated, too. The range rule returns their special result. An
 * operand that is not a number causes no exponent overflow. */
ORACLE_RULE(negate)
{
    take(&left, format, a);
    if (left.kind != NUMBER)
        return plain(left.kind, flags);
    mpz_neg(wide, left.coefficient);
    if (mpz_cmp_si(wide, 1l << format->digits) == 0) {
        mpz_set_si(wide, 1l << (format->digits - 1));
        return make(format, wide, left.exponent + 1, flags);
    }
    if (mpz_cmp_si(wide, -(1l << (format->digits - 1))) == 0) {
        mpz_set_si(wide, -(1l << format->digits));
        return make(format, wide, left.exponent - 1, flags);
    }
    return make(format, wide, left.exponent, flags);
}

ORACLE_RULE(absolute)
{
    take(&left, format, a);
    if (mpz_sgn(left.coefficient) >= 0)
        return kept(a, left.kind, flags);
    return oracle_negate(format, a, b, flags);
}

ORACLE_RULE(exponent)
{
    take(&left, format, a);
    mpz_set_si(wide, left.exponent);
    return make(format, wide, 0, flags);
}

/* ---- Adjust ------------------------------------------------------------- */

/* Shifts the coefficient left, one place at a time, while it fits. Shifts by up to
 * `wanted` and up to `limit` places. Returns the number of places. */
static long shift_left(const struct oracle_format *format, long wanted, long limit)
{
    long places = 0;
    while (places < wanted && places < limit
           && significant_bits(left.coefficient) < format->digits) {
        scale_down(left.coefficient, -1);
        places++;
    }
    return places;
}

/* Shifts the coefficient right. After 100 places only the sign is left. */
static void shift_right(long places)
{
    scale_down(left.coefficient, places > 100 ? 100 : places);
}

ORACLE_RULE(adjust_significance)
{
    take_both(format, a, b);
    long places = mpz_get_si(right.coefficient);
    if (left.kind != NUMBER)
        return plain(left.kind, flags);
    if (places > 0)
        places = shift_left(format, places, format->digits);
    else
        shift_right(-places);
    return make(format, left.coefficient, left.exponent - places, flags);
}

ORACLE_RULE(adjust_exponent)
{
    take_both(format, a, b);
    long exponent = mpz_get_si(right.coefficient);
    long places = left.exponent - exponent;
    if (left.kind != NUMBER)
        return plain(left.kind, flags);
    if (places <= 0)
        shift_right(-places);
    else if (mpz_sgn(left.coefficient) != 0
             && shift_left(format, places, places) < places)
        return indefinite(FLAG_EXPONENT_OVERFLOW, flags);
    return make(format, left.coefficient, exponent, flags);
}

/* ---- Between the sizes -------------------------------------------------- */

/* Shortens a word to a half word. `addend` rounds the result; 0 truncates it. */
static c205_word contract(c205_word a, unsigned long addend, uint64_t *flags)
{
    long places = oracle_full.digits - oracle_half.digits;
    take(&left, &oracle_full, a);
    if (left.kind != NUMBER)
        return plain(left.kind, flags);
    mpz_add_ui(wide, left.coefficient, addend);
    scale_down(wide, places);
    long exponent = shorten(&oracle_half, wide, left.exponent + places);
    return make(&oracle_half, wide, exponent, flags);
}

ORACLE_RULE(contract)
{
    return contract(a, 0, flags);
}

ORACLE_RULE(contract_rounded)
{
    return contract(a, 1ul << 23, flags);
}

ORACLE_RULE(extend)
{
    long places = oracle_full.digits - oracle_half.digits;
    take(&left, &oracle_half, a);
    if (left.kind != NUMBER)
        return plain(left.kind, flags);
    scale_down(left.coefficient, -places);
    return make(&oracle_full, left.coefficient, left.exponent - places, flags);
}

/* ---- Compare ------------------------------------------------------------ */

void oracle_value(const struct oracle_format *format, mpfr_t value, c205_word word)
{
    take(&left, format, word);
    if (left.kind == INDEFINITE)
        mpfr_set_nan(value);
    else if (left.kind == MACHINE_ZERO)
        mpfr_set_zero(value, 1);
    else
        mpfr_set_z_2exp(value, left.coefficient, left.exponent, MPFR_RNDD);
}

/* MPFR's predicates are false for NaN, the machine's are false for indefinite. */
#define COMPARISON(name, holds) \
    ORACLE_RULE(name) \
    { \
        oracle_value(format, left_value, a); \
        oracle_value(format, right_value, b); \
        return (holds(left_value, right_value)) != 0; \
    }

COMPARISON(equal, mpfr_equal_p)
COMPARISON(not_equal, !mpfr_equal_p)
COMPARISON(not_less, mpfr_greaterequal_p)
COMPARISON(less, mpfr_less_p)

/* ---- Values and words --------------------------------------------------- */

c205_word oracle_word(const struct oracle_format *format, const mpfr_t value)
{
    uint64_t flags = 0;
    if (!mpfr_number_p(value))
        return C205_INDEFINITE;
    if (mpfr_zero_p(value))
        return C205_MACHINE_ZERO;
    long exponent = mpfr_get_z_2exp(wide, value);
    return make_significant(format, format->digits, exponent, &flags);
}
