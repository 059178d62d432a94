/* narrow_oracle.c - the rules of docs/arithmetic.md for narrow words, in integers. */
#include "narrow_oracle.h"

/* ---- Words -------------------------------------------------------------- */

enum {
    DIGITS = NARROW_DIGITS,
    SUM_DIGITS = 2 * DIGITS,
    PADDING = 64 - NARROW_WIDTH,
    LARGEST = (1 << DIGITS) - 1, /* largest coefficient */
    SMALLEST = -(1 << DIGITS)
};

struct number {
    bool zero, indefinite;
    int64_t exponent, coefficient;
};

c205_word narrow_word(int64_t exponent, int64_t coefficient)
{
    uint64_t low = (uint64_t)coefficient % (1u << (DIGITS + 1));
    uint64_t high = (uint64_t)exponent << (DIGITS + 1);
    return (high | low) << PADDING;
}

int64_t narrow_exponent_of(c205_word word)
{
    return (int64_t)word >> (64 - NARROW_EXPONENT_BITS);
}

int64_t narrow_coefficient_of(c205_word word)
{
    return (int64_t)(word << NARROW_EXPONENT_BITS) >> (63 - DIGITS);
}

static struct number take(c205_word word)
{
    return (struct number){ .zero = word >> 60 == 8,
                            .indefinite = word >> 60 == 7,
                            .exponent = narrow_exponent_of(word),
                            .coefficient = narrow_coefficient_of(word) };
}

static bool is_special(struct number a)
{
    return a.zero || a.indefinite;
}

/* ---- Results ------------------------------------------------------------ */

static c205_word machine_zero(uint64_t *flags)
{
    *flags |= FLAG_MACHINE_ZERO;
    return C205_MACHINE_ZERO;
}

static c205_word indefinite(uint64_t *flags)
{
    *flags |= FLAG_INDEFINITE;
    return C205_INDEFINITE;
}

static c205_word special_word(struct number a, uint64_t *flags)
{
    return a.zero ? machine_zero(flags) : indefinite(flags);
}

static c205_word unchanged(c205_word word, uint64_t *flags)
{
    struct number a = take(word);
    *flags |= (a.zero ? FLAG_MACHINE_ZERO : 0) | (a.indefinite ? FLAG_INDEFINITE : 0);
    return word;
}

/* Applies the range rule and returns the word. */
static c205_word make(int64_t exponent, int64_t coefficient, uint64_t *flags)
{
    if (exponent > NARROW_EXPONENT_MAX) {
        *flags |= FLAG_EXPONENT_OVERFLOW;
        return indefinite(flags);
    }
    if (exponent < NARROW_EXPONENT_MIN)
        return machine_zero(flags);
    return narrow_word(exponent, coefficient);
}

/* ---- Significant bits --------------------------------------------------- */

/* The bits of the longest integer: a product, a quotient or an unshortened sum. */
enum { LONGEST = SUM_DIGITS + 1 };
static signed char significant[2 << LONGEST];

void small_begin(void)
{
    for (int c = -(1 << LONGEST); c < 1 << LONGEST; c++) {
        signed char n = 0;
        while (c < -(1 << n) || c >= 1 << n)
            n++;
        significant[c + (1 << LONGEST)] = n;
    }
}

/* Returns the least n for which -2^n <= c < 2^n. */
static int64_t significant_bits(int64_t c)
{
    return significant[c + (1 << LONGEST)];
}

static int64_t less_significant(struct number a, struct number b)
{
    int64_t m = significant_bits(a.coefficient);
    int64_t n = significant_bits(b.coefficient);
    int64_t least = m < n ? m : n;
    return least < 1 ? 1 : least;
}

/* Returns floor(c / 2^places). places may be any integer. */
static int64_t right(int64_t c, int64_t places)
{
    return c >> (places > 63 ? 63 : places);
}

static c205_word make_significant(int64_t exponent, int64_t c, int64_t bits,
                                  uint64_t *flags)
{
    if (c == 0)
        return machine_zero(flags);
    int64_t k = significant_bits(c) - bits;
    int64_t shifted = k >= 0 ? right(c, k) : c * (1 << -k);
    return make(exponent + k, shifted, flags);
}

/* ---- Add, subtract ------------------------------------------------------ */

/* The head of the definition of a rule. */
#define UNUSED __attribute__((unused))
#define SMALL_RULE(name) \
    c205_word small_##name(c205_word word_a, c205_word word_b UNUSED, \
                           uint64_t *flags UNUSED)

enum form { UPPER, LOWER, NORMALISED };

