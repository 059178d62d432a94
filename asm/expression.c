#include "asm/expression.h"
#include "asm/calculator.h"
#include "asm/suggest.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

enum operation { VALUE, SYMBOL, UNARY, BINARY, BITS, WORD, FUNCTION };

enum { HALF_BITS = 32, HALF_INTEGERS = 1 << 24 };

struct expression {
    enum operation operation;
    int code;
    unsigned depth;
    const char *at;
    struct value value;
    const struct symbol *symbol;
    const struct calculator_function *function;
    const struct expression *left, *right;
};

static const struct {
    int code;
    int level; /* binds tighter the higher it is */
} precedences[] = { { OPERATOR('|', '|'), 1 },
                    { OPERATOR('&', '&'), 2 },
                    { '|', 3 },
                    { '^', 4 },
                    { '&', 5 },
                    { OPERATOR('=', '='), 6 },
                    { OPERATOR('!', '='), 6 },
                    { '<', 7 },
                    { '>', 7 },
                    { OPERATOR('<', '='), 7 },
                    { OPERATOR('>', '='), 7 },
                    { OPERATOR('<', '<'), 8 },
                    { OPERATOR('>', '>'), 8 },
                    { '+', 9 },
                    { '-', 9 },
                    { '*', 10 },
                    { '/', 10 },
                    { '%', 10 } };

static int precedence(const struct cursor *cursor)
{
    size_t i;

    for (i = 0; i < sizeof precedences / sizeof *precedences; i++)
        if (cursor_at(cursor, precedences[i].code))
            return precedences[i].level;
    return 0;
}

/* ---- Arithmetic ---- */

static uint64_t shift_right(int64_t a, uint64_t count)
{
    return a < 0 ? ~(~(uint64_t)a >> count) : (uint64_t)a >> count;
}

static const char *divide(int code, int64_t a, int64_t b, uint64_t *result)
{
    if (b == 0)
        return "division by zero";
    if (a == INT64_MIN && b == -1)
        return "this quotient does not fit 64 bits";
    *result = (uint64_t)(code == '/' ? a / b : a % b);
    return NULL;
}

static const char *shift(int code, int64_t a, int64_t b, uint64_t *result)
{
    if (b < 0 || b > 63)
        return "a shift count goes from 0 to 63";
    if (code == OPERATOR('<', '<'))
        *result = (uint64_t)a << b;
    else
        *result = shift_right(a, (uint64_t)b);
    return NULL;
}

/* NULL, or what is wrong. */
static const char *calculate(int code, int64_t a, int64_t b, uint64_t *result)
{
    uint64_t ua = (uint64_t)a, ub = (uint64_t)b;

    switch (code) {
    case '+': *result = ua + ub; break;
    case '-': *result = ua - ub; break;
    case '*': *result = ua * ub; break;
    case '&': *result = ua & ub; break;
    case '|': *result = ua | ub; break;
    case '^': *result = ua ^ ub; break;
    case '<': *result = a < b; break;
    case '>': *result = a > b; break;
    case OPERATOR('<', '='): *result = a <= b; break;
    case OPERATOR('>', '='): *result = a >= b; break;
    case OPERATOR('=', '='): *result = a == b; break;
    case OPERATOR('!', '='): *result = a != b; break;
    case OPERATOR('&', '&'): *result = a && b; break;
    case OPERATOR('|', '|'): *result = a || b; break;
    case '/':
    case '%': return divide(code, a, b, result);
    default: return shift(code, a, b, result);
    }
    return NULL;
}

static bool is_logical(int code)
{
    return code == OPERATOR('&', '&') || code == OPERATOR('|', '|');
}

static uint64_t negate(int code, uint64_t a)
{
    return code == '-' ? 0 - a : code == '~' ? ~a : !a;
}

/* ---- Evaluation ---- */

static bool report_undefined(struct assembler *assembler,
                             const struct line *line,
                             const struct expression *expression)
{
    const struct symbol *symbol = expression->symbol;
    const char *meant = suggest(assembler, SUGGEST_VALUE, symbol->name,
                                symbol->length);

    return report(assembler, line, expression->at,
                  "'%s' is not defined%s%s%s%s", symbol->name,
                  assembler->expander ? " before this line" : "",
                  meant ? "; did you mean " : "", meant ? meant : "",
                  meant ? "?" : "");
}

