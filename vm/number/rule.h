/* rule.h - the exact rule of arithmetic, one word at a time, for words of any format;
 * see docs/arithmetic.md.
 *
 * A file defines two macros before it includes this file:
 *
 *   RULE_FORMAT   a constant word_format
 *   RULE(name)    the names of the functions of arith.h in this format
 *
 * Such a file should contain little else, because it also gets the static names below.
 * Let d be the number of digits of the format (47 for words of 64 bits). The product of
 * two coefficients has 2d + 1 bits (95). The lower half has d of them.
 */

#include <math.h>

#define DIGITS (RULE_FORMAT.digits)
#define MIN_COEFFICIENT format_coefficient_min(RULE_FORMAT)
#define MAX_COEFFICIENT (-(MIN_COEFFICIENT + 1))

/* A double-length number, (hi x 2^DIGITS + lo) x 2^exponent with lo in [0, 2^DIGITS).
 * It holds every exact result before it is cut to a word. */
typedef struct wide {
    int64_t hi, lo;
    int32_t exponent;
} wide;

/* ---- Words ------------------------------------------------------------- */

static int32_t exponent_of(c205_word w)
{
    return format_exponent(RULE_FORMAT, w);
}

static int64_t coefficient_of(c205_word w)
{
    return format_coefficient(RULE_FORMAT, w);
}

/* Returns the coefficient that arithmetic uses: 0 for a machine zero. */
static int64_t value_of(c205_word w)
{
    return format_value_coefficient(RULE_FORMAT, w);
}

static int64_t rank_of(c205_word w)
{
    return format_rank(RULE_FORMAT, w);
}

static c205_word made(int32_t exponent, int64_t coefficient)
{
    return format_make(RULE_FORMAT, exponent, coefficient);
}

/* ---- Results ----------------------------------------------------------- */

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

/* Returns a word with this exponent and coefficient. By the range rule, an exponent
 * that is too large gives an indefinite, and one that is too small a machine zero. */
static c205_word ranged(int64_t exponent, int64_t coefficient, uint64_t *flags)
{
    if (exponent > format_exponent_max(RULE_FORMAT))
        return indefinite(FLAG_EXPONENT_OVERFLOW, flags);
    if (exponent < format_exponent_min(RULE_FORMAT))
        return machine_zero(flags);
    return made((int32_t)exponent, coefficient);
}

static bool either_indefinite(c205_word a, c205_word b)
{
    return word_is_indefinite(a) || word_is_indefinite(b);
}

/* ---- Double-length numbers --------------------------------------------- */

static bool wide_is_zero(wide w)
{
    return w.hi == 0 && w.lo == 0;
}

static wide wide_negate(wide w)
{
    int64_t borrow = w.lo != 0;
    const wide negated = { -w.hi - borrow, -w.lo & MAX_COEFFICIENT, w.exponent };
    return negated;
}

static int32_t wide_significant_bits(wide w)
{
    if (w.hi != 0 && w.hi != -1)
        return DIGITS + word_significant_bits(w.hi);
    return word_significant_bits(word_shift_left(w.hi, DIGITS) + w.lo);
}

/* Returns floor(w / 2^places), which must fit 64 bits. places may be negative. */
static int64_t wide_floor(wide w, int32_t places)
{
    int32_t up = DIGITS - places;
    if (up <= 0)
        return w.hi >> (up < -63 ? 63 : -up);
    if (places >= 0)
        return word_shift_left(w.hi, up) + (w.lo >> places);
    return word_shift_left(word_shift_left(w.hi, DIGITS) + w.lo, -places);
}

/* Returns w as a word. Positive places shift right and drop low bits; negative places
 * shift left. */
static c205_word wide_cut(wide w, int32_t places, uint64_t *flags)
{
    return ranged(w.exponent + places, wide_floor(w, places), flags);
}

