#include "arithmetic_oracle.h"

#include <assert.h>
#include <gmp.h>

/* GMP's short operands are longs; these tests want a host where a word is
 * one. */
typedef char long_holds_a_word[sizeof(long) == sizeof(c205_word) ? 1 : -1];

/* ---- Numbers ------------------------------------------------------------ */

enum kind { MACHINE_ZERO, NUMBER, INDEFINITE };

struct number {
    enum kind kind;
    long exponent;
    mpz_t coefficient;
};

/* The operands and one long register, used again by every rule. */
static struct number left, right;
static mpz_t wide, aligned, complement;
static mpfr_t left_value, right_value, radicand, root;

void oracle_begin(void)
{
    mpz_inits(left.coefficient, right.coefficient, wide, aligned,
              complement, NULL);
    mpfr_inits2(48, left_value, right_value, (mpfr_ptr)NULL);
    mpfr_init2(radicand, 96);
    mpfr_init2(root, 47);
}

void oracle_end(void)
{
    mpz_clears(left.coefficient, right.coefficient, wide, aligned,
               complement, NULL);
    mpfr_clears(left_value, right_value, radicand, root, (mpfr_ptr)NULL);
    mpfr_free_cache();
}

static void take(struct number *number, c205_word word)
{
    const unsigned long field = word >> 48;
    const unsigned long digits = word % (1ul << 48);

    number->kind = field / 4096 == 8   ? MACHINE_ZERO
                   : field / 4096 == 7 ? INDEFINITE
                                       : NUMBER;
    number->exponent = (long)field - (field >= 0x8000 ? 0x10000 : 0);
    mpz_set_si(number->coefficient,
               (long)digits - (digits >= 1ul << 47 ? 1l << 48 : 0));
}

