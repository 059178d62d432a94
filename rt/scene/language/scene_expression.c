/* scene_expression.c - a recursive-descent parser of floats and vectors.
 *
 *   full        relation { ("&" | "|") relation } [ "?" full ":" full ]
 *   relation    expression { ("=" "!=" "<" "<=" ">" ">=") expression }
 *               | string ("=" "!=" "<" "<=" ">" ">=") string
 *   expression  product { ("+" | "-") product }
 *   product     factor { ("*" | "/") factor }
 *   factor      { "+" | "-" | "!" } primary { "." component }
 *   primary     number | name | "(" full ")" | "<" expression, ... ">"
 *               | function "(" full, ... ")"
 *
 * As in POV-Ray, & and | have the same precedence and associate to the left. In an
 * operation of a float and a vector, the float is expanded to a vector of equal
 * components. In an operation of two vectors, the shorter vector is filled with zeros.
 */
#include "rt/scene/language/scene_expression.h"

#include "rt/scene/language/condition.h"
#include "rt/scene/language/string_value.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Reads a prefix operator. Returns false if there is none. */
static bool accept_prefix(struct reader *reader, char *prefix)
{
    *prefix = reader->token.kind == TOKEN_SIGN && reader->token.sign < SIGN_UNEQUAL
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

static bool read_factor(struct reader *reader, struct numbers *value)
{
    struct scene_token at = reader->token;
    char prefix;
    bool done;
    if (!reader_enter(reader))
        return false;
    if (!accept_prefix(reader, &prefix)) {
        done = operand_read(reader, value);
    } else {
        done = read_factor(reader, value);
        if (done && prefix == '-')
            negate(value);
        if (done && prefix == '!' && operand_float(reader, &at, value))
            *value = numbers_of(!condition_holds(value->n[0]));
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
    case '=': return fabs(a - b) < EXPRESSION_SAME;
    case SIGN_UNEQUAL: return fabs(a - b) >= EXPRESSION_SAME;
    case '<': return a < b;
    case '>': return a > b;
    case SIGN_NOT_ABOVE: return a < b + EXPRESSION_SAME;
    case SIGN_NOT_BELOW: return a > b - EXPRESSION_SAME;
    case '&': return condition_holds(a) && condition_holds(b);
    case '|': return condition_holds(a) || condition_holds(b);
    default: return 0;
    }
}

/* The operators by precedence, from the lowest. */
enum rank { RANK_LOGIC, RANK_RELATION, RANK_SUM, RANK_PRODUCT, RANKS };
static const struct operators {
    int signs[7];
    bool floats; /* the operators do not accept vectors */
} operators[RANKS] = {
    { { '&', '|' }, true },
    { { '=', SIGN_UNEQUAL, '<', SIGN_NOT_ABOVE, '>', SIGN_NOT_BELOW }, true },
    { { '+', '-' }, false },
    { { '*', '/' }, false },
};

static bool at_operator(const struct reader *reader, enum rank rank)
{
    for (const int *sign = operators[rank].signs; *sign; sign++)
        if (reader_at_sign(reader, *sign))
            return true;
    return false;
}

static bool apply(struct reader *reader, const struct scene_token *at, bool floats,
                  struct numbers *left, struct numbers *right)
{
    if (floats
        && !(operand_float(reader, at, left) && operand_float(reader, at, right)))
        return false;
    numbers_widen(left, right->count);
    numbers_widen(right, left->count);
    for (int i = 0; i < left->count; i++) {
        if (at->sign == '/' && right->n[i] == 0)
            return reader_fault(reader, at, "division by 0");
        left->n[i] = operate(at->sign, left->n[i], right->n[i]);
    }
    return operand_finite(reader, at, left);
}

/* Compares two strings by byte order. The result of "a" = "b" is a float. */
static bool compare_strings(struct reader *reader, const char *left,
                            struct numbers *value)
{
    struct scene_token at = reader->token;
    char *right;
    reader_next(reader);
    if (!string_read_within(reader, &right))
        return false;
    *value = numbers_of(operate(at.sign, string_order(left, right), 0));
    free(right);
    return true;
}

static bool read_comparison(struct reader *reader, struct numbers *value)
{
    char *left;
    bool done;
    if (!string_read_within(reader, &left))
        return false;
    done = at_operator(reader, RANK_RELATION) ? compare_strings(reader, left, value)
                                              : reader_expected(reader, "a comparison");
    free(left);
    return done;
}

/* Reads left-associative operators of this rank and of all higher ranks. */
static bool read_rank(struct reader *reader, enum rank rank, struct numbers *value)
{
    if (rank == RANKS)
        return read_factor(reader, value);
    if (rank == RANK_RELATION && starts_string(reader))
        return read_comparison(reader, value);
    if (!read_rank(reader, rank + 1, value))
        return false;
    while (at_operator(reader, rank)) {
        struct scene_token at = reader->token;
        struct numbers right;
        reader_next(reader);
        if (!read_rank(reader, rank + 1, &right)
            || !apply(reader, &at, operators[rank].floats, value, &right))
            return false;
    }
    return true;
}

bool read_expression(struct reader *reader, struct numbers *value)
{
    return read_rank(reader, RANK_SUM, value);
}

bool read_full(struct reader *reader, struct numbers *value)
{
    struct scene_token at = reader->token;
    struct numbers other;
    bool first, done;
    if (!read_rank(reader, RANK_LOGIC, value))
        return false;
    if (!reader_accept_sign(reader, '?'))
        return true;
    first = condition_holds(value->n[0]);
    if (!operand_float(reader, &at, value) || !reader_enter(reader))
        return false;
    done = read_full(reader, value) && reader_expect_sign(reader, ':')
           && read_full(reader, &other);
    reader_leave(reader);
    if (done && !first)
        *value = other;
    return done;
}

typedef bool value_reader(struct reader *reader, struct numbers *value);

static bool read_float(struct reader *reader, value_reader *read, double *value)
{
    struct scene_token at = reader->token;
    struct numbers numbers;
    if (!read(reader, &numbers) || !operand_float(reader, &at, &numbers))
        return false;
    *value = numbers.n[0];
    return true;
}

bool read_full_number(struct reader *reader, double *value)
{
    return read_float(reader, read_full, value);
}

bool read_number(struct reader *reader, double *value)
{
    return read_float(reader, read_expression, value);
}

bool read_vector(struct reader *reader, double vector[3])
{
    struct scene_token at = reader->token;
    struct numbers numbers;
    if (!read_expression(reader, &numbers))
        return false;
    if (numbers.count > 3)
        return operand_found_vector(reader, &at, "a vector of 3", &numbers);
    numbers_widen(&numbers, 3);
    memcpy(vector, numbers.n, 3 * sizeof *vector);
    return true;
}

bool read_vectors(struct reader *reader, double (*vectors)[3], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (i > 0)
            reader_comma(reader);
        if (!read_vector(reader, vectors[i]))
            return false;
    }
    return true;
}
