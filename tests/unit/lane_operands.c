/* lane_operands.c - makes random words of all kinds for tests of spans. */
#include "tests/unit/lane_operands.h"

#include "vm/number/arith.h"

#define SIZE(table) (sizeof(table) / sizeof *(table))

/* Defines a function that supplies words, for the table of supplies. */
#define SUPPLY(name, expression) \
    static c205_word name(word_format f, uint64_t *seed) \
    { \
        return expression; \
    }

c205_word lane_special_at(word_format f, size_t i)
{
    int32_t top = format_exponent_max(f);
    int32_t bottom = format_exponent_min(f);
    int32_t end = 1 << (f.exponent_bits - 1);
    int64_t half = INT64_C(1) << (f.digits - 1);
    const int32_t exponents[LANE_EXPONENTS] = {
        -end, bottom - 1, top + 1, end - 1, bottom, top, 0, -1, 1 - f.digits, -f.digits
    };
    const int64_t coefficients[LANE_COEFFICIENTS] = { 0,         1,        -1,
                                                      half,      -half,    2 * half - 1,
                                                      -2 * half, -half - 1 };
    return format_make(f, exponents[i / LANE_COEFFICIENTS],
                       coefficients[i % LANE_COEFFICIENTS]);
}

SUPPLY(special, lane_special_at(f, xorshift(seed) % LANE_SPECIALS))

c205_word lane_near(word_format f, uint64_t *seed)
{
    return xorshift_normalised_of(f, seed, -f.digits - 2, -f.digits + 2);
}

SUPPLY(around, xorshift_normalised_of(f, seed, -2 * f.digits - 6, 10))
SUPPLY(near_top, xorshift_normalised_of(f, seed, format_exponent_max(f) - 3,
                                        format_exponent_max(f)))
SUPPLY(near_bottom, xorshift_normalised_of(f, seed, format_exponent_min(f),
                                           format_exponent_min(f) + f.digits + 3))
SUPPLY(anywhere,
       xorshift_normalised_of(f, seed, format_exponent_min(f), format_exponent_max(f)))

c205_word lane_or_machine_zero(word_format f, uint64_t *seed)
{
    return xorshift(seed) % 4 == 0 ? C205_MACHINE_ZERO : around(f, seed);
}

SUPPLY(unnormalised, xorshift_unnormalised_of(f, seed, -2 * f.digits - 6, 10))

c205_word lane_any_bits(word_format f, uint64_t *seed)
{
    return xorshift(seed) & format_mask(f);
}

/* Returns a word whose coefficient has few ones or few zeros, so that carries cross
 * many digits. */
c205_word lane_sparse(word_format f, uint64_t *seed)
{
    c205_word word = around(f, seed);
    int64_t c = format_coefficient(f, word);
    int64_t kept = -(INT64_C(1) << xorshift_between(seed, 0, f.digits - 1));
    return format_make(f, format_exponent(f, word), c < 0 ? c | ~kept : c & kept);
}

c205_word lane_mostly_usual(word_format f, uint64_t *seed)
{
    return xorshift(seed) % 64 == 0 ? special(f, seed) : lane_near(f, seed);
}

/* Returns a machine zero with random digits. */
static c205_word zero(word_format f, uint64_t *seed)
{
    c205_word digits = xorshift(seed) & UINT64_C(0x0FFFFFFFFFFFFFFF);
    return (C205_MACHINE_ZERO | digits) & format_mask(f);
}

SUPPLY(mostly_zero, xorshift(seed) % 128 == 0 ? special(f, seed) : zero(f, seed))

/* Returns a word with an exponent at an end of a range that is `less` bits shorter than
 * the range of the format. */
static c205_word at_the_ends(word_format f, uint64_t *seed, int less)
{
    int32_t end = 1 << (f.exponent_bits - 1 - less);
    int32_t e = xorshift(seed) % 2 ? end - 1 : -end;
    return xorshift_normalised_of(f, seed, e, e);
}

