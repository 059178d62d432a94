/* test_special_values.c - results of machine zeros and indefinites are compared with
 * the operation's rule of special values in vm/arith.def, for words and half words with
 * random digits. A special operand that is treated as a number fails here. A rule
 * without a check does not compile. */
#include "tests/random.h"
#include "tests/unit/rule_cases.h"

enum { ROUNDS = 20000 };

/* ---- Operands ----------------------------------------------------------- */

/* Words with the largest and the smallest exponents are not numbers. */
static c205_word any_indefinite(word_format f, uint64_t *seed)
{
    return UINT64_C(7) << 60 | (xorshift(seed) & format_mask(f)) >> 4;
}

static c205_word any_machine_zero(word_format f, uint64_t *seed)
{
    return UINT64_C(8) << 60 | (xorshift(seed) & format_mask(f)) >> 4;
}

static int32_t any_exponent(word_format f, uint64_t *seed)
{
    return (int32_t)xorshift_between(seed, format_exponent_min(f),
                                     format_exponent_max(f));
}

static c205_word any_word(word_format f, uint64_t *seed)
{
    switch (xorshift(seed) % 6) {
    case 0: return any_indefinite(f, seed) & format_mask(f);
    case 1: return any_machine_zero(f, seed) & format_mask(f);
    case 2: return format_make(f, any_exponent(f, seed), 0);
    case 3: return format_make(f, any_exponent(f, seed), -1);
    case 4: return xorshift_normalised_of(f, seed, -f.digits, 0);
    default: return xorshift(seed) & format_mask(f);
    }
}

/* ---- One case ----------------------------------------------------------- */

struct outcome {
    c205_word word;
    uint64_t flags;
};

static const struct outcome plain_zero = { MZ, ZERO_FLAG };
static const struct outcome plain_indefinite = { IND, INDEFINITE_FLAG };

/* An operation with its operands. */
struct trial {
    const struct operation {
        const char *name;
        word_format f;
        arith_binary *binary;
        arith_unary *unary;
        void (*specials)(const struct trial *t);
    } * of;
    word_format f; /* format of the operation */
    c205_word a, b;
};

static struct outcome result_of(const struct trial *t)
{
    struct outcome result = { 0, 0 };
    result.word = t->of->binary ? t->of->binary(t->a, t->b, &result.flags)
                                : t->of->unary(t->a, &result.flags);
    return result;
}

static void expect(const struct trial *t, struct outcome expected)
{
    struct outcome result = result_of(t);
    FAIL_IF(result.word != expected.word || result.flags != expected.flags,
            "%s of %016llX and %016llX, %d digits: %016llX, flags %llX, "
            "not %016llX, %llX",
            t->of->name, (unsigned long long)t->a, (unsigned long long)t->b,
            (int)t->f.digits, (unsigned long long)result.word,
            (unsigned long long)result.flags, (unsigned long long)expected.word,
            (unsigned long long)expected.flags);
}

static bool is_zero(const struct trial *t, c205_word w)
{
    return word_is_machine_zero(w) || format_coefficient(t->f, w) == 0;
}

static bool either_indefinite(const struct trial *t)
{
    return word_is_indefinite(t->a) || word_is_indefinite(t->b);
}

/* ---- The rules ---------------------------------------------------------- */

static void check_BITS(const struct trial *t)
{
    struct outcome result = result_of(t);
    assert_int_equal(result.flags, 0);
    assert_int_equal(result.word & ~format_mask(t->f), 0);
}

/* A machine zero counts as 0 with the smallest exponent. */
static void check_SUM(const struct trial *t)
{
    c205_word zero = format_make(t->f, format_exponent_min(t->f), 0);
    bool a_zero = word_is_machine_zero(t->a);
    bool b_zero = word_is_machine_zero(t->b);
    struct trial same = *t;
    same.a = a_zero ? zero : t->a;
    same.b = b_zero ? zero : t->b;
    expect(t, either_indefinite(t) ? plain_indefinite
              : a_zero && b_zero   ? plain_zero
                                   : result_of(&same));
}

static void check_PRODUCT(const struct trial *t)
{
    if (either_indefinite(t))
        expect(t, plain_indefinite);
    else if (word_is_machine_zero(t->a) || word_is_machine_zero(t->b))
        expect(t, plain_zero);
}

static void check_QUOTIENT(const struct trial *t)
{
    if (either_indefinite(t))
        expect(t, plain_indefinite);
    else if (is_zero(t, t->b))
        expect(t, (struct outcome){ IND, FAULT_FLAGS });
    else if (word_is_machine_zero(t->a))
        expect(t, plain_zero);
}

static void check_ROOT(const struct trial *t)
{
    if (word_is_indefinite(t->a))
        expect(t, plain_indefinite);
    else if (is_zero(t, t->a))
        expect(t, plain_zero);
    else if (format_coefficient(t->f, t->a) < 0)
        expect(t, (struct outcome){ IND, ROOT_FLAGS });
}