static bool value_of_symbol(struct assembler *assembler,
                            const struct line *line,
                            const struct expression *expression,
                            struct value *value)
{
    const struct symbol *symbol = expression->symbol;

    switch (symbol->kind) {
    case SYMBOL_LABEL:
    case SYMBOL_CONSTANT: *value = symbol->value; return true;
    case SYMBOL_REGISTER:
    case SYMBOL_HALF_REGISTER:
        return report(assembler, line, expression->at,
                      "expected a number, '%s' is a register", symbol->name);
    default: return report_undefined(assembler, line, expression);
    }
}

/* As a word of memory. */
static bool word_of(struct assembler *assembler, const struct line *line,
                    const struct expression *expression,
                    const struct value *value, c205_word *word)
{
    int64_t integer = (int64_t)value->bits;

    *word = value->bits;
    if (value->kind != VALUE_INTEGER)
        return true;
    if (integer < -((int64_t)1 << 47) || integer >= (int64_t)1 << 48)
        return report(assembler, line, expression->at,
                      "expected a value of"
                      " 48 bits; all 64 are written X'..' or word(..)");
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

/* A value as what an operation of the machine is given: integers normalised. */
static bool number_of(struct assembler *assembler, const struct line *line,
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
                    const struct calculator_function *function, c205_word x,
                    c205_word y, struct value *value)
{
    if (!assembler->calculator)
        assembler->calculator = calculator_new();
    if (!assembler->calculator) {
        assembler->arena->failed = true;
        return false;
    }
    value->kind = VALUE_FLOATING;
    value->bits = calculator_compute(assembler->calculator, function, x, y);
    if (value->bits == C205_INDEFINITE)
        return report(assembler, line, expression->at,
                      "the machine has no number for this");
    if (!function->is_integer)
        return true;
    if (fabs(c205_to_double(value->bits)) >= 0x1p47)
        return report(assembler, line, expression->at,
                      "expected less than 2^47");
    value->kind = VALUE_INTEGER;
    value->bits = (uint64_t)c205_to_integer(value->bits);
    return true;
}

static bool evaluate_function(struct assembler *assembler,
                              const struct line *line,
                              const struct expression *expression,
                              struct value *result)
{
    const struct expression *argument[] = { expression->left,
                                            expression->right };
    c205_word word[] = { 0, 0 };
    bool good = true;

    for (size_t i = 0; i < 2 && argument[i]; i++) {
        struct value value;

        good = evaluate(assembler, line, argument[i], &value)
               && number_of(assembler, line, argument[i], &value, &word[i])
               && good;
    }
    return good
           && compute(assembler, line, expression, expression->function,
                      word[0], word[1], result);
}

/* a > b is b < a, a <= b is b >= a. */
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
    size_t i;

    for (i = 0; i < sizeof number_operators / sizeof *number_operators; i++)
        if (number_operators[i].code == code)
            return &number_operators[i];
    return NULL;
}

static bool calculate_numbers(struct assembler *assembler,
                              const struct line *line,
                              const struct expression *expression,
                              const struct value *left,
                              const struct value *right, struct value *result)
{
    const struct number_operator *rule = number_operator(expression->code);
    c205_word x, y;

    if (!rule)
        return report(assembler, line, expression->at,
                      "this operator is for integers,"
                      " not for floating-point numbers");
    return number_of(assembler, line, expression->left, left, &x)
           && number_of(assembler, line, expression->right, right, &y)
           && compute(assembler, line, expression,
                      calculator_find(rule->name, strlen(rule->name)),
                      rule->turned ? y : x, rule->turned ? x : y, result);
}

/* ---- Operators ---- */

/* && and ||: the right side counts where the left one does not tell. */
static bool evaluate_logical(struct assembler *assembler,
                             const struct line *line,
                             const struct expression *expression,
                             uint64_t *result)
{
    bool is_and = expression->code == OPERATOR('&', '&');
    int64_t left = 0, right = 0;

    if (!operand(assembler, line, expression->left, &left))
        return false;
    if (is_and == (left != 0)
        && !operand(assembler, line, expression->right, &right))
        return false;
    *result = is_and ? left && right : left || right;
    return true;
}

