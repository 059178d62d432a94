/* expression.c - reading floats and vectors.
 *
 *   full        relation { ("&" | "|") relation } [ "?" full ":" full ]
 *   relation    expression { ("=" "!=" "<" "<=" ">" ">=") expression }
 *   expression  product { ("+" | "-") product }
 *   product     factor { ("*" | "/") factor }
 *   factor      { "+" | "-" | "!" } primary { "." component }
 *   primary     number | name | "(" full ")" | "<" expression, ... ">"
 *               | function "(" full, ... ")"
 *
 * & and | are of one rank, left to right, as in POV-Ray.  A float meeting a
 * vector stands for as many equal components; of two vectors the shorter is
 * filled up with zeros.
 */
#include "rt/scene/expression.h"

#include "rt/scene/vector.h"

#include <string.h>

#define SAME 1e-10 /* comparisons take closer floats as equal */
#define LANGUAGE_VERSION 3.7

static bool read_full(struct reader *reader, struct numbers *value);

static const struct constant {
    const char *name;
    struct numbers value;
} constants[] = {
    { "clock", { 1, { 0 } } },
    { "false", { 1, { 0 } } },
    { "no", { 1, { 0 } } },
    { "off", { 1, { 0 } } },
    { "on", { 1, { 1 } } },
    { "pi", { 1, { PI } } },
    { "t", { 4, { 0, 0, 0, 1 } } },
    { "true", { 1, { 1 } } },
    { "u", { 2, { 1, 0 } } },
    { "v", { 2, { 0, 1 } } },
    { "version", { 1, { LANGUAGE_VERSION } } },
    { "x", { 3, { 1, 0, 0 } } },
    { "y", { 3, { 0, 1, 0 } } },
    { "yes", { 1, { 1 } } },
    { "z", { 3, { 0, 0, 1 } } },
};

static const struct constant *constant_find(const struct token *token)
{
    for (size_t i = 0; i < sizeof constants / sizeof *constants; i++)
        if (is_token(token, constants[i].name))
            return &constants[i];
    return NULL;
}

static bool is_picture_size(const struct token *token)
{
    return is_token(token, "image_width") || is_token(token, "image_height");
}

bool is_expression_word(const struct token *token)
{
    return constant_find(token) || function_find(token)
        || is_picture_size(token);
}

bool starts_expression(const struct reader *reader)
{
    const struct token *token = &reader->token;

    if (token->kind == TOKEN_SIGN)
        return token->sign && token->sign < SIGN_UNEQUAL
            && strchr("(<+-!", token->sign);
    return token->kind == TOKEN_NUMBER || is_expression_word(token)
        || reader_value_of(reader, VALUE_NUMBERS);
}

static bool found_vector(struct reader *reader, const struct token *at,
                         const char *expected, const struct numbers *value)
{
    return reader_fault(reader, at, "expected %s, found %d components",
                        expected, value->count);
}

/* Neither overflow nor the argument outside of a function's domain. */
static bool check_finite(struct reader *reader, const struct token *at,
                         const struct numbers *value)
{
    return numbers_are_finite(value)
        || reader_fault(reader, at, "the value is not a finite number");
}

static bool check_float(struct reader *reader, const struct token *at,
                        const struct numbers *value)
{
    return value->count == 1 || found_vector(reader, at, "a number", value);
}

/* "<" is read already. */
static bool read_components(struct reader *reader, struct numbers *value)
{
    *value = numbers_of(0);
    value->count = 0;
    do {
        if (value->count == COLOR_TERMS)
            return reader_expected(reader, "'>'");
        if (!read_number(reader, &value->n[value->count]))
            return false;
        value->count++;
        reader_comma(reader);
    } while (value->count < 2 || !reader_at_sign(reader, '>'));
    return reader_expect_sign(reader, '>');
}

static bool read_argument(struct reader *reader, char kind,
                          struct numbers *argument)
{
    struct token at = reader->token;

    if (!read_full(reader, argument))
        return false;
    if (kind != 'v')
        return check_float(reader, &at, argument);
    if (argument->count > 3)
        return found_vector(reader, &at, "a vector of 3", argument);
    numbers_widen(argument, 3);
    return true;
}

/* The arguments of a function as its `takes` says; how many, or 0. */
static size_t read_arguments(struct reader *reader, const char *takes,
                             struct numbers *arguments)
{
    size_t count = 0;

