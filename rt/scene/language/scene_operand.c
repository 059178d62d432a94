/* scene_operand.c - parses constants, names, calls of functions and components. */
#include "rt/scene/language/scene_expression.h"

#include "rt/scene/language/formula.h"
#include "rt/scene/vector3.h"
#include "base/plural.h"

#include <string.h>

static const struct constant {
    const char *words;
    struct numbers value;
} constants[] = {
    { "clock clock_delta clock_on false final_clock final_frame frame_number "
      "initial_clock initial_frame no off",
      { 1, { 0 } } },
    { "on true yes", { 1, { 1 } } },
    { "pi", { 1, { PI } } },
    { "t", { 4, { 0, 0, 0, 1 } } },
    { "u", { 2, { 1, 0 } } },
    { "v", { 2, { 0, 1 } } },
    { "x", { 3, { 1, 0, 0 } } },
    { "y", { 3, { 0, 1, 0 } } },
    { "z", { 3, { 0, 0, 1 } } },
};

static bool is_picture_size(const struct scene_token *token)
{
    return is_token(token, "image_width") || is_token(token, "image_height");
}

bool is_expression_word(const struct scene_token *token)
{
    return TOKEN_ROW(token, constants) || function_find(token) || is_picture_size(token)
           || is_query_word(token) || is_token(token, "version");
}

bool starts_expression(const struct reader *reader)
{
    const struct scene_token *token = &reader->token;
    if (token->kind == TOKEN_SIGN)
        return token->sign && token->sign < SIGN_UNEQUAL
               && strchr("(<+-!", token->sign);
    return token->kind == TOKEN_NUMBER || reader_value_of(reader, VALUE_NUMBERS)
           || reader_value_of(reader, VALUE_FUNCTION)
           || reader_value_of(reader, VALUE_SPLINE) || is_expression_word(token);
}

bool operand_found_vector(struct reader *reader, const struct scene_token *at,
                          const char *expected, const struct numbers *value)
{
    return reader_fault(reader, at, "expected %s, found %d component%s", expected,
                        value->count, plural((uint64_t)value->count));
}

/* Reports an error for a value that is not finite, because of an overflow or an
 * argument outside of a function's domain. */
bool operand_finite(struct reader *reader, const struct scene_token *at,
                    const struct numbers *value)
{
    return numbers_are_finite(value)
           || reader_fault(reader, at, "the value is not a finite number");
}

bool operand_float(struct reader *reader, const struct scene_token *at,
                   const struct numbers *value)
{
    return value->count == 1 || operand_found_vector(reader, at, "a number", value);
}

/* Reads the components of a vector after "<". */
static bool read_components(struct reader *reader, struct numbers *value)
{
    size_t declared = reader->declared.brackets > 0;
    *value = numbers_of(0);
    value->count = 0;
    reader->declared.brackets += declared;
    do {
        if (value->count == COLOR_TERMS)
            return reader_expected(reader, "'>'");
        if (!read_number(reader, &value->n[value->count]))
            return false;
        value->count++;
        reader_comma(reader);
    } while (value->count < 2 || !reader_at_sign(reader, '>'));
    reader->declared.brackets -= declared;
    return reader_expect_sign(reader, '>');
}

static bool read_argument(struct reader *reader, char kind, struct numbers *argument)
{
    struct scene_token at = reader->token;
    if (!read_full(reader, argument))
        return false;
    if (kind != 'v')
        return operand_float(reader, &at, argument);
    if (argument->count > 3)
        return operand_found_vector(reader, &at, "a vector of 3", argument);
    numbers_widen(argument, 3);
    return true;
}

/* Reads the arguments, whose kinds `takes` lists as in struct function. Returns their
 * number, or 0 after an error. */
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
        if (count == MAX_ARGUMENTS)
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
    struct numbers arguments[MAX_ARGUMENTS];
    struct scene_token at = reader->token;
    size_t count;
    reader_next(reader);
    count = read_arguments(reader, function->takes, arguments);
    if (!count)
        return false;
    function_apply(function, arguments, count, value);
    return operand_finite(reader, &at, value);
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

static bool read_query(struct reader *reader, struct numbers *value)
{
    struct scene_token at = reader->token;
    *value = numbers_of(0);
    return query_read(reader, &value->n[0]) && operand_finite(reader, &at, value);
}

static bool take(struct reader *reader, struct numbers taken, struct numbers *value)
{
    *value = taken;
    reader_next(reader);
    return true;
}

/* Reads the value that a word names, or that its function returns. Declared names are
 * looked up first, because they are the most frequent. */
static bool read_name(struct reader *reader, struct numbers *value)
{
    const struct scene_token *token = &reader->token;
    const struct scene_value *declared = reader_value_of(reader, VALUE_NUMBERS);
    const struct scene_value *function = reader_use(reader, VALUE_FUNCTION);
    const struct constant *constant;
    if (declared)
        return take(reader, declared->is.numbers, value);
    if (function)
        return formula_call(reader, function->is.formula, value);
    if (reader_value_of(reader, VALUE_SPLINE))
        return spline_call(reader, value);
    constant = TOKEN_ROW(token, constants);
    if (constant)
        return take(reader, constant->value, value);
    if (function_find(token))
        return read_call(reader, function_find(token), value);
    if (is_query_word(token))
        return read_query(reader, value);
    if (is_picture_size(token))
        return read_picture_size(reader, value);
    if (is_token(token, "version"))
        return take(reader, numbers_of(reader->version), value);
    return reader_expected(reader, "a number or a vector");
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

/* Returns the grey value of a colour, or of a vector of 3, with POV-Ray's weights. */
static double gray(const double rgb[3])
{
    static const double weights[3] = { 0.297, 0.589, 0.114 };
    return dot3(weights, rgb);
}

/* Reads the component that follows "." and replaces the value by this component. */
static bool read_component(struct reader *reader, struct numbers *value)
{
    static const struct component {
        const char *words;
        int index;
    } components[] = {
        { "x u red", 0 },  { "y v green", 1 }, { "z blue", 2 },
        { "t filter", 3 }, { "transmit", 4 },
    };
    const struct component *found = TOKEN_ROW(&reader->token, components);
    if (found && found->index < value->count)
        *value = numbers_of(value->n[found->index]);
    else if (is_token(&reader->token, "gray") && value->count >= 3)
        *value = numbers_of(gray(value->n));
    else
        return reader_expected(reader, "a component of the value");
    reader_next(reader);
    return true;
}

bool operand_read(struct reader *reader, struct numbers *value)
{
    bool done = read_primary(reader, value);
    while (done && reader_accept_sign(reader, '.'))
        done = read_component(reader, value);
    return done;
}
