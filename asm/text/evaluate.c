/* evaluate.c - evaluates expressions to integers, words, half words and addresses. */
#include "asm/text/expression_tree.h"
#include "asm/text/suggest.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

enum { HALF_BITS = 32, HALF_INTEGERS = 1 << 24 };

static bool is_logical(int code)
{
    return code == OPERATOR('&', '&') || code == OPERATOR('|', '|');
}

/* ---- Evaluation ---- */

static bool report_undefined(struct assembler *assembler, const struct line *line,
                             const struct expression *expression)
{
    const struct symbol *symbol = expression->symbol;
    const char *meant = suggest(assembler, SUGGEST_VALUE, symbol->name, symbol->length);
    return report(assembler, line, expression->at, "'%s' is not defined%s%s%s%s",
                  symbol->name, assembler->expander ? " before this line" : "",
                  meant ? "; did you mean " : "", meant ? meant : "", meant ? "?" : "");
}

static bool value_of_symbol(struct assembler *assembler, const struct line *line,
                            const struct expression *expression, struct value *value)
{
    const struct symbol *symbol = expression->symbol;
    switch (symbol->kind) {
    case SYMBOL_LABEL:
    case SYMBOL_CONSTANT: *value = symbol->value; return true;
    case SYMBOL_REGISTER:
    case SYMBOL_HALF_REGISTER:
        return report(assembler, line, expression->at,
                      "expected a number, found the register '%s'", symbol->name);
    default: return report_undefined(assembler, line, expression);
    }
}

static bool word_of(struct assembler *assembler, const struct line *line,
                    const struct expression *expression, const struct value *value,
                    c205_word *word)
{
    int64_t integer = (int64_t)value->bits;
    *word = value->bits;
    if (value->kind != VALUE_INTEGER)
        return true;
    if (integer < -((int64_t)1 << 47) || integer >= (int64_t)1 << 48)
        return report(
            assembler, line, expression->at,
            "expected a value of 48 bits; write 64 bits as X'..' or word(..)");
    *word = c205_from_integer(integer);
    return true;
}

static bool operand(struct assembler *assembler, const struct line *line,
                    const struct expression *expression, int64_t *integer)
{
    struct value value;
    if (!evaluate(assembler, line, expression, &value))
        return false;
    if (value.kind == VALUE_FLOATING)
        return report(assembler, line, expression->at,
                      "expected an integer, not a floating-point number");
    *integer = (int64_t)value.bits;
    return true;
}

/* ---- Floating-point numbers ---- */

/* Converts a value to an operand of the machine's arithmetic. An integer is
 * normalised. */
static bool machine_number(struct assembler *assembler, const struct line *line,
                           const struct expression *expression,
                           const struct value *value, c205_word *word)
{
    if (!word_of(assembler, line, expression, value, word))
        return false;
    if (value->kind == VALUE_INTEGER)
        *word = c205_from_double((double)(int64_t)value->bits);
    return true;
}

static bool compute(struct assembler *assembler, const struct line *line,
                    const struct expression *expression,
                    const struct constant_folder_function *function, c205_word x,
                    c205_word y, struct value *value)
{
    if (!assembler->constant_folder)
        assembler->constant_folder = constant_folder_new();
    if (!assembler->constant_folder) {
        assembler->arena->failed = true;
        return false;
    }
    value->kind = VALUE_FLOATING;
    value->bits = constant_folder_compute(assembler->constant_folder, function, x, y);
    if (value->bits == C205_INDEFINITE)
        return report(assembler, line, expression->at, "the result is indefinite");
    if (!function->is_integer)
        return true;
    if (fabs(c205_to_double(value->bits)) >= 0x1p47)
        return report(assembler, line, expression->at, "the result must be below 2^47");
    value->kind = VALUE_INTEGER;
    value->bits = (uint64_t)c205_to_integer(value->bits);
    return true;
}

static bool evaluate_function(struct assembler *assembler, const struct line *line,
                              const struct expression *expression, struct value *result)
{
    const struct expression *argument[] = { expression->left, expression->right };
    c205_word word[] = { 0, 0 };
    bool good = true;
    for (size_t i = 0; i < 2 && argument[i]; i++) {
        struct value value;
        good = evaluate(assembler, line, argument[i], &value)
               && machine_number(assembler, line, argument[i], &value, &word[i])
               && good;
    }
    return good
           && compute(assembler, line, expression, expression->function, word[0],
                      word[1], result);
}

/* The operators and their comparisons. The machine has no > and <=, so a > b is
 * computed as b < a, and a <= b as b >= a. */
static const struct number_operator {
    int code;
    const char *name;
    bool turned;
} number_operators[] = {
    { '+', "+", false },
    { '-', "-", false },
    { '*', "*", false },
    { '/', "/", false },
    { '<', "<", false },
    { '>', "<", true },
    { OPERATOR('<', '='), ">=", true },
    { OPERATOR('>', '='), ">=", false },
    { OPERATOR('=', '='), "==", false },
    { OPERATOR('!', '='), "!=", false },
};

static const struct number_operator *number_operator(int code)
{
    for (size_t i = 0; i < sizeof number_operators / sizeof *number_operators; i++)
        if (number_operators[i].code == code)
            return &number_operators[i];
    return NULL;
}