    if (!reader_expect_sign(reader, '('))
        return 0;
    do {
        bool more = *takes == '?' || *takes == '+';
        if (more && reader_at_sign(reader, ')'))
            break;
        if (count && !reader_expect_sign(reader, ','))
            return 0;
        if (count == ARGUMENTS_MOST)
            return reader_expected(reader, "no more arguments");
        if (!read_argument(reader, more ? 'f' : *takes, &arguments[count]))
            return 0;
        count++;
        takes += *takes != '+';
    } while (*takes);
    return reader_expect_sign(reader, ')') ? count : 0;
}

static bool read_call(struct reader *reader, const struct function *function,
                      struct numbers *value)
{
    struct numbers arguments[ARGUMENTS_MOST];
    struct token at = reader->token;
    size_t count;

    reader_next(reader);
    count = read_arguments(reader, function->takes, arguments);
    if (!count)
        return false;
    if (function->plain)
        *value = numbers_of(function->plain(arguments[0].n[0]));
    else
        function->apply(arguments, count, value);
    return check_finite(reader, &at, value);
}

static bool read_picture_size(struct reader *reader, struct numbers *value)
{
    bool width = is_token(&reader->token, "image_width");
    int pixels = 0;

    if (reader->options)
        pixels = width ? reader->options->width : reader->options->height;
    if (pixels <= 0)
        return reader_fault(reader, &reader->token,
                            "the size of the picture is not known here");
    *value = numbers_of(pixels);
    reader_next(reader);
    return true;
}

static bool read_name(struct reader *reader, struct numbers *value)
{
    const struct function *function = function_find(&reader->token);
    const struct constant *constant = constant_find(&reader->token);
    const struct value *declared = reader_value_of(reader, VALUE_NUMBERS);

    if (function)
        return read_call(reader, function, value);
    if (is_picture_size(&reader->token))
        return read_picture_size(reader, value);
    if (!constant && !declared)
        return reader_expected(reader, "a number or a vector");
    *value = constant ? constant->value : declared->is.numbers;
    reader_next(reader);
    return true;
}

static bool read_primary(struct reader *reader, struct numbers *value)
{
    if (reader->token.kind == TOKEN_NUMBER) {
        *value = numbers_of(reader->token.number);
        reader_next(reader);
        return true;
    }
    if (reader_accept_sign(reader, '<'))
        return read_components(reader, value);
    if (reader_accept_sign(reader, '('))
        return read_full(reader, value) && reader_expect_sign(reader, ')');
    return read_name(reader, value);
}

/* The luminance of a colour, POV-Ray's weights. */
static double gray(const double rgb[3])
{
    static const double weights[3] = { 0.297, 0.589, 0.114 };

    return dot3(weights, rgb);
}

/* "." is read already. */
static bool read_component(struct reader *reader, struct numbers *value)
{
    static const struct {
        const char *name;
        int index;
    } components[] = {
        { "x", 0 },   { "y", 1 },     { "z", 2 },    { "u", 0 },
        { "v", 1 },   { "t", 3 },     { "red", 0 },  { "green", 1 },
        { "blue", 2 }, { "filter", 3 }, { "transmit", 4 },
    };
    size_t i = 0, count = sizeof components / sizeof *components;

    while (i < count && !is_token(&reader->token, components[i].name))
        i++;
    if (i < count && components[i].index < value->count)
        *value = numbers_of(value->n[components[i].index]);
    else if (is_token(&reader->token, "gray") && value->count == COLOR_TERMS)
        *value = numbers_of(gray(value->n));
    else
        return reader_expected(reader, "a component that the value has");
    reader_next(reader);
    return true;
}

/* One minus, or not, before a factor; false: there is none. */
static bool accept_prefix(struct reader *reader, char *prefix)
{
    *prefix = reader->token.kind == TOKEN_SIGN
            && reader->token.sign < SIGN_UNEQUAL
        ? (char)reader->token.sign
        : '\0';
    if (!*prefix || !strchr("+-!", *prefix))
        return false;
    reader_next(reader);
    return true;
}

static void negate(struct numbers *value)
{
    for (int i = 0; i < value->count; i++)
        value->n[i] = -value->n[i];
}

static bool read_operand(struct reader *reader, struct numbers *value)
{
    bool done = read_primary(reader, value);

    while (done && reader_accept_sign(reader, '.'))
        done = read_component(reader, value);
    return done;
}