/* Returns w with `bits` significant bits, or machine zero if w is zero. */
static c205_word wide_significant(wide w, int32_t bits, uint64_t *flags)
{
    if (wide_is_zero(w))
        return machine_zero(flags);
    return wide_cut(w, wide_significant_bits(w) - bits, flags);
}

/* Returns the high part of w. If it does not fit a coefficient, returns half of it with
 * the next higher exponent. */
static c205_word wide_upper(wide w, uint64_t *flags)
{
    bool fits = word_significant_bits(w.hi) <= DIGITS;
    return wide_cut(w, fits ? DIGITS : DIGITS + 1, flags);
}

static c205_word wide_lower(wide w, uint64_t *flags)
{
    return ranged(w.exponent, w.lo, flags);
}

/* ---- Add, subtract ----------------------------------------------------- */

/* Returns c x 2^DIGITS, shifted right by the given places, in the double-length
 * register. Bits shifted out of the register are lost. */
static wide aligned(int64_t c, int32_t places)
{
    wide w = { c >> 63, 0, 0 };
    if (places < DIGITS) {
        w.hi = c >> places;
        w.lo = word_shift_left(c, DIGITS - places) & MAX_COEFFICIENT;
    } else if (places < 2 * DIGITS) {
        w.lo = c >> (places - DIGITS) & MAX_COEFFICIENT;
    } else {
        w.lo = c >> 63 & MAX_COEFFICIENT;
    }
    return w;
}

/* Returns the sum, or the difference, in double length. A machine zero has coefficient
 * 0 and the smallest exponent, so the other operand is never aligned to it. */
static wide sum(c205_word a, c205_word b, bool subtract)
{
    int32_t distance = exponent_of(a) - exponent_of(b);
    int64_t ca = value_of(a);
    int64_t cb = value_of(b);
    wide w;
    if (distance >= 0) {
        w = aligned(cb, distance);
        if (subtract)
            w = wide_negate(w);
        w.hi += ca;
        w.exponent = exponent_of(a) - DIGITS;
    } else {
        w = aligned(ca, -distance);
        w.hi += subtract ? -cb : cb;
        w.exponent = exponent_of(b) - DIGITS;
    }
    return w;
}

/* Returns the sum w, shortened by its last bit if it has more than 2 DIGITS + 1 bits,
 * the size of the double-length register. */
static wide fitted(wide w)
{
    if (word_significant_bits(w.hi) > DIGITS) {
        w.lo = w.lo >> 1 | (w.hi & 1) << (DIGITS - 1);
        w.hi >>= 1;
        w.exponent++;
    }
    return w;
}

static bool both_machine_zero(c205_word a, c205_word b)
{
    return word_is_machine_zero(a) && word_is_machine_zero(b);
}

static c205_word add_upper(c205_word a, c205_word b, bool subtract, uint64_t *flags)
{
    if (either_indefinite(a, b))
        return indefinite(0, flags);
    if (both_machine_zero(a, b))
        return machine_zero(flags);
    return wide_upper(sum(a, b, subtract), flags);
}

static c205_word add_lower(c205_word a, c205_word b, bool subtract, uint64_t *flags)
{
    if (either_indefinite(a, b))
        return indefinite(0, flags);
    if (both_machine_zero(a, b))
        return machine_zero(flags);
    return wide_lower(fitted(sum(a, b, subtract)), flags);
}

static c205_word add_normalised(c205_word a, c205_word b, bool subtract,
                                uint64_t *flags)
{
    if (either_indefinite(a, b))
        return indefinite(0, flags);
    return wide_significant(sum(a, b, subtract), DIGITS, flags);
}

c205_word RULE(add_upper)(c205_word a, c205_word b, uint64_t *flags)
{
    return add_upper(a, b, false, flags);
}

c205_word RULE(add_lower)(c205_word a, c205_word b, uint64_t *flags)
{
    return add_lower(a, b, false, flags);
}

c205_word RULE(add_normalised)(c205_word a, c205_word b, uint64_t *flags)
{
    return add_normalised(a, b, false, flags);
}

