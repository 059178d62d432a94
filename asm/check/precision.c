/* precision.c - computes the bits that an operation loses because an operand is an
 * integer. */
#include "asm/check/precision.h"

#include <math.h>
#include <string.h>

#include "vm/min_max.h"

/* The rules of precision by mnemonic. After the stem, a mnemonic may have one of the
 * letters H, V and S. */
static const struct {
    const char *stem;
    enum precision_rule rule;
} rules[] = {
    { "MPYS", PRECISION_PRODUCT },       { "DIVS", PRECISION_QUOTIENT },
    { "SQRT", PRECISION_ROOT },          { "ADDU", PRECISION_UPPER_SUM },
    { "INTVL", PRECISION_UPPER_SUM },    { "SUBU", PRECISION_UPPER_DIFFERENCE },
    { "MPYU", PRECISION_UPPER_PRODUCT }, { "DIVU", PRECISION_UPPER_QUOTIENT },
};

enum precision_rule precision_rule(const c205_insn *insn)
{
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
        size_t length = strlen(rules[i].stem);
        const char *rest = insn->mnemonic + length;
        if (strncmp(insn->mnemonic, rules[i].stem, length) == 0
            && (!*rest || (strchr("HVS", *rest) && !rest[1])))
            return rules[i].rule;
    }
    return PRECISION_FULL;
}

/* ---- Words ---- */

enum { HALF_BITS = 32 };

static int exponent_of(c205_word word, bool half)
{
    return half ? (int8_t)(word >> 56) : (int16_t)(word >> 48);
}

static int coefficient_bits(bool half)
{
    return half ? 23 : 47; /* without the sign */
}

static int64_t coefficient_of(c205_word word, bool half)
{
    int64_t c = (int64_t)(word >> HALF_BITS & 0xFFFFFF);
    if (!half)
        return c205_to_integer(word);
    return c < 1 << 23 ? c : c - (1 << 24);
}

/* Returns the smallest n with -2^n <= coefficient < 2^n. */
static int significant_bits(c205_word word, bool half)
{
    int64_t c = coefficient_of(word, half);
    int n = 0;
    for (c = c < 0 ? ~c : c; c > 0; c /= 2)
        n++;
    return n;
}

bool precision_is_integer(c205_word word, bool half)
{
    return exponent_of(word, half) == 0
           && significant_bits(word, half) < coefficient_bits(half);
}

static double value_of(c205_word word, bool half)
{
    return (half ? c205_half_to_double : c205_to_double)(word);
}

/* ---- Results ---- */

static double exact_result(enum precision_rule rule, double a, double b)
{
    switch (rule) {
    case PRECISION_UPPER_SUM: return a + b;
    case PRECISION_UPPER_DIFFERENCE: return a - b;
    case PRECISION_QUOTIENT:
    case PRECISION_UPPER_QUOTIENT: return a / b;
    case PRECISION_ROOT: return sqrt(a);
    default: return a * b;
    }
}

/* Returns the exponent of the last bit of the exact result that the machine keeps. For
 * an upper result it depends only on the exponents of the operands. A significant
 * result keeps as many significant bits as the operand that has fewer. */
static int last_bit(enum precision_rule rule, bool half, c205_word a, c205_word b,
                    double exact)
{
    int ea = exponent_of(a, half), eb = exponent_of(b, half);
    int bits = coefficient_bits(half), s = significant_bits(a, half);
    switch (rule) {
    case PRECISION_UPPER_SUM:
    case PRECISION_UPPER_DIFFERENCE: return max_int(ea, eb);
    case PRECISION_UPPER_PRODUCT: return ea + eb + bits;
    case PRECISION_UPPER_QUOTIENT: return ea - eb - bits;
    case PRECISION_ROOT: break;
    default: s = min_int(s, significant_bits(b, half));
    }
    return ilogb(exact) + 1 - max_int(s, 1);
}

/* Rounds the exact result as the machine does. All results are rounded down at the bit
 * `last`. A quotient is first truncated towards zero at the last bit of the upper
 * quotient. */
static double cut(enum precision_rule rule, double exact, int last,
                  int last_of_quotient)
{
    if (rule == PRECISION_QUOTIENT || rule == PRECISION_UPPER_QUOTIENT)
        exact = ldexp(trunc(ldexp(exact, -last_of_quotient)), last_of_quotient);
    return ldexp(floor(ldexp(exact, -last)), last);
}

/* A loss of at most this number of bits, compared with normalised operands, is not
 * reported. */
enum { SPARE = 7 };

bool precision_is_lost(enum precision_rule rule, bool half, c205_word a, c205_word b,
                       struct precision *precision)
{
    double exact = exact_result(rule, value_of(a, half), value_of(b, half));
    int last;
    if (rule == PRECISION_FULL || exact == 0 || !isfinite(exact)
        || !isfinite(value_of(a, half)) || !isfinite(value_of(b, half)))
        return false;
    last = last_bit(rule, half, a, b, exact);
    precision->exact = exact;
    precision->kept = cut(rule, exact, last,
                          last_bit(PRECISION_UPPER_QUOTIENT, half, a, b, exact));
    return fabs(exact - precision->kept)
           > ldexp(fabs(exact), SPARE - coefficient_bits(half));
}