static bool evaluate_binary(struct assembler *assembler,
                            const struct line *line,
                            const struct expression *expression,
                            struct value *result)
{
    struct value left, right;
    const char *problem;
    bool good = evaluate(assembler, line, expression->left, &left);

    if (!evaluate(assembler, line, expression->right, &right) || !good)
        return false;
    if (left.kind == VALUE_FLOATING || right.kind == VALUE_FLOATING)
        return calculate_numbers(assembler, line, expression, &left, &right,
                                 result);
    problem = calculate(expression->code, (int64_t)left.bits,
                        (int64_t)right.bits, &result->bits);
    return !problem || report(assembler, line, expression->at, "%s", problem);
}

static bool evaluate_unary(struct assembler *assembler,
                           const struct line *line,
                           const struct expression *expression,
                           struct value *result)
{
    struct value value;

    if (!evaluate(assembler, line, expression->left, &value))
        return false;
    if (value.kind == VALUE_FLOATING && expression->code == '-')
        return compute(assembler, line, expression, calculator_find("-", 1),
                       C205_MACHINE_ZERO, value.bits, result);
    if (value.kind == VALUE_FLOATING)
        return report(assembler, line, expression->at,
                      "this operator is for integers,"
                      " not for floating-point numbers");
    result->bits = negate(expression->code, value.bits);
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
    case BITS:
        return evaluate_word(assembler, line, expression->left, &value->bits);
    case WORD:
        value->kind = VALUE_WORD;
        if (!operand(assembler, line, expression->left, &integer))
            return false;
        value->bits = (uint64_t)integer;
        return true;
    case FUNCTION:
        return evaluate_function(assembler, line, expression, value);
    case UNARY: return evaluate_unary(assembler, line, expression, value);
    default:
        return is_logical(expression->code)
                   ? evaluate_logical(assembler, line, expression,
                                      &value->bits)
                   : evaluate_binary(assembler, line, expression, value);
    }
}

bool evaluate_integer(struct assembler *assembler, const struct line *line,
                      const struct expression *expression, int64_t *integer)
{
    return operand(assembler, line, expression, integer);
}

bool evaluate_range(struct assembler *assembler, const struct line *line,
                    const struct expression *expression, int64_t low,
                    int64_t high, const char *what, int64_t *integer)
{
    if (!evaluate_integer(assembler, line, expression, integer))
        return false;
    if (*integer < low || *integer > high)
        return report(assembler, line, expression->at,
                      "expected %s from %" PRId64 " to %" PRId64
                      ", found %" PRId64,
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
    case VALUE_FLOATING: /* floor after floor is the floor of the decimal */
        *half = c205_half_from_double(c205_to_double(value.bits));
        return true;
    case VALUE_WORD:
        *half = value.bits << HALF_BITS;
        return value.bits <= UINT32_MAX
               || report(assembler, line, expression->at,
                         "expected a half word, of 8 hex digits");
    default:
        good = evaluate_range(assembler, line, expression, -HALF_INTEGERS / 2,
                              HALF_INTEGERS - 1, "an integer of 24 bits",
                              &integer);
        *half = (c205_word)(integer & (HALF_INTEGERS - 1)) << HALF_BITS;
        return good;
    }
}

bool evaluate_address(struct assembler *assembler, const struct line *line,
                      const struct expression *expression, uint64_t *address)
{
    int64_t integer = 0;

    if (!evaluate_range(assembler, line, expression, 0,
                        ((int64_t)1 << ADDRESS_BITS) - 1, "a bit address",
                        &integer))
        return false;
    *address = (uint64_t)integer;
    return true;
}

/* ---- Parsing ---- */

static struct expression *new_node(struct cursor *cursor, const char *at,
                                   enum operation operation)
{
    struct expression *node = arena_take(cursor->assembler->arena,
                                         sizeof *node);

    if (node) {
        node->operation = operation;
        node->at = at;
    }
    return node;
}

