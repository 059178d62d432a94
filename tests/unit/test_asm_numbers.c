/* test_asm_numbers.c - floating-point expressions. The words that the assembler
 * computes for random expressions are compared with the machine's rules, operation by
 * operation. Values of functions are compared with the machine's routines. A different
 * rounding fails here. */
#include <inttypes.h>

#include "tests/oracle/arithmetic_oracle.h"
#include "tests/oracle/chance.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/saved_machine.h"

enum { TRIES = 400, TEXT = 4000, DEPTH = 5 };

static uint64_t state = RANDOM_SEED;

/* ---- Trees of operations ------------------------------------------------- */

/* A random expression: its text and its expected value. */
struct drawn {
    char text[TEXT];
    bool is_integer;
    int64_t integer;
    c205_word word;
    bool good; /* the expression has a value */
};

static c205_word number_of(const struct drawn *drawn)
{
    return drawn->is_integer ? c205_from_double((double)drawn->integer) : drawn->word;
}

static void draw_leaf(struct drawn *drawn)
{
    const char *end;
    drawn->good = true;
    drawn->is_integer = one_in(&state, 3);
    if (drawn->is_integer) {
        drawn->integer = xorshift_between(&state, 0, 1000);
        snprintf(drawn->text, TEXT, "%" PRId64, drawn->integer);
    } else {
        snprintf(drawn->text, TEXT, "%.*g", (int)below(&state, 16) + 1,
                 of_any_size(&state, 1e-3, 1e6));
        if (!strpbrk(drawn->text, ".e"))
            strcat(drawn->text, ".0");
        drawn->word = c205_from_text(drawn->text, &end);
    }
}

static void draw_value(struct drawn *drawn, int depth);

static void draw_sum(struct drawn *drawn, int depth)
{
    static const struct {
        const char *text;
        oracle_rule *rule;
    } operations[] = { { "+", oracle_add_normalised },
                       { "-", oracle_subtract_normalised },
                       { "*", oracle_multiply_significant },
                       { "/", oracle_divide_significant } };
    const char *made = "";
    size_t i = below(&state, 4);
    FREED struct drawn *sides = calloc(2, sizeof *sides);
    uint64_t flags = 0;
    draw_value(&sides[0], depth);
    draw_value(&sides[1], depth);
    /* Operators on two integers are integer operators, so one operand is converted. */
    if (sides[0].is_integer && sides[1].is_integer) {
        sides[0].word = number_of(&sides[0]);
        sides[0].is_integer = false;
        made = "float";
    }
    snprintf(drawn->text, TEXT, "%s(%.1900s) %s (%.1900s)", made, sides[0].text,
             operations[i].text, sides[1].text);
    drawn->is_integer = false;
    drawn->word = operations[i].rule(&oracle_full, number_of(&sides[0]),
                                     number_of(&sides[1]), &flags);
    drawn->good = sides[0].good && sides[1].good && drawn->word != C205_INDEFINITE;
}

static const char *const operators[] = { "<", ">=", ">", "<=", "==", "!=" };

static void draw_comparison(struct drawn *drawn, int depth)
{
    size_t i = below(&state, COUNT(operators));
    FREED struct drawn *sides = calloc(2, sizeof *sides);
    uint64_t flags = 0;
    draw_value(&sides[0], depth);
    draw_value(&sides[1], depth);
    if (one_in(&state, 4))
        sides[1] = sides[0];
    c205_word left = number_of(&sides[0]);
    c205_word right = number_of(&sides[1]);
    bool less = oracle_less(&oracle_full, left, right, &flags);
    bool greater = oracle_less(&oracle_full, right, left, &flags);
    bool equal = oracle_equal(&oracle_full, left, right, &flags);
    const bool results[] = { less, !less, greater, !greater, equal, !equal };
    snprintf(drawn->text, TEXT, "(%.1900s) %s (%.1900s)", sides[0].text, operators[i],
             sides[1].text);
    drawn->is_integer = true;
    drawn->integer = results[i];
    drawn->good = sides[0].good && sides[1].good;
}