static bool read_factor(struct reader *reader, struct numbers *value)
{
    struct token at = reader->token;
    char prefix;
    bool done;

    if (!reader_enter(reader))
        return false;
    if (!accept_prefix(reader, &prefix)) {
        done = read_operand(reader, value);
    } else {
        done = read_factor(reader, value);
        if (done && prefix == '-')
            negate(value);
        if (done && prefix == '!' && check_float(reader, &at, value))
            *value = numbers_of(value->n[0] == 0);
    }
    reader_leave(reader);
    return done;
}

static double operate(int sign, double a, double b)
{
    switch (sign) {
    case '+': return a + b;
    case '-': return a - b;
    case '*': return a * b;
    case '/': return a / b;
    case '=': return fabs(a - b) < SAME;
    case SIGN_UNEQUAL: return fabs(a - b) >= SAME;
    case '<': return a < b - SAME;
    case '>': return a > b + SAME;
    case SIGN_NOT_ABOVE: return a < b + SAME;
    case SIGN_NOT_BELOW: return a > b - SAME;
    case '&': return a != 0 && b != 0;
    case '|': return a != 0 || b != 0;
    default: return 0;
    }
}

typedef bool operand_reader(struct reader *reader, struct numbers *value);

struct level {
    int signs[7];
    operand_reader *read;
    bool floats; /* the operators take no vectors */
};

static bool is_sign_of(const struct reader *reader, const struct level *level)
{
    for (size_t i = 0; level->signs[i]; i++)
        if (reader_at_sign(reader, level->signs[i]))
            return true;
    return false;
}

static bool apply(struct reader *reader, const struct token *at, bool floats,
                  struct numbers *left, struct numbers *right)
{
    if (floats
        && !(check_float(reader, at, left) && check_float(reader, at, right)))
        return false;
    numbers_widen(left, right->count);
    numbers_widen(right, left->count);
    for (int i = 0; i < left->count; i++) {
        if (at->sign == '/' && right->n[i] == 0)
            return reader_fault(reader, at, "division by 0");
        left->n[i] = operate(at->sign, left->n[i], right->n[i]);
    }
    return check_finite(reader, at, left);
}

/* Operators of one rank, from left to right. */
static bool read_level(struct reader *reader, const struct level *level,
                       struct numbers *value)
{
    if (!level->read(reader, value))
        return false;
    while (is_sign_of(reader, level)) {
        struct token at = reader->token;
        struct numbers right;
        reader_next(reader);
        if (!level->read(reader, &right)
            || !apply(reader, &at, level->floats, value, &right))
            return false;
    }
    return true;
}

static bool read_product(struct reader *reader, struct numbers *value)
{
    static const struct level level = { { '*', '/' }, read_factor, false };

    return read_level(reader, &level, value);
}

bool read_expression(struct reader *reader, struct numbers *value)
{
    static const struct level level = { { '+', '-' }, read_product, false };

    return read_level(reader, &level, value);
}

static bool read_relation(struct reader *reader, struct numbers *value)
{
    static const struct level level = {
        { '=', SIGN_UNEQUAL, '<', SIGN_NOT_ABOVE, '>', SIGN_NOT_BELOW },
        read_expression,
        true,
    };

    return read_level(reader, &level, value);
}

static bool read_logic(struct reader *reader, struct numbers *value)
{
    static const struct level level = { { '&', '|' }, read_relation, true };

    return read_level(reader, &level, value);
}

static bool read_full(struct reader *reader, struct numbers *value)
{
    struct token at = reader->token;
    struct numbers other;
    bool first, done;

    if (!read_logic(reader, value))
        return false;
    if (!reader_accept_sign(reader, '?'))
        return true;
    first = value->n[0] != 0;
    if (!check_float(reader, &at, value) || !reader_enter(reader))
        return false;
    done = read_full(reader, value) && reader_expect_sign(reader, ':')
        && read_full(reader, &other);
    reader_leave(reader);
    if (done && !first)
        *value = other;
    return done;
}

bool read_number(struct reader *reader, double *value)
{
    struct token at = reader->token;
    struct numbers numbers;

    if (!read_expression(reader, &numbers)
        || !check_float(reader, &at, &numbers))
        return false;
    *value = numbers.n[0];
    return true;
}

bool read_vector(struct reader *reader, double vector[3])
{
    struct token at = reader->token;
    struct numbers numbers;

    if (!read_expression(reader, &numbers))
        return false;
    if (numbers.count > 3)
        return found_vector(reader, &at, "a vector of 3", &numbers);
    numbers_widen(&numbers, 3);
    memcpy(vector, numbers.n, 3 * sizeof *vector);
    return true;
}
