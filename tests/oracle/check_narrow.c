/* check_narrow.c - compares the machine's rules with an oracle for all words of a
 * narrow format.
 *
 *     check_narrow [--operation NAME] [some | all]
 *
 * vm/number/rule.h is compiled for words of any format. Here it is compiled for words
 * of 6 + 8 bits, and is applied to every word or to every pair of words. Unless "all"
 * is specified, some exponents are omitted, but no coefficients. The test fails if a
 * word or a flag differs from narrow_oracle.c. That oracle is first compared, on a
 * sample, with the oracle of the larger formats.
 */
#include "arithmetic_oracle.h"
#include "narrow_oracle.h"
#include "operands.h"
#include "tests/oracle/give_up.h"
#include "tests/oracle/read_options.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

/* ---- The operations ----------------------------------------------------- */

struct operation {
    const char *name;
    bool unary;
    oracle_rule *oracle;
    small_rule *expected, *machine;
};

#define BINARY(name, ...) CALL_BINARY(narrow_##name)
#define UNARY(name, ...) CALL_UNARY(narrow_##name)
#define RELATION(name) CALL_RELATION(narrow_##name)
#include "vm/arith.def"

static const struct operation operations[] = {
#define ROW(name, unary) \
    { #name, unary, oracle_##name, small_##name, call_narrow_##name },
#define BINARY(name, ...) ROW(name, false)
#define UNARY(name, ...) ROW(name, true)
#define RELATION(name) ROW(name, false)
#include "vm/arith.def"
};

enum { OPERATION_COUNT = sizeof operations / sizeof operations[0] };

/* ---- The words ---------------------------------------------------------- */

enum {
    EXPONENTS = 1 << NARROW_EXPONENT_BITS,
    COEFFICIENTS = 2 << NARROW_DIGITS,
    MAX_WORDS = EXPONENTS * COEFFICIENTS
};

struct words {
    size_t n;
    c205_word at[MAX_WORDS];
};

static void add_words(struct words *words, int64_t exponent)
{
    for (int64_t c = 0; c < COEFFICIENTS; c++)
        words->at[words->n++] = narrow_word(exponent, c);
}

static void every_word(struct words *words)
{
    for (int64_t e = 0; e < EXPONENTS; e++)
        add_words(words, e);
}

/* Adds all words with these exponents: machine zero, indefinite, the ends of the range,
 * and exponents at distances below, at and above the length of a coefficient. */
static void some_words(struct words *words)
{
    static const int64_t exponents[] = { NARROW_EXPONENT_MIN - 1,
                                         NARROW_EXPONENT_MAX + 1,
                                         NARROW_EXPONENT_MIN,
                                         NARROW_EXPONENT_MIN + 1,
                                         -NARROW_DIGITS - 1,
                                         -NARROW_DIGITS,
                                         -1,
                                         0,
                                         NARROW_DIGITS,
                                         NARROW_EXPONENT_MAX };
    for (size_t i = 0; i < sizeof exponents / sizeof exponents[0]; i++)
        add_words(words, exponents[i]);
}

/* ---- One operation ------------------------------------------------------ */

/* No operation sets or clears this flag, so it must still be set afterwards. */
#define EARLIER_FLAG UINT64_C(1)

static void show(const char *which, c205_word word, uint64_t flags)
{
    printf("    %s %016" PRIX64 " (%" PRId64 " x 2^%" PRId64 ") flags %06" PRIX64 "\n",
           which, word, narrow_coefficient_of(word), narrow_exponent_of(word), flags);
}

static bool pair_agrees(const struct operation *operation, c205_word a, c205_word b)
{
    uint64_t expected_flags = EARLIER_FLAG, flags = EARLIER_FLAG;
    c205_word expected = operation->expected(a, b, &expected_flags);
    c205_word got = operation->machine(a, b, &flags);
    if (expected == got && expected_flags == flags)
        return true;
    printf("%s\n", operation->name);
    show("of      ", a, 0);
    show("and     ", b, 0);
    show("expected", expected, expected_flags);
    show("got     ", got, flags);
    return false;
}

static bool check_operation(const struct operation *operation,
                            const struct words *words)
{
    size_t second = operation->unary ? 1 : words->n;
    for (size_t i = 0; i < words->n; i++)
        for (size_t j = 0; j < second; j++)
            if (!pair_agrees(operation, words->at[i], words->at[j]))
                return false;
    return true;
}

/* Compares the two oracles. Every word is the first operand. */
static bool oracles_agree(const struct operation *operation, const struct words *words)
{
    enum { PARTNERS = 16 };
    uint64_t random = 205;
    for (size_t i = 0; i < words->n * PARTNERS; i++) {
        uint64_t one = 0, other = 0;
        c205_word a = words->at[i / PARTNERS];
        c205_word b = words->at[random_bits(&random) % words->n];
        c205_word small = operation->expected(a, b, &one);
        c205_word exact = operation->oracle(&oracle_narrow, a, b, &other);
        if (small != exact || one != other) {
            printf("the oracles differ: %s\n", operation->name);
            show("of      ", a, 0);
            show("and     ", b, 0);
            show("integers", small, one);
            show("exact   ", exact, other);
            return false;
        }
    }
    return true;
}

/* ---- The run ------------------------------------------------------------ */

struct run {
    const char *only; /* NULL: all operations */
    struct words words;
    unsigned passed, failed;
};

static void check_everything(struct run *run)
{
    static struct words every;
    every_word(&every);
    for (size_t i = 0; i < OPERATION_COUNT; i++) {
        const struct operation *operation = operations + i;
        if (run->only && strcmp(run->only, operation->name) != 0)
            continue;
        size_t cases = operation->unary ? every.n : run->words.n * run->words.n;
        bool pass = oracles_agree(operation, &every)
                    && check_operation(operation,
                                       operation->unary ? &every : &run->words);
        run->passed += pass;
        run->failed += !pass;
        printf("%-24s %9zu %s\n", operation->name, cases, pass ? "ok" : "FAILED");
        fflush(stdout);
    }
}

int main(int argc, char **argv)
{
    static struct run run;
    const char *wanted = "some";
    const struct check_option options[] = {
        { .name = "operation", .text = &run.only },
        { .text = &wanted },
    };
    READ_OPTIONS(argc, argv, "check_narrow [--operation NAME] [some | all]", options);
    if (strcmp(wanted, "all") != 0 && strcmp(wanted, "some") != 0)
        give_up("neither some nor all");
    (strcmp(wanted, "all") == 0 ? every_word : some_words)(&run.words);
    small_begin();
    oracle_begin();
    check_everything(&run);
    oracle_end();
    if (run.passed + run.failed == 0) {
        fprintf(stderr, "check_narrow: no operation %s\n", run.only);
        return 2;
    }
    printf("%u passed, %u failed\n", run.passed, run.failed);
    return run.failed == 0 ? 0 : 1;
}