/* Words inside, some just outside, of the common range (vm/number/common_range.h). */
SUPPLY(about_usual, at_the_ends(f, seed, xorshift(seed) % 128 == 0 ? 1 : 2))
SUPPLY(beyond_usual, at_the_ends(f, seed, 1))

/* Returns a word with an exponent in a range that is `less` bits shorter than the range
 * of the format. Some coefficients are the largest or the smallest. Some words are
 * machine zeros. */
static c205_word within(word_format f, uint64_t *seed, int less)
{
    int32_t end = 1 << (f.exponent_bits - 1) >> less;
    int64_t half = INT64_C(1) << (f.digits - 1);
    const int64_t ends[] = { half, 2 * half - 1, -half - 1, -2 * half };
    size_t kind = xorshift(seed) % 16;
    int32_t e = (int32_t)xorshift_between(seed, -end, end > 0 ? end - 1 : 0);
    if (kind < SIZE(ends))
        return format_make(f, e, ends[kind]);
    return kind == SIZE(ends) ? C205_MACHINE_ZERO
                              : xorshift_normalised_of(f, seed, e, e);
}

/* Words that can be converted to doubles exactly (vm/number/round_down.h). Variants
 * have close exponents, a few other words, or exponents just out of range. */
SUPPLY(moderate, within(f, seed, 7))
SUPPLY(moderate_near, within(f, seed, 13))

static c205_word mostly_moderate(word_format f, uint64_t *seed)
{
    supply *const others[] = { special, zero, unnormalised, anywhere };
    uint64_t which = xorshift(seed) % 1024;

    return which < SIZE(others) ? others[which](f, seed) : moderate(f, seed);
}

SUPPLY(beyond_moderate, within(f, seed, 6))

/* Returns an integer with few or many digits, or a machine zero. */
static c205_word whole(word_format f, uint64_t *seed)
{
    int64_t end = INT64_C(1) << xorshift_between(seed, 0, f.digits);
    if (xorshift(seed) % 8 == 0)
        return zero(f, seed);
    return format_make(f, 0, xorshift_between(seed, -end, end - 1));
}

static c205_word mostly_whole(word_format f, uint64_t *seed)
{
    supply *const others[] = { special, unnormalised, anywhere };
    uint64_t which = xorshift(seed) % 256;

    return which < SIZE(others) ? others[which](f, seed) : whole(f, seed);
}

static c205_word absolute(word_format f, c205_word word)
{
    uint64_t flags = 0;
    return f.digits == WORD_DIGITS ? arith_absolute(word, &flags)
                                   : half_absolute(word, &flags);
}

SUPPLY(positive, absolute(f, anywhere(f, seed)))
SUPPLY(moderate_positive, absolute(f, moderate(f, seed)))

/* Returns a square, or a word that is less by one. Between the two a truncated root
 * changes. */
c205_word lane_about_a_square(word_format f, uint64_t *seed)
{
    int64_t least = INT64_C(1) << (f.digits / 2);
    int64_t root = xorshift_between(seed, least, least * 707 / 500);
    return format_make(f, (int32_t)xorshift_between(seed, -90, 90),
                       root * root - (int64_t)(xorshift(seed) & 1));
}

supply *const lane_supplies[LANE_SUPPLIES] = {
    special,
    lane_near,
    around,
    near_top,
    near_bottom,
    anywhere,
    lane_any_bits,
    unnormalised,
    lane_sparse,
    lane_mostly_usual,
    lane_or_machine_zero,
    positive,
    zero,
    mostly_zero,
    about_usual,
    beyond_usual,
    moderate,
    moderate_near,
    mostly_moderate,
    beyond_moderate,
    moderate_positive,
    whole,
    mostly_whole,
};

void lane_fill(c205_word *words, size_t n, supply *next, word_format f, uint64_t *seed)
{
    for (size_t i = 0; i < n; i++)
        words[i] = next(f, seed);
}