static void take_both(c205_word a, c205_word b)
{
    take(&left, a);
    take(&right, b);
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

/* A special operand that is its own result. */
static c205_word kept(c205_word word, enum kind kind, uint64_t *flags)
{
    if (kind == MACHINE_ZERO)
        *flags |= FLAG_MACHINE_ZERO;
    if (kind == INDEFINITE)
        *flags |= FLAG_INDEFINITE;
    return word;
}

/* The word of a coefficient that fits, by the range rule. */
static c205_word make(const mpz_t coefficient, long exponent,
                      uint64_t *flags)
{
    if (exponent > 28671)
        return indefinite(FLAG_EXPONENT_OVERFLOW, flags);
    if (exponent < -28672)
        return machine_zero(flags);
    const long c = mpz_get_si(coefficient);
    assert(mpz_fits_slong_p(coefficient) && c >= -(1l << 47)
           && c < 1l << 47);
    return ((c205_word)exponent << 48) | ((c205_word)c % (1ul << 48));
}

/* The least n with -2^n <= c < 2^n. */
static long significant_bits(const mpz_t c)
{
    if (mpz_sgn(c) == 0 || mpz_cmp_si(c, -1) == 0)
        return 0;
    if (mpz_sgn(c) > 0)
        return (long)mpz_sizeinbase(c, 2);
    mpz_com(complement, c); /* -2^n <= c is -c - 1 < 2^n */
    return (long)mpz_sizeinbase(complement, 2);
}

/* floor(c / 2^k), k of either sign. */
static void scale_down(mpz_t c, long k)
{
    if (k >= 0)
        mpz_fdiv_q_2exp(c, c, (mp_bitcnt_t)k);
    else
        mpz_mul_2exp(c, c, (mp_bitcnt_t)-k);
}

/* wide x 2^exponent with the given number of significant bits. */
static c205_word make_significant(long bits, long exponent, uint64_t *flags)
{
    const long k = significant_bits(wide) - bits;

    scale_down(wide, k);
    assert(significant_bits(wide) == bits);
    return make(wide, exponent + k, flags);
}

static long less_significant_operand(void)
{
    const long a = significant_bits(left.coefficient);
    const long b = significant_bits(right.coefficient);
    const long s = a < b ? a : b;

    return s < 1 ? 1 : s;
}

/* ---- Add, subtract ------------------------------------------------------ */

enum form { UPPER, LOWER, NORMALISED };

/* To the place of the larger exponent, in the low part of the register
 * whatever falls below, the rest lost. */
static void align(mpz_t place, const struct number *number, long exponent)
{
    mpz_mul_2exp(place, number->coefficient, 47);
    scale_down(place, exponent - number->exponent);
}

/* A machine zero has the smallest exponent, and the coefficient 0. */
static void weaken(struct number *number, long exponent)
{
    number->exponent = exponent;
    mpz_set_si(number->coefficient, 0);
}

/* The sum or difference in the register of 95 bits; gives its exponent. */
static long add_aligned(bool subtract)
{
    if (left.kind == MACHINE_ZERO)
        weaken(&left, right.exponent);
    if (right.kind == MACHINE_ZERO)
        weaken(&right, left.exponent);
    long exponent = left.exponent > right.exponent ? left.exponent
                                                   : right.exponent;
    align(wide, &left, exponent);
    align(aligned, &right, exponent);
    if (subtract)
        mpz_sub(wide, wide, aligned);
    else
        mpz_add(wide, wide, aligned);
    if (significant_bits(wide) > 94) {
        scale_down(wide, 1);
        exponent++;
    }
    return exponent;
}

static c205_word normalised_sum(long exponent, uint64_t *flags)
{
    if (mpz_sgn(wide) == 0)
        return machine_zero(flags);
    const long places = 94 - significant_bits(wide);
    scale_down(wide, -places);
    scale_down(wide, 47);
    return make(wide, exponent - places, flags);
}

static c205_word add(c205_word a, c205_word b, bool subtract,
                     enum form form, uint64_t *flags)
{
    take_both(a, b);
    if (either(INDEFINITE))
        return indefinite(0, flags);
    if (left.kind == MACHINE_ZERO && right.kind == MACHINE_ZERO)
        return machine_zero(flags);
    const long exponent = add_aligned(subtract);
    if (form == NORMALISED)
        return normalised_sum(exponent, flags);
    if (form == LOWER) {
        mpz_fdiv_r_2exp(wide, wide, 47);
        return make(wide, exponent - 47, flags);
    }
    scale_down(wide, 47);
    return make(wide, exponent, flags);
}

c205_word oracle_add_upper(c205_word a, c205_word b, uint64_t *flags)
{
    return add(a, b, false, UPPER, flags);
}

c205_word oracle_add_lower(c205_word a, c205_word b, uint64_t *flags)
{
    return add(a, b, false, LOWER, flags);
}

c205_word oracle_add_normalised(c205_word a, c205_word b, uint64_t *flags)
{
    return add(a, b, false, NORMALISED, flags);
}

c205_word oracle_subtract_upper(c205_word a, c205_word b, uint64_t *flags)
{
    return add(a, b, true, UPPER, flags);
}

c205_word oracle_subtract_lower(c205_word a, c205_word b, uint64_t *flags)
{
    return add(a, b, true, LOWER, flags);
}

c205_word oracle_subtract_normalised(c205_word a, c205_word b,
                                     uint64_t *flags)
{
    return add(a, b, true, NORMALISED, flags);
}

static c205_word halve(c205_word sum, uint64_t *flags)
{
    take(&left, sum);
    if (left.kind != NUMBER)
        return sum;
    return make(left.coefficient, left.exponent - 1, flags);
}

c205_word oracle_average(c205_word a, c205_word b, uint64_t *flags)
{
    return halve(oracle_add_normalised(a, b, flags), flags);
}

c205_word oracle_average_difference(c205_word a, c205_word b,
                                    uint64_t *flags)
{
    return halve(oracle_subtract_normalised(a, b, flags), flags);
}

/* ---- Multiply ----------------------------------------------------------- */

/* False: the result is special, and in *word. */
static bool multiply(c205_word a, c205_word b, c205_word *word,
                     uint64_t *flags)
{
    take_both(a, b);
    if (either(INDEFINITE))
        *word = indefinite(0, flags);
    else if (either(MACHINE_ZERO))
        *word = machine_zero(flags);
    else
        mpz_mul(wide, left.coefficient, right.coefficient);
    return !either(INDEFINITE) && !either(MACHINE_ZERO);
}

c205_word oracle_multiply_upper(c205_word a, c205_word b, uint64_t *flags)
{
    c205_word special;

    if (!multiply(a, b, &special, flags))
        return special;
    long exponent = left.exponent + right.exponent + 47;
    scale_down(wide, 47);
    if (significant_bits(wide) > 47) {
        scale_down(wide, 1);
        exponent++;
    }
    return make(wide, exponent, flags);
}

c205_word oracle_multiply_lower(c205_word a, c205_word b, uint64_t *flags)
{
    c205_word special;

    if (!multiply(a, b, &special, flags))
        return special;
    mpz_fdiv_r_2exp(wide, wide, 47);
    return make(wide, left.exponent + right.exponent, flags);
}

c205_word oracle_multiply_significant(c205_word a, c205_word b,
                                      uint64_t *flags)
{
    c205_word special;

    if (!multiply(a, b, &special, flags))
        return special;
    if (mpz_sgn(wide) == 0)
        return machine_zero(flags);
    return make_significant(less_significant_operand(),
                            left.exponent + right.exponent, flags);
}

/* ---- Divide ------------------------------------------------------------- */

/* False: the result is special, and in *word. */
static bool divide(c205_word a, c205_word b, c205_word *word,
                   uint64_t *flags)
{
    take_both(a, b);
    if (either(INDEFINITE)) {
        *word = indefinite(0, flags);
        return false;
    }
    if (right.kind == MACHINE_ZERO || mpz_sgn(right.coefficient) == 0) {
        *word = indefinite(FLAG_DIVIDE_FAULT, flags);
        return false;
    }
    if (left.kind == MACHINE_ZERO) {
        *word = machine_zero(flags);
        return false;
    }
    mpz_mul_2exp(wide, left.coefficient, 47);
    mpz_tdiv_q(wide, wide, right.coefficient);
    return true;
}

c205_word oracle_divide_upper(c205_word a, c205_word b, uint64_t *flags)
{
    c205_word special;

    if (!divide(a, b, &special, flags))
        return special;
    long exponent = left.exponent - right.exponent - 47;
    for (; significant_bits(wide) > 47; exponent++)
        scale_down(wide, 1);
    return make(wide, exponent, flags);
}

c205_word oracle_divide_significant(c205_word a, c205_word b,
                                    uint64_t *flags)
{
    c205_word special;

    if (!divide(a, b, &special, flags))
        return special;
    if (mpz_sgn(wide) == 0)
        return machine_zero(flags);
    return make_significant(less_significant_operand(),
                            left.exponent - right.exponent - 47, flags);
}

/* ---- Square root -------------------------------------------------------- */

c205_word oracle_square_root(c205_word a, c205_word b, uint64_t *flags)
{
    (void)b;
    take(&left, a);
    if (left.kind == INDEFINITE)
        return indefinite(0, flags);
    if (left.kind == MACHINE_ZERO || mpz_sgn(left.coefficient) == 0)
        return machine_zero(flags);
    if (mpz_sgn(left.coefficient) < 0)
        return indefinite(FLAG_IMAGINARY_ROOT, flags);
    const long places = 47 - significant_bits(left.coefficient);
    scale_down(left.coefficient, -places);
    const long exponent = left.exponent - places;
    const long k = exponent % 2 == 0 ? 46 : 47;
    /* The root is of 47 bits, so that rounding it down to 47 is floor. */
    mpfr_set_z_2exp(radicand, left.coefficient, k, MPFR_RNDD);
    mpfr_sqrt(root, radicand, MPFR_RNDD);
    mpfr_get_z(wide, root, MPFR_RNDD);
    scale_down(wide, places);
    return make(wide, (exponent - k) / 2 + places, flags);
}

/* ---- Parts of a number, sign -------------------------------------------- */

typedef void cut_fraction(mpz_t q, const mpz_t n, mp_bitcnt_t places);

static c205_word integer_part(c205_word a, cut_fraction *cut,
                              uint64_t *flags)
{
    take(&left, a);
    if (left.kind != NUMBER || left.exponent >= 0)
        return kept(a, left.kind, flags);
    cut(wide, left.coefficient, (mp_bitcnt_t)-left.exponent);
    return make(wide, 0, flags);
}

c205_word oracle_truncate(c205_word a, c205_word b, uint64_t *flags)
{
    (void)b;
    return integer_part(a, mpz_tdiv_q_2exp, flags);
}

c205_word oracle_floor(c205_word a, c205_word b, uint64_t *flags)
{
    (void)b;
    return integer_part(a, mpz_fdiv_q_2exp, flags);
}

c205_word oracle_ceiling(c205_word a, c205_word b, uint64_t *flags)
{
    (void)b;
    return integer_part(a, mpz_cdiv_q_2exp, flags);
}

/* Of a special word too: the range rule makes the plain special of it, but
 * no exponent overflow where there was no number. */
c205_word oracle_negate(c205_word a, c205_word b, uint64_t *flags)
{
    (void)b;
    take(&left, a);
    if (left.kind == INDEFINITE)
        return indefinite(0, flags);
    if (left.kind == MACHINE_ZERO)
        return machine_zero(flags);
    mpz_neg(wide, left.coefficient);
    if (mpz_cmp_si(wide, 1l << 47) == 0) {
        mpz_set_si(wide, 1l << 46);
        return make(wide, left.exponent + 1, flags);
    }
    if (mpz_cmp_si(wide, -(1l << 46)) == 0) {
        mpz_set_si(wide, -(1l << 47));
        return make(wide, left.exponent - 1, flags);
    }
    return make(wide, left.exponent, flags);
}

c205_word oracle_absolute(c205_word a, c205_word b, uint64_t *flags)
{
    take(&left, a);
    if (mpz_sgn(left.coefficient) >= 0)
        return kept(a, left.kind, flags);
    return oracle_negate(a, b, flags);
}

c205_word oracle_exponent(c205_word a, c205_word b, uint64_t *flags)
{
    (void)b;
    take(&left, a);
    mpz_set_si(wide, left.exponent);
    return make(wide, 0, flags);
}

/* ---- Adjust, pack -------------------------------------------------------- */

/* A number shifted left, one place after the other, as far as it may be and
 * is wanted; limit: how far at the most. */
static long shift_left(long wanted, long limit)
{
    long places = 0;

    while (places < wanted && places < limit
           && significant_bits(left.coefficient) < 47) {
        scale_down(left.coefficient, -1);
        places++;
    }
    return places;
}

/* Past so many places only the sign is left. */
static void shift_right(long places)
{
    scale_down(left.coefficient, places > 100 ? 100 : places);
}

c205_word oracle_adjust_significance(c205_word a, c205_word b,
                                     uint64_t *flags)
{
    take_both(a, b);
    long places = mpz_get_si(right.coefficient);
    if (left.kind == INDEFINITE)
        return indefinite(0, flags);
    if (left.kind == MACHINE_ZERO)
        return machine_zero(flags);
    if (places > 0)
        places = shift_left(places, 47);
    else
        shift_right(-places);
    return make(left.coefficient, left.exponent - places, flags);
}

c205_word oracle_adjust_exponent(c205_word a, c205_word b, uint64_t *flags)
{
    take_both(a, b);
    const long exponent = mpz_get_si(right.coefficient);
    const long places = left.exponent - exponent;
    if (left.kind == INDEFINITE)
        return indefinite(0, flags);
    if (left.kind == MACHINE_ZERO)
        return machine_zero(flags);
    if (places <= 0)
        shift_right(-places);
    else if (mpz_sgn(left.coefficient) != 0
             && shift_left(places, places) < places)
        return indefinite(FLAG_EXPONENT_OVERFLOW, flags);
    return make(left.coefficient, exponent, flags);
}

/* 16 bits and 48. */
static c205_word join(c205_word high, c205_word low)
{
    return high % (1ul << 16) * (1ul << 48) + low % (1ul << 48);
}

c205_word oracle_pack(c205_word a, c205_word b, uint64_t *flags)
{
    (void)flags;
    return join(a, b);
}

c205_word oracle_add_index(c205_word a, c205_word b, uint64_t *flags)
{
    (void)flags;
    return join(a >> 48, a + b);
}

c205_word oracle_subtract_index(c205_word a, c205_word b, uint64_t *flags)
{
    (void)flags;
    return join(a >> 48, a - b);
}

/* ---- Compare ------------------------------------------------------------ */

void oracle_value(mpfr_t value, c205_word word)
{
    take(&left, word);
    if (left.kind == INDEFINITE)
        mpfr_set_nan(value);
    else if (left.kind == MACHINE_ZERO)
        mpfr_set_zero(value, 1);
    else
        mpfr_set_z_2exp(value, left.coefficient, left.exponent, MPFR_RNDD);
}

static void take_values(c205_word a, c205_word b)
{
    oracle_value(left_value, a);
    oracle_value(right_value, b);
}

/* MPFR's predicates hold for no NaN, as the machine's for no indefinite. */
c205_word oracle_equal(c205_word a, c205_word b, uint64_t *flags)
{
    (void)flags;
    take_values(a, b);
    return mpfr_equal_p(left_value, right_value) != 0;
}

c205_word oracle_not_equal(c205_word a, c205_word b, uint64_t *flags)
{
    return !oracle_equal(a, b, flags);
}

c205_word oracle_not_less(c205_word a, c205_word b, uint64_t *flags)
{
    (void)flags;
    take_values(a, b);
    return mpfr_greaterequal_p(left_value, right_value) != 0;
}

c205_word oracle_less(c205_word a, c205_word b, uint64_t *flags)
{
    (void)flags;
    take_values(a, b);
    return mpfr_less_p(left_value, right_value) != 0;
}

/* ---- Bits --------------------------------------------------------------- */

/* Bit i, counted from the left. */
static c205_word bit(c205_word word, long i)
{
    return word >> (63 - i) & 1;
}

c205_word oracle_shift(c205_word a, c205_word b, uint64_t *flags)
{
    c205_word shifted = 0;

    (void)flags;
    take(&right, b);
    const long count = mpz_get_si(right.coefficient);
    for (long i = 0; i < 64; i++) {
        const long from = count >= 0    ? (i + count % 64) % 64
                          : i + count < 0 ? 0
                                        : i + count;
        shifted = shifted << 1 | bit(a, from);
    }
    return shifted;
}

/* One bit of the result from one bit of a and one of b: truth[a][b]. */
static c205_word bitwise(c205_word a, c205_word b,
                         const unsigned truth[2][2])
{
    c205_word result = 0;

    for (long i = 0; i < 64; i++)
        result = result << 1 | truth[bit(a, i)][bit(b, i)];
    return result;
}

#define LOGICAL(name, of00, of01, of10, of11)                               \
    c205_word oracle_##name(c205_word a, c205_word b, uint64_t *flags)      \
    {                                                                       \
        static const unsigned truth[2][2] = {{of00, of01}, {of10, of11}};   \
                                                                            \
        (void)flags;                                                        \
        return bitwise(a, b, truth);                                        \
    }

LOGICAL(xor, 0, 1, 1, 0)
LOGICAL(and, 0, 0, 0, 1)
LOGICAL(or, 0, 1, 1, 1)
LOGICAL(nand, 1, 1, 1, 0)
LOGICAL(nor, 1, 0, 0, 0)
LOGICAL(or_not, 1, 0, 1, 1)
LOGICAL(and_not, 0, 0, 1, 0)
LOGICAL(equivalence, 1, 0, 0, 1)
LOGICAL(copy, 0, 0, 1, 1)

/* ---- Values and words --------------------------------------------------- */

c205_word oracle_word(const mpfr_t value)
{
    uint64_t flags = 0;

    if (!mpfr_number_p(value))
        return C205_INDEFINITE;
    if (mpfr_zero_p(value))
        return C205_MACHINE_ZERO;
    const long exponent = mpfr_get_z_2exp(wide, value);
    return make_significant(47, exponent, &flags);
}