static c205_word cut_sum(int64_t exponent, int64_t sum, enum form form, uint64_t *flags)
{
    if (significant_bits(sum) > SUM_DIGITS) {
        sum = right(sum, 1);
        exponent++;
    }
    if (form == LOWER)
        return make(exponent - DIGITS, sum & LARGEST, flags);
    if (form == NORMALISED) {
        if (sum == 0)
            return machine_zero(flags);
        int64_t places = SUM_DIGITS - significant_bits(sum);
        sum *= 1 << places;
        exponent -= places;
    }
    return make(exponent, right(sum, DIGITS), flags);
}

/* Computes a + sign * b. */
static c205_word add(c205_word word_a, c205_word word_b, int64_t sign, enum form form,
                     uint64_t *flags)
{
    struct number a = take(word_a), b = take(word_b);
    if (a.indefinite || b.indefinite)
        return indefinite(flags);
    if (a.zero && b.zero)
        return machine_zero(flags);
    if (a.zero)
        a = (struct number){ .exponent = b.exponent };
    if (b.zero)
        b = (struct number){ .exponent = a.exponent };
    int64_t e = a.exponent > b.exponent ? a.exponent : b.exponent;
    int64_t x = right(a.coefficient * (1 << DIGITS), e - a.exponent);
    int64_t y = right(b.coefficient * (1 << DIGITS), e - b.exponent);
    return cut_sum(e, x + sign * y, form, flags);
}

#define SUM(name, sign, form) \
    SMALL_RULE(name) \
    { \
        return add(word_a, word_b, sign, form, flags); \
    }

SUM(add_upper, 1, UPPER)
SUM(add_lower, 1, LOWER)
SUM(add_normalised, 1, NORMALISED)
SUM(subtract_upper, -1, UPPER)
SUM(subtract_lower, -1, LOWER)
SUM(subtract_normalised, -1, NORMALISED)

static c205_word halved(c205_word word, uint64_t *flags)
{
    struct number sum = take(word);
    return is_special(sum) ? word : make(sum.exponent - 1, sum.coefficient, flags);
}

SMALL_RULE(average)
{
    return halved(small_add_normalised(word_a, word_b, flags), flags);
}

SMALL_RULE(average_difference)
{
    return halved(small_subtract_normalised(word_a, word_b, flags), flags);
}

/* ---- Multiply, divide --------------------------------------------------- */

/* Returns the product. If an operand is special, sets *special instead. */
static int64_t product(struct number a, struct number b, c205_word *special,
                       uint64_t *flags)
{
    if (a.indefinite || b.indefinite)
        *special = indefinite(flags);
    else if (a.zero || b.zero)
        *special = machine_zero(flags);
    return a.coefficient * b.coefficient;
}

SMALL_RULE(multiply_upper)
{
    struct number a = take(word_a), b = take(word_b);
    c205_word special = 0;
    int64_t p = right(product(a, b, &special, flags), DIGITS);
    int64_t e = a.exponent + b.exponent + DIGITS;
    if (special)
        return special;
    return p > LARGEST ? make(e + 1, p / 2, flags) : make(e, p, flags);
}

SMALL_RULE(multiply_lower)
{
    struct number a = take(word_a), b = take(word_b);
    c205_word special = 0;
    int64_t p = product(a, b, &special, flags) & LARGEST;
    return special ? special : make(a.exponent + b.exponent, p, flags);
}

SMALL_RULE(multiply_significant)
{
    struct number a = take(word_a), b = take(word_b);
    c205_word special = 0;
    int64_t p = product(a, b, &special, flags);
    return special ? special
                   : make_significant(a.exponent + b.exponent, p,
                                      less_significant(a, b), flags);
}

static int64_t quotient(struct number a, struct number b, c205_word *special,
                        uint64_t *flags)
{
    if (a.indefinite || b.indefinite) {
        *special = indefinite(flags);
    } else if (b.zero || b.coefficient == 0) {
        *flags |= FLAG_DIVIDE_FAULT;
        *special = indefinite(flags);
    } else if (a.zero) {
        *special = machine_zero(flags);
    }
    return *special ? 0 : a.coefficient * (1 << DIGITS) / b.coefficient;
}

SMALL_RULE(divide_upper)
{
    struct number a = take(word_a), b = take(word_b);
    c205_word special = 0;
    int64_t q = quotient(a, b, &special, flags);
    int64_t e = a.exponent - b.exponent - DIGITS;
    for (; q < SMALLEST || q > LARGEST; e++)
        q = right(q, 1);
    return special ? special : make(e, q, flags);
}

SMALL_RULE(divide_significant)
{
    struct number a = take(word_a), b = take(word_b);
    c205_word special = 0;
    int64_t q = quotient(a, b, &special, flags);
    return special ? special
                   : make_significant(a.exponent - b.exponent - DIGITS, q,
                                      less_significant(a, b), flags);
}

/* ---- Square root -------------------------------------------------------- */

static int64_t floor_of_root(int64_t square)
{
    int64_t root = 0;
    while ((root + 1) * (root + 1) <= square)
        root++;
    return root;
}