/* Work out now what needs no symbol; what fails is told by evaluate(). */
static void fold(struct expression *node)
{
    const struct expression *left = node->left, *right = node->right;
    uint64_t bits;

    if (left->operation != VALUE || left->value.kind == VALUE_FLOATING)
        return;
    if (node->operation == UNARY) {
        bits = negate(node->code, left->value.bits);
    } else if (right->operation != VALUE
               || right->value.kind == VALUE_FLOATING
               || calculate(node->code, (int64_t)left->value.bits,
                            (int64_t)right->value.bits, &bits)) {
        return;
    }
    node->operation = VALUE;
    node->value.kind = VALUE_INTEGER;
    node->value.bits = bits;
    node->depth = 0;
}

static struct expression *join(struct cursor *cursor, struct expression *node,
                               int code, const struct expression *left,
                               const struct expression *right)
{
    if (!node)
        return NULL;
    node->code = code;
    node->left = left;
    node->right = right;
    node->depth = 1 + left->depth;
    if (right && right->depth >= node->depth)
        node->depth = 1 + right->depth;
    fold(node);
    if (node->depth > MAX_EXPRESSION_DEPTH) {
        report(cursor->assembler, cursor->line, node->at,
               "this expression is nested too deeply");
        return NULL;
    }
    return node;
}

static const struct expression *parse_binary(struct cursor *cursor,
                                             int level);

static const struct expression *parse_symbol(struct cursor *cursor)
{
    struct expression *node = new_node(cursor, cursor->token.begin, SYMBOL);
    const char *name;
    size_t length;

    if (!node || !expect_name(cursor, "a name", &name, &length))
        return NULL;
    node->symbol = symbol_intern(cursor->assembler, name, length);
    return node->symbol ? node : NULL;
}

static const struct expression *parse_brackets(struct cursor *cursor)
{
    const struct expression *inside;

    if (!expect_operator(cursor, '(', "'('"))
        return NULL;
    inside = parse_binary(cursor, 1);
    if (!inside || !expect_operator(cursor, ')', "')'"))
        return NULL;
    return inside;
}

/* bits(value): the word, as an integer of 64 bits; word(integer): the word
 * that these bits make. */
static const struct expression *parse_function(struct cursor *cursor,
                                               enum operation operation)
{
    struct expression *node = new_node(cursor, cursor->token.begin,
                                       operation);

    cursor_next(cursor);
    if (!node || !(node->left = parse_brackets(cursor)))
        return NULL;
    node->depth = 1 + node->left->depth;
    return node;
}

/* sin(x), atan2(y, x) .. */
static const struct expression *
parse_computed(struct cursor *cursor,
               const struct calculator_function *function)
{
    struct expression *node = new_node(cursor, cursor->token.begin, FUNCTION);

    cursor_next(cursor);
    if (!node || !expect_operator(cursor, '(', "'('")
        || !(node->left = parse_binary(cursor, 1)))
        return NULL;
    node->function = function;
    node->depth = 1 + node->left->depth;
    if (function->arguments == 2) {
        if (!expect_operator(cursor, ',', "','")
            || !(node->right = parse_binary(cursor, 1)))
            return NULL;
        if (node->right->depth >= node->depth)
            node->depth = 1 + node->right->depth;
    }
    return expect_operator(cursor, ')', "')'") ? node : NULL;
}

/* length("text"): in bytes. */
static const struct expression *parse_length(struct cursor *cursor)
{
    struct expression *node = new_node(cursor, cursor->token.begin, VALUE);
    size_t length;

    cursor_next(cursor);
    if (!node || !expect_operator(cursor, '(', "'('")
        || !expect_string(cursor, &length)
        || !expect_operator(cursor, ')', "')'"))
        return NULL;
    node->value.bits = length;
    return node;
}

static const struct expression *parse_number(struct cursor *cursor)
{
    struct expression *node = new_node(cursor, cursor->token.begin, VALUE);

    if (!node)
        return NULL;
    node->value = cursor->token.value;
    cursor_next(cursor);
    return node;
}

static const struct expression *parse_here(struct cursor *cursor)
{
    struct expression *node = new_node(cursor, cursor->token.begin, VALUE);

    if (!node)
        return NULL;
    node->value.bits = cursor->assembler->section->at;
    cursor_next(cursor);
    return node;
}

/* A name before a bracket. */
static bool is_call(const struct token *token)
{
    const char *at = token->end;

    while (*at == ' ' || *at == '\t')
        at++;
    return token->kind == TOKEN_NAME && *at == '(';
}