c205_word RULE(subtract_upper)(c205_word a, c205_word b, uint64_t *flags)
{
    return add_upper(a, b, true, flags);
}

c205_word RULE(subtract_lower)(c205_word a, c205_word b, uint64_t *flags)
{
    return add_lower(a, b, true, flags);
}

c205_word RULE(subtract_normalised)(c205_word a, c205_word b, uint64_t *flags)
{
    return add_normalised(a, b, true, flags);
}

static c205_word halve(c205_word a, uint64_t *flags)
{
    if (word_is_machine_zero(a) || word_is_indefinite(a))
        return a;
    return ranged(exponent_of(a) - 1, coefficient_of(a), flags);
}

c205_word RULE(average)(c205_word a, c205_word b, uint64_t *flags)
{
    return halve(RULE(add_normalised)(a, b, flags), flags);
}

c205_word RULE(average_difference)(c205_word a, c205_word b, uint64_t *flags)
{
    return halve(RULE(subtract_normalised)(a, b, flags), flags);
}

/* ---- Multiply ---------------------------------------------------------- */

/* Returns the product of the coefficients, computed from halves of h = (DIGITS + 1) / 2
 * bits, of which the high halves are signed. For ca = a1 x 2^h + a0 and cb = b1 x 2^h +
 * b0, it is a1 b1 x 2^(2 h) + (a1 b0 + a0 b1) x 2^h + a0 b0. */
static wide product(c205_word a, c205_word b)
{
    int32_t half = (DIGITS + 1) / 2;
    int64_t mask = (INT64_C(1) << half) - 1;
    int64_t ca = coefficient_of(a), cb = coefficient_of(b);
    int64_t a1 = ca >> half, a0 = ca & mask;
    int64_t b1 = cb >> half, b0 = cb & mask;
    int64_t low = a0 * b0;
    int64_t middle = a1 * b0 + a0 * b1 + (low >> half);
    const wide w = { a1 * b1 * 2 + (middle >> (half - 1)),
                     (middle & mask >> 1) << half | (low & mask),
                     exponent_of(a) + exponent_of(b) };
    return w;
}

/* Returns true and sets *special if a factor is indefinite or machine zero, which
 * determines the product. */
static bool special_product(c205_word a, c205_word b, c205_word *special,
                            uint64_t *flags)
{
    if (either_indefinite(a, b))
        *special = indefinite(0, flags);
    else if (word_is_machine_zero(a) || word_is_machine_zero(b))
        *special = machine_zero(flags);
    else
        return false;
    return true;
}

/* Returns the smaller number of significant bits of the two operands, at least 1. */
static int32_t least_significance(c205_word a, c205_word b)
{
    int32_t sa = word_significant_bits(coefficient_of(a));
    int32_t sb = word_significant_bits(coefficient_of(b));
    int32_t least = sa < sb ? sa : sb;
    return least < 1 ? 1 : least;
}

c205_word RULE(multiply_upper)(c205_word a, c205_word b, uint64_t *flags)
{
    c205_word special;
    if (special_product(a, b, &special, flags))
        return special;
    return wide_upper(product(a, b), flags);
}

c205_word RULE(multiply_lower)(c205_word a, c205_word b, uint64_t *flags)
{
    c205_word special;
    if (special_product(a, b, &special, flags))
        return special;
    return wide_lower(product(a, b), flags);
}

c205_word RULE(multiply_significant)(c205_word a, c205_word b, uint64_t *flags)
{
    c205_word special;
    if (special_product(a, b, &special, flags))
        return special;
    return wide_significant(product(a, b), least_significance(a, b), flags);
}

/* ---- Divide ------------------------------------------------------------ */

/* Returns trunc(ca x 2^DIGITS / cb) by long division, for the coefficients ca and cb.
 * The first step computes the first DIGITS + 1 bits. The other DIGITS bits follow in
 * groups of up to 16 bits, for which the remainder leaves room in 64 bits. */
