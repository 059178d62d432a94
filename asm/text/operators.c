/* operators.c - the precedence of operators, and arithmetic on integers. */
#include "asm/text/operators.h"

#include <string.h>

/* The operators. An operator of two characters comes before an operator that is its
 * first character. */
static const struct operator_row {
    const char *text;
    int precedence;
} rows[] = { { "||", 1 }, { "&&", 2 }, { "==", 6 }, { "!=", 6 }, { "<=", 7 },
             { ">=", 7 }, { "<<", 8 }, { ">>", 8 }, { "|", 3 },  { "^", 4 },
             { "&", 5 },  { "<", 7 },  { ">", 7 },  { "+", 9 },  { "-", 9 },
             { "*", 10 }, { "/", 10 }, { "%", 10 } };

static int code_of(const char *text)
{
    return OPERATOR(text[0], text[1]);
}

int operator_at(const char *text, size_t *length)
{
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        *length = strlen(rows[i].text);
        if (strncmp(text, rows[i].text, *length) == 0)
            return code_of(rows[i].text);
    }
    return 0;
}

int operator_precedence(int code)
{
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (code_of(rows[i].text) == code)
            return rows[i].precedence;
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
        return "the quotient does not fit in 64 bits";
    *result = (uint64_t)(code == '/' ? a / b : a % b);
    return NULL;
}

static const char *shift(int code, int64_t a, int64_t b, uint64_t *result)
{
    if (b < 0 || b > 63)
        return "a shift count must be between 0 and 63";
    if (code == OPERATOR('<', '<'))
        *result = (uint64_t)a << b;
    else
        *result = shift_right(a, (uint64_t)b);
    return NULL;
}

const char *integer_operation(int code, int64_t a, int64_t b, uint64_t *result)
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

uint64_t integer_negation(int code, uint64_t a)
{
    return code == '-' ? 0 - a : code == '~' ? ~a : !a;
}