static void draw_unary(struct drawn *drawn, int depth)
{
    FREED struct drawn *inside = calloc(1, sizeof *inside);
    uint64_t flags = 0;
    draw_value(inside, depth);
    c205_word word = number_of(inside);
    drawn->is_integer = false;
    drawn->good = inside->good;
    switch (below(&state, 4)) {
    case 0:
        snprintf(drawn->text, TEXT, "-float(%.3900s)", inside->text);
        drawn->word = oracle_subtract_normalised(&oracle_full, C205_MACHINE_ZERO, word,
                                                 &flags);
        break;
    case 1:
        snprintf(drawn->text, TEXT, "sqrt(%.3900s)", inside->text);
        drawn->word = oracle_square_root(&oracle_full, word, 0, &flags);
        break;
    case 2:
        snprintf(drawn->text, TEXT, "floor(%.3900s)", inside->text);
        drawn->is_integer = true;
        drawn->integer = c205_to_integer(oracle_floor(&oracle_full, word, 0, &flags));
        drawn->good = drawn->good && fabs(c205_to_double(word)) < 0x1p47;
        break;
    default:
        snprintf(drawn->text, TEXT, "float(%.3900s)", inside->text);
        drawn->word = word;
    }
    drawn->good = drawn->good && (drawn->is_integer || drawn->word != C205_INDEFINITE);
}

static void draw_value(struct drawn *drawn, int depth)
{
    switch (depth == 0 ? 0 : below(&state, 8)) {
    case 0: draw_leaf(drawn); break;
    case 1: draw_comparison(drawn, depth - 1); break;
    case 2:
    case 3: draw_unary(drawn, depth - 1); break;
    default: draw_sum(drawn, depth - 1);
    }
}

static struct object *assemble_value(const char *text)
{
    static char program[TEXT + 100];
    SCOPED_VALUE(diagnostics) errors = { 0 };
    snprintf(program, sizeof program,
             "        .data\n        .word   %s\n        .code\n        EXIT\n", text);
    return assemble_text("test.s", program, NULL, &errors);
}

TEST(operations)
{
    static struct drawn drawn;
    int values = 0;
    for (int i = 0; i < TRIES; i++) {
        draw_value(&drawn, DEPTH);
        SCOPED(object) *object = assemble_value(drawn.text);
        FAIL_IF(drawn.good != (bool)object, "%s: it has %s value", drawn.text,
                drawn.good ? "a" : "no");
        if (!object)
            continue;
        c205_word word = word_of(&object->program, 0x800000);
        c205_word expected = drawn.is_integer ? c205_from_integer(drawn.integer)
                                              : drawn.word;
        if (word != expected) {
            fail_msg("%s: %016" PRIX64 " should be %016" PRIX64, drawn.text, word,
                     expected);
        }
        values++;
    }
    assert_true(values > TRIES / 2);
}

/* ---- Functions ----------------------------------------------------------- */

/* The assembler's value must equal the value that the running program computes. */
static void check_function(const char *name, bool two)
{
    double x = of_any_size(&state, 1e-3, 100);
    double y = of_any_size(&state, 1e-3, 10) * (one_in(&state, 2) ? -1 : 1);
    char second[40] = "", program[1000];
    if (two)
        snprintf(second, sizeof second, ", %.9f", y);
    snprintf(program, sizeof program,
             "        .include \"%s.s\"\n        .regs   r10, x, y, r, s\n"
             "        load_constant x, %.9f\n"
             "        load_constant y, %.9f\n"
             "        apply_two %s, x, y, r\n"
             "        load_constant s, %s(%.9f%s)\n        EXIT\n",
             strcmp(name, "cos") == 0 ? "sin" : name, x, y, name, name, x, second);
    SCOPED(object) *object = good(program);
    SCOPED(c205) *machine = machine_with(&object->program, prior_model);
    assert_int_equal(c205_run(machine, C205_NO_LIMIT).trap, C205_TRAP_NONE);
    c205_word computed = c205_register(machine, 13);
    if (c205_register(machine, 12) != computed) {
        fail_msg("%s(%.9f%s) is %016" PRIX64 " at assembly, %016" PRIX64 " in a run",
                 name, x, second, computed, c205_register(machine, 12));
    }
}

/* A word may be indefinite. Then only the comparison != is true. */
TEST(indefinite)
{
    for (size_t i = 0; i < COUNT(operators); i++) {
        const char *text = formatted("X'7000 0000 0000 0000' %s 1.0", operators[i]);
        SCOPED(object) *object = NON_NULL(assemble_value(text));
        assert_int_equal(word_of(&object->program, 0x800000), i == 5);
    }
}

TEST(functions)
{
    for (int i = 0; i < 4; i++) {
        check_function("exp", false);
        check_function("log", false);
        check_function("sin", false);
        check_function("cos", false);
        check_function("atan2", true);
        check_function("power", true);
    }
}

GROUP(set_up_both, tear_down_both);