SMALL_RULE(square_root)
{
    struct number a = take(word_a);
    int64_t places = 0;
    if (a.indefinite)
        return indefinite(flags);
    if (a.zero || a.coefficient == 0)
        return machine_zero(flags);
    if (a.coefficient < 0) {
        *flags |= FLAG_IMAGINARY_ROOT;
        return indefinite(flags);
    }
    for (; a.coefficient * 2 <= LARGEST; places++)
        a.coefficient *= 2;
    a.exponent -= places;
    int64_t k = (a.exponent - DIGITS) % 2 == 0 ? DIGITS : DIGITS - 1;
    int64_t root = floor_of_root(a.coefficient * (1 << k));
    return make((a.exponent - k) / 2 + places, right(root, places), flags);
}

/* ---- Parts of a number, sign -------------------------------------------- */

static bool is_whole(struct number a)
{
    return is_special(a) || a.exponent >= 0;
}

SMALL_RULE(floor)
{
    struct number a = take(word_a);
    return is_whole(a) ? unchanged(word_a, flags)
                       : make(0, right(a.coefficient, -a.exponent), flags);
}

SMALL_RULE(ceiling)
{
    struct number a = take(word_a);
    return is_whole(a) ? unchanged(word_a, flags)
                       : make(0, -right(-a.coefficient, -a.exponent), flags);
}

SMALL_RULE(truncate)
{
    return narrow_coefficient_of(word_a) < 0 ? small_ceiling(word_a, word_b, flags)
                                             : small_floor(word_a, word_b, flags);
}

SMALL_RULE(negate)
{
    struct number a = take(word_a);
    int64_t half = 1 << (DIGITS - 1);
    if (is_special(a))
        return special_word(a, flags);
    if (a.coefficient == SMALLEST)
        return make(a.exponent + 1, half, flags);
    if (a.coefficient == half)
        return make(a.exponent - 1, SMALLEST, flags);
    return make(a.exponent, -a.coefficient, flags);
}

SMALL_RULE(absolute)
{
    return narrow_coefficient_of(word_a) < 0 ? small_negate(word_a, word_b, flags)
                                             : unchanged(word_a, flags);
}

SMALL_RULE(exponent)
{
    return narrow_word(0, narrow_exponent_of(word_a));
}

/* ---- Adjust, pack, shift ------------------------------------------------ */

SMALL_RULE(adjust_significance)
{
    struct number a = take(word_a);
    int64_t wanted = narrow_coefficient_of(word_b);
    int64_t most = DIGITS - significant_bits(a.coefficient);
    int64_t places = wanted < most ? wanted : most;
    if (is_special(a))
        return special_word(a, flags);
    if (wanted <= 0)
        return make(a.exponent - wanted, right(a.coefficient, -wanted), flags);
    return make(a.exponent - places, a.coefficient * (1 << places), flags);
}

SMALL_RULE(adjust_exponent)
{
    struct number a = take(word_a);
    int64_t exponent = narrow_coefficient_of(word_b);
    int64_t places = a.exponent - exponent;
    if (is_special(a))
        return special_word(a, flags);
    if (places <= 0 || a.coefficient == 0)
        return make(exponent, right(a.coefficient, places <= 0 ? -places : 0), flags);
    if (places > DIGITS - significant_bits(a.coefficient)) {
        *flags |= FLAG_EXPONENT_OVERFLOW;
        return indefinite(flags);
    }
    return make(exponent, a.coefficient * (1 << places), flags);
}

SMALL_RULE(pack)
{
    return narrow_word((int64_t)(word_a >> PADDING), narrow_coefficient_of(word_b));
}

SMALL_RULE(shift)
{
    int64_t bits = (int64_t)word_a >> PADDING; /* signed */
    int64_t count = narrow_coefficient_of(word_b);
    int64_t left = count < 0 ? 0 : count % NARROW_WIDTH;
    uint64_t circle = (word_a >> PADDING) * ((1u << NARROW_WIDTH) + 1);
    return (count < 0 ? (uint64_t)right(bits, -count) : circle >> (NARROW_WIDTH - left))
           << PADDING;
}

/* ---- Compare ------------------------------------------------------------ */

/* Returns the value in units of the smallest exponent, or 0 for machine zero. */
static int64_t value(struct number a)
{
    return a.zero || a.indefinite
               ? 0
               : a.coefficient * (INT64_C(1) << (a.exponent - NARROW_EXPONENT_MIN));
}

#define COMPARISON(name, relation, unordered) \
    SMALL_RULE(name) \
    { \
        struct number a = take(word_a), b = take(word_b); \
        if (a.indefinite || b.indefinite) \
            return unordered; \
        return value(a) relation value(b); \
    }

COMPARISON(equal, ==, 0)
COMPARISON(not_equal, !=, 1)
COMPARISON(not_less, >=, 0)
COMPARISON(less, <, 0)