static bool calculate_numbers(struct assembler *assembler, const struct line *line,
                              const struct expression *expression,
                              const struct value *left, const struct value *right,
                              struct value *result)
{
    const struct number_operator *rule = number_operator(expression->code);
    c205_word x, y;
    if (!rule)
        return report(assembler, line, expression->at,
                      "this operator requires integers, not floating-point numbers");
    return machine_number(assembler, line, expression->left, left, &x)
           && machine_number(assembler, line, expression->right, right, &y)
           && compute(assembler, line, expression,
                      constant_folder_find(rule->name, strlen(rule->name)),
                      rule->turned ? y : x, rule->turned ? x : y, result);
}

/* ---- Operators ---- */

/* Evaluates && or ||. The right side is evaluated only if the left side does not
 * determine the result. */
static bool evaluate_logical(struct assembler *assembler, const struct line *line,
                             const struct expression *expression, uint64_t *result)
{
    bool is_and = expression->code == OPERATOR('&', '&');
    int64_t left = 0, right = 0;
    if (!operand(assembler, line, expression->left, &left))
        return false;
    if (is_and == (left != 0) && !operand(assembler, line, expression->right, &right))
        return false;
    *result = is_and ? left && right : left || right;
    return true;
}

static bool evaluate_binary(struct assembler *assembler, const struct line *line,
                            const struct expression *expression, struct value *result)
{
    struct value left, right;
    const char *problem;
    bool good = evaluate(assembler, line, expression->left, &left);
    if (!evaluate(assembler, line, expression->right, &right) || !good)
        return false;
    if (left.kind == VALUE_FLOATING || right.kind == VALUE_FLOATING)
        return calculate_numbers(assembler, line, expression, &left, &right, result);
    problem = integer_operation(expression->code, (int64_t)left.bits,
                                (int64_t)right.bits, &result->bits);
    return !problem || report(assembler, line, expression->at, "%s", problem);
}

static bool evaluate_unary(struct assembler *assembler, const struct line *line,
                           const struct expression *expression, struct value *result)
{
    struct value value;
    if (!evaluate(assembler, line, expression->left, &value))
        return false;
    if (value.kind == VALUE_FLOATING && expression->code == '-')
        return compute(assembler, line, expression, constant_folder_find("-", 1),
                       C205_MACHINE_ZERO, value.bits, result);
    if (value.kind == VALUE_FLOATING)
        return report(assembler, line, expression->at,
                      "this operator requires integers, not floating-point numbers");
    result->bits = integer_negation(expression->code, value.bits);
    return true;
}

bool evaluate(struct assembler *assembler, const struct line *line,
              const struct expression *expression, struct value *value)
{
    int64_t integer = 0;
    value->kind = VALUE_INTEGER;
    switch (expression->operation) {
    case VALUE: *value = expression->value; return true;
    case SYMBOL: return value_of_symbol(assembler, line, expression, value);
    case BITS: return evaluate_word(assembler, line, expression->left, &value->bits);
    case WORD:
        value->kind = VALUE_WORD;
        if (!operand(assembler, line, expression->left, &integer))
            return false;
        value->bits = (uint64_t)integer;
        return true;
    case FUNCTION: return evaluate_function(assembler, line, expression, value);
    case UNARY: return evaluate_unary(assembler, line, expression, value);
    default:
        return is_logical(expression->code)
                   ? evaluate_logical(assembler, line, expression, &value->bits)
                   : evaluate_binary(assembler, line, expression, value);
    }
}

bool evaluate_integer(struct assembler *assembler, const struct line *line,
                      const struct expression *expression, int64_t *integer)
{
    return operand(assembler, line, expression, integer);
}

bool evaluate_range(struct assembler *assembler, const struct line *line,
                    const struct expression *expression, int64_t low, int64_t high,
                    const char *what, int64_t *integer)
{
    if (!evaluate_integer(assembler, line, expression, integer))
        return false;
    if (*integer < low || *integer > high)
        return report(assembler, line, expression->at,
                      "expected %s from %" PRId64 " to %" PRId64 ", found %" PRId64,
                      what, low, high, *integer);
    return true;
}

bool evaluate_word(struct assembler *assembler, const struct line *line,
                   const struct expression *expression, c205_word *word)
{
    struct value value;
    return evaluate(assembler, line, expression, &value)
           && word_of(assembler, line, expression, &value, word);
}

bool evaluate_half(struct assembler *assembler, const struct line *line,
                   const struct expression *expression, c205_word *half)
{
    struct value value;
    int64_t integer = 0;
    bool good = evaluate(assembler, line, expression, &value);
    if (!good)
        return false;
    switch (value.kind) {
    case VALUE_FLOATING: /* rounding down twice equals rounding down once */
        *half = c205_half_from_double(c205_to_double(value.bits));
        return true;
    case VALUE_WORD:
        *half = value.bits << HALF_BITS;
        return value.bits <= UINT32_MAX
               || report(assembler, line, expression->at,
                         "expected a half word, of 8 hex digits");
    default:
        good = evaluate_range(assembler, line, expression, -HALF_INTEGERS / 2,
                              HALF_INTEGERS - 1, "an integer of 24 bits", &integer);
        *half = (c205_word)(integer & (HALF_INTEGERS - 1)) << HALF_BITS;
        return good;
    }
}

bool evaluate_address(struct assembler *assembler, const struct line *line,
                      const struct expression *expression, uint64_t *address)
{
    int64_t integer = 0;
    if (!evaluate_range(assembler, line, expression, 0,
                        ((int64_t)1 << ADDRESS_BITS) - 1, "a bit address", &integer))
        return false;
    *address = (uint64_t)integer;
    return true;
}