static wide quotient(c205_word a, c205_word b)
{
    int64_t ca = coefficient_of(a), cb = coefficient_of(b);
    int64_t dividend = ca < 0 ? -ca : ca, divisor = cb < 0 ? -cb : cb;
    int64_t remainder = dividend % divisor;
    wide w = { dividend / divisor, 0, 0 };
    for (int32_t left = DIGITS; left > 0;) {
        int32_t places = left < 16 ? left : 16;
        remainder <<= places;
        w.lo = w.lo << places | remainder / divisor;
        remainder %= divisor;
        left -= places;
    }
    w.exponent = exponent_of(a) - exponent_of(b) - DIGITS;
    return (ca < 0) != (cb < 0) ? wide_negate(w) : w;
}

/* Returns true and sets *special if an operand determines the quotient: it is
 * indefinite, machine zero, or a divisor with the value 0. Such a divisor is a divide
 * fault unless the dividend is indefinite. */
static bool special_quotient(c205_word a, c205_word b, c205_word *special,
                             uint64_t *flags)
{
    if (either_indefinite(a, b))
        *special = indefinite(0, flags);
    else if (value_of(b) == 0)
        *special = indefinite(FLAG_DIVIDE_FAULT, flags);
    else if (word_is_machine_zero(a))
        *special = machine_zero(flags);
    else
        return false;
    return true;
}

c205_word RULE(divide_upper)(c205_word a, c205_word b, uint64_t *flags)
{
    c205_word special;
    if (special_quotient(a, b, &special, flags))
        return special;
    wide w = quotient(a, b);
    int32_t excess = wide_significant_bits(w) - DIGITS;
    return wide_cut(w, excess > 0 ? excess : 0, flags);
}

c205_word RULE(divide_significant)(c205_word a, c205_word b, uint64_t *flags)
{
    c205_word special;
    if (special_quotient(a, b, &special, flags))
        return special;
    return wide_significant(quotient(a, b), least_significance(a, b), flags);
}

/* ---- Square root ------------------------------------------------------- */

/* Returns floor(sqrt(c x 2^k)) of a normalised c. The radicand is below 2^(2 DIGITS).
 * The root in double arithmetic is at most 1 too large. The sign of the remainder
 * modulo 2^64 gives the correction. */
static int64_t root(int64_t c, int32_t k)
{
    uint64_t estimate = (uint64_t)sqrt(ldexp((double)c, k));
    uint64_t remainder = ((uint64_t)c << k) - estimate * estimate;
    return (int64_t)(estimate - (remainder >> 63));
}

c205_word RULE(square_root)(c205_word a, uint64_t *flags)
{
    int64_t c = value_of(a);
    if (word_is_indefinite(a))
        return indefinite(0, flags);
    if (c == 0)
        return machine_zero(flags);
    if (c < 0)
        return indefinite(FLAG_IMAGINARY_ROOT, flags);
    int32_t places = DIGITS - word_significant_bits(c);
    int32_t exponent = exponent_of(a) - places;
    int32_t k = exponent % 2 == 0 ? DIGITS - 1 : DIGITS;
    return ranged((exponent - k) / 2 + places, root(c << places, k) >> places, flags);
}

/* ---- Parts of a number, sign ------------------------------------------- */

/* Returns the operand as the result, and sets the flags for its class. */
static c205_word kept(c205_word a, uint64_t *flags)
{
    if (word_is_machine_zero(a))
        *flags |= FLAG_MACHINE_ZERO;
    if (word_is_indefinite(a))
        *flags |= FLAG_INDEFINITE;
    return a;
}

c205_word RULE(floor)(c205_word a, uint64_t *flags)
{
    int32_t exponent = exponent_of(a);
    if (exponent >= 0 || word_is_machine_zero(a))
        return kept(a, flags);
    return made(0, coefficient_of(a) >> (exponent < -63 ? 63 : -exponent));
}

c205_word RULE(ceiling)(c205_word a, uint64_t *flags)
{
    int32_t exponent = exponent_of(a);
    if (exponent >= 0 || word_is_machine_zero(a))
        return kept(a, flags);
    return made(0, -(-coefficient_of(a) >> (exponent < -63 ? 63 : -exponent)));
}