static void check_KEPT(const struct trial *t)
{
    if (word_is_indefinite(t->a))
        expect(t, (struct outcome){ t->a, INDEFINITE_FLAG });
    else if (word_is_machine_zero(t->a))
        expect(t, (struct outcome){ t->a, ZERO_FLAG });
}

static void check_PLAIN(const struct trial *t)
{
    if (word_is_indefinite(t->a))
        expect(t, plain_indefinite);
    else if (word_is_machine_zero(t->a))
        expect(t, plain_zero);
}

static void check_MAGNITUDE(const struct trial *t)
{
    if (format_coefficient(t->f, t->a) < 0)
        check_PLAIN(t);
    else
        check_KEPT(t);
}

/* A normalised number overflows if it is shifted by one more place. */
static void check_FITTED(const struct trial *t)
{
    int32_t exponent = format_exponent(t->f, t->a);
    struct trial too_long = *t;
    check_PLAIN(t);
    too_long.b = format_make(t->f, 0, exponent - 1);
    if (!word_is_indefinite(t->a) && format_is_normalised(t->f, t->a))
        expect(&too_long, (struct outcome){ IND, OVERFLOW_FLAGS });
}

static void check_FIELD(const struct trial *t)
{
    int32_t exponent = format_exponent(t->f, t->a);
    expect(t, (struct outcome){ format_make(t->f, 0, exponent), 0 });
}

/* Words become half words by a shift of 24 places, or 25 after a long rounding. */
static void check_CONTRACTED(const struct trial *t)
{
    int32_t exponent = format_exponent(t->f, t->a) + 24;
    check_PLAIN(t);
    if (word_is_machine_zero(t->a) || word_is_indefinite(t->a))
        return;
    if (exponent > 111)
        expect(t, (struct outcome){ IND, OVERFLOW_FLAGS });
    else if (exponent + 1 < -112)
        expect(t, plain_zero);
    else if (exponent >= -112 && exponent < 111)
        assert_int_equal(result_of(t).flags, 0);
}

static void check_EXTENDED(const struct trial *t)
{
    check_PLAIN(t);
    if (!word_is_machine_zero(t->a) && !word_is_indefinite(t->a))
        assert_int_equal(result_of(t).flags, 0);
}

/* ---- The operations ----------------------------------------------------- */

static const struct operation operations[] = {
/* clang-format off */
#define WORDS { 16, 47 }
#define HALVES { 8, 23 }
#define BINARY(name, spans, registers, specials) \
    { #name, WORDS, arith_##name, NULL, check_##specials }, \
    { #name, HALVES, half_##name, NULL, check_##specials },
#define UNARY(name, spans, registers, specials) \
    { #name, WORDS, NULL, arith_##name, check_##specials }, \
    { #name, HALVES, NULL, half_##name, check_##specials },
#define CONVERSION(name, of, specials) \
    { #name, of, NULL, arith_##name, check_##specials },
/* clang-format on */
#include "vm/arith.def"
};

static void check_operation(const struct operation *operation)
{
    uint64_t seed = RANDOM_SEED;
    struct trial t = { operation, operation->f, 0, 0 };
    for (int i = 0; i < ROUNDS; i++) {
        t.a = any_word(t.f, &seed);
        t.b = any_word(t.f, &seed);
        operation->specials(&t);
    }
}

TEST(operations)
{
    for (size_t i = 0; i < COUNT(operations); i++)
        check_operation(&operations[i]);
}

/* ---- Relations: ORDER --------------------------------------------------- */

static const struct ordering {
    word_format f;
    arith_relation *equal, *not_equal, *holds;
} relations[] = {
/* clang-format off */
#define RELATION(name) \
    { WORDS, arith_equal, arith_not_equal, arith_##name }, \
    { HALVES, half_equal, half_not_equal, half_##name },
/* clang-format on */
#include "vm/arith.def"
};

/* Indefinites are unequal to all, and unordered. A machine zero equals every zero. */
static void check_relation(const struct ordering *relation, uint64_t *seed)
{
    word_format f = relation->f;
    c205_word a = any_word(f, seed), b = any_word(f, seed);
    c205_word odd = any_indefinite(f, seed) & format_mask(f);
    c205_word none = any_machine_zero(f, seed) & format_mask(f);
    c205_word zero = format_make(f, any_exponent(f, seed), 0);
    bool of_nothing = relation->holds == relation->not_equal;
    assert_int_equal(relation->holds(odd, b), of_nothing);
    assert_int_equal(relation->holds(a, odd), of_nothing);
    assert_int_equal(relation->holds(none, b), relation->holds(zero, b));
    assert_int_equal(relation->holds(a, none), relation->holds(a, zero));
    assert_true(relation->equal(none, zero));
}

TEST(relations)
{
    uint64_t seed = RANDOM_SEED;
    for (size_t i = 0; i < COUNT(relations); i++)
        for (int n = 0; n < ROUNDS; n++)
            check_relation(&relations[i], &seed);
}