static bool is_function(const struct token *token, const char *name)
{
    return is_call(token) && token_is(token, name);
}

static const struct calculator_function *computed(const struct token *token)
{
    return is_call(token)
               ? calculator_find(token->begin,
                                 (size_t)(token->end - token->begin))
               : NULL;
}

static const struct expression *parse_primary(struct cursor *cursor)
{
    const struct token *token = &cursor->token;

    if (token->kind == TOKEN_NUMBER)
        return parse_number(cursor);
    if (is_function(token, "bits"))
        return parse_function(cursor, BITS);
    if (is_function(token, "word"))
        return parse_function(cursor, WORD);
    if (is_function(token, "length"))
        return parse_length(cursor);
    if (computed(token))
        return parse_computed(cursor, computed(token));
    if (token->kind == TOKEN_NAME)
        return parse_symbol(cursor);
    if (cursor_at(cursor, '.'))
        return parse_here(cursor);
    if (cursor_at(cursor, '('))
        return parse_brackets(cursor);
    expected(cursor, "a number, a name or '('");
    return NULL;
}

/* -1.5 is cut to a word from its exact value, not negated afterwards. */
static const struct expression *parse_negative_number(struct cursor *cursor,
                                                      const char *at)
{
    struct expression *node = new_node(cursor, at, VALUE);
    char text[80] = "-";
    size_t length = (size_t)(cursor->token.end - cursor->token.begin);
    const char *end;

    if (!node)
        return NULL;
    if (length > sizeof text - 2) {
        report(cursor->assembler, cursor->line, at,
               "a negative number has at most %zu characters",
               sizeof text - 2);
        return NULL;
    }
    memcpy(text + 1, cursor->token.begin, length);
    node->value.kind = VALUE_FLOATING;
    node->value.bits = c205_from_text(text, &end);
    cursor_next(cursor);
    return node;
}

static const struct expression *parse_unary(struct cursor *cursor)
{
    const char *at = cursor->token.begin;
    const struct expression *left;
    struct expression *node;
    int code = cursor->token.code;

    if (!cursor_at(cursor, '-') && !cursor_at(cursor, '~')
        && !cursor_at(cursor, '!'))
        return parse_primary(cursor);
    cursor_next(cursor);
    if (code == '-' && cursor->token.kind == TOKEN_NUMBER
        && cursor->token.value.kind == VALUE_FLOATING)
        return parse_negative_number(cursor, at);
    node = new_node(cursor, at, UNARY);
    left = parse_binary(cursor, 11);
    return left ? join(cursor, node, code, left, NULL) : NULL;
}

static const struct expression *parse_chain(struct cursor *cursor, int level)
{
    const struct expression *left = parse_unary(cursor), *right;
    int found;

    while (left && (found = precedence(cursor)) >= level && found) {
        int code = cursor->token.code;
        struct expression *node = new_node(cursor, cursor->token.begin,
                                           BINARY);

        cursor_next(cursor);
        right = parse_binary(cursor, found + 1);
        left = right ? join(cursor, node, code, left, right) : NULL;
    }
    return left;
}

/* Operators of this level and above.  Every nesting passes here. */
static const struct expression *parse_binary(struct cursor *cursor, int level)
{
    const struct expression *result;

    if (cursor->depth >= MAX_EXPRESSION_DEPTH) {
        report(cursor->assembler, cursor->line, cursor->token.begin,
               "this expression is nested too deeply");
        return NULL;
    }
    cursor->depth++;
    result = parse_chain(cursor, level);
    cursor->depth--;
    return result;
}

const struct expression *parse_expression(struct cursor *cursor)
{
    return parse_binary(cursor, 1);
}

bool parse_value(struct cursor *cursor, struct value *value)
{
    const struct expression *expression = parse_expression(cursor);

    return expression
           && evaluate(cursor->assembler, cursor->line, expression, value);
}

bool parse_integer(struct cursor *cursor, int64_t low, int64_t high,
                   const char *what, int64_t *integer)
{
    const struct expression *expression = parse_expression(cursor);

    return expression
           && evaluate_range(cursor->assembler, cursor->line, expression, low,
                             high, what, integer);
}