c205_word RULE(truncate)(c205_word a, uint64_t *flags)
{
    return coefficient_of(a) < 0 ? RULE(ceiling)(a, flags) : RULE(floor)(a, flags);
}

/* Negates. A normalised number stays normalised. The exponent changes for two
 * coefficients: the negative of MIN_COEFFICIENT does not fit, and the negative of
 * -MIN_COEFFICIENT / 2 is not normalised. */
c205_word RULE(negate)(c205_word a, uint64_t *flags)
{
    int32_t exponent = exponent_of(a);
    int64_t c = coefficient_of(a);
    if (word_is_indefinite(a))
        return indefinite(0, flags);
    if (word_is_machine_zero(a))
        return machine_zero(flags);
    if (c == MIN_COEFFICIENT)
        return ranged(exponent + 1, -(c / 2), flags);
    if (c == -(MIN_COEFFICIENT / 2))
        return ranged(exponent - 1, MIN_COEFFICIENT, flags);
    return made(exponent, -c);
}

c205_word RULE(absolute)(c205_word a, uint64_t *flags)
{
    return coefficient_of(a) < 0 ? RULE(negate)(a, flags) : kept(a, flags);
}

c205_word RULE(exponent)(c205_word a, uint64_t *flags)
{
    (void)flags;
    return made(0, exponent_of(a));
}

c205_word RULE(pack)(c205_word a, c205_word b, uint64_t *flags)
{
    (void)flags;
    return format_pack(RULE_FORMAT, a, b);
}

/* ---- Adjust ------------------------------------------------------------ */

/* Returns the places by which a coefficient can be shifted left without overflow. The
 * coefficient 0 counts as having no significant bits. */
static int32_t room(int64_t c)
{
    return DIGITS - word_significant_bits(c);
}

/* Returns a with the given exponent and its coefficient shifted to match. */
static c205_word with_exponent(c205_word a, int64_t exponent, uint64_t *flags)
{
    int64_t c = coefficient_of(a), left = exponent_of(a) - exponent;
    if (word_is_indefinite(a))
        return indefinite(0, flags);
    if (word_is_machine_zero(a))
        return machine_zero(flags);
    if (left <= 0)
        return ranged(exponent, c >> (left < -63 ? 63 : -left), flags);
    if (left <= room(c))
        return ranged(exponent, word_shift_left(c, (int32_t)left), flags);
    return c == 0 ? ranged(exponent, 0, flags)
                  : indefinite(FLAG_EXPONENT_OVERFLOW, flags);
}

c205_word RULE(adjust_significance)(c205_word a, c205_word b, uint64_t *flags)
{
    int64_t wanted = coefficient_of(b);
    int64_t most = room(coefficient_of(a));
    int64_t places = wanted < most ? wanted : most;
    return with_exponent(a, exponent_of(a) - places, flags);
}

c205_word RULE(adjust_exponent)(c205_word a, c205_word b, uint64_t *flags)
{
    return with_exponent(a, coefficient_of(b), flags);
}

/* ---- Compare ----------------------------------------------------------- */

bool RULE(equal)(c205_word a, c205_word b)
{
    return !either_indefinite(a, b) && rank_of(a) == rank_of(b);
}

bool RULE(not_equal)(c205_word a, c205_word b)
{
    return !RULE(equal)(a, b);
}

bool RULE(not_less)(c205_word a, c205_word b)
{
    return !either_indefinite(a, b) && rank_of(a) >= rank_of(b);
}

bool RULE(less)(c205_word a, c205_word b)
{
    return !either_indefinite(a, b) && rank_of(a) < rank_of(b);
}

/* ---- Shift ------------------------------------------------------------- */

c205_word RULE(shift)(c205_word a, c205_word b, uint64_t *flags)
{
    (void)flags;
    return format_shift(RULE_FORMAT, a, coefficient_of(b));
}
