/* lex.c - the lexer, which reads tokens, and a cursor in a line. */
#include "asm/text/lex.h"
#include "asm/text/operators.h"

#include <ctype.h>
#include <string.h>

static bool is_digit(char c)
{
    return isdigit((unsigned char)c) != 0;
}

/* Returns 0 .. 15, or -1 if it is not a hex digit. */
static int hex_digit(char c)
{
    static const char digits[] = "0123456789abcdef";
    const char *found;
    found = c ? strchr(digits, tolower((unsigned char)c)) : NULL;
    return found ? (int)(found - digits) : -1;
}

static void bad(struct token *token, const char *end, const char *problem)
{
    token->kind = TOKEN_BAD;
    token->end = end;
    token->problem = problem;
}

static void lex_hex(struct token *token, const char *end)
{
    const char *at = token->begin + 2;
    uint64_t bits = 0;
    while (at < end && hex_digit(*at) >= 0) {
        if (bits >> 60) {
            bad(token, at, "the number does not fit in 64 bits");
            return;
        }
        bits = bits << 4 | (uint64_t)hex_digit(*at++);
    }
    token->value.bits = bits;
    token->end = at;
    if (at == token->begin + 2)
        bad(token, at, "expected hex digits after 0x");
}

static void lex_decimal(struct token *token)
{
    const char *at;
    uint64_t bits = 0;
    for (at = token->begin; at < token->end; at++) {
        if (bits > ((uint64_t)INT64_MAX - (uint64_t)(*at - '0')) / 10) {
            bad(token, token->end, "the number does not fit in 63 bits");
            return;
        }
        bits = 10 * bits + (uint64_t)(*at - '0');
    }
    token->value.bits = bits;
}

static const char *skip_digits(const char *at, const char *end)
{
    while (at < end && is_digit(*at))
        at++;
    return at;
}

static const char *skip_exponent(const char *at, const char *end)
{
    const char *digits = at + 1;
    if (at == end || (*at != 'e' && *at != 'E'))
        return at;
    if (digits < end && (*digits == '+' || *digits == '-'))
        digits++;
    return digits < end && is_digit(*digits) ? skip_digits(digits, end) : at;
}

static void lex_number(struct token *token, const char *end)
{
    const char *at = skip_digits(token->begin, end), *whole = at;
    const char *used;
    if (at < end && *at == '.')
        at = skip_digits(at + 1, end);
    at = skip_exponent(at, end);
    token->end = at;
    if (at == whole) {
        lex_decimal(token);
        return;
    }
    token->value.kind = VALUE_FLOATING;
    token->value.bits = c205_from_text(token->begin, &used);
    if (used != at)
        bad(token, at, "this is not a number");
}

static void lex_any_number(struct token *token, const char *end)
{
    const char *at = token->begin;
    token->kind = TOKEN_NUMBER;
    if (end - at > 1 && at[0] == '0' && (at[1] == 'x' || at[1] == 'X'))
        lex_hex(token, end);
    else
        lex_number(token, end);
    if (token->kind == TOKEN_NUMBER && token->end < end && is_name_part(*token->end))
        bad(token, token->end + 1,
            strchr("fFlLuU", *token->end)
                    && !(token->end + 1 < end && is_name_part(token->end[1]))
                ? "a number must not have a suffix: there is one floating-point "
                  "format, which is shortened for 32 bits"
                : "expected the end of the number, found a name");
}

/* Reads a word such as X'FFD2 4000 0000 0000'. */
static void lex_word(struct token *token, const char *end)
{
    const char *at = token->begin + 2;
    unsigned digits = 0;
    token->kind = TOKEN_NUMBER;
    token->value.kind = VALUE_WORD;
    for (; at < end && (hex_digit(*at) >= 0 || *at == ' '); at++)
        if (*at != ' ' && digits++ < 16)
            token->value.bits = token->value.bits << 4 | (uint64_t)hex_digit(*at);
    token->end = at + 1;
    if (at == end || *at != '\'')
        bad(token, at, "a word X'..' must have hex digits and end with '");
    else if (digits < 1 || digits > 16)
        bad(token, at, "a word X'..' must have 1 to 16 hex digits");
}

static void lex_string(struct token *token, const char *end)
{
    const char *at = token->begin + 1;
    token->kind = TOKEN_STRING;
    for (; at < end && *at != '"'; at++)
        if (*at == '\\' && end - at > 1)
            at++;
    if (at == end)
        bad(token, at, "expected a closing \" at the end of the string");
    else
        token->end = at + 1;
}

static void lex_operator(struct token *token)
{
    const char *at = token->begin;
    size_t length;
    int code = operator_at(at, &length);
    token->kind = TOKEN_OPERATOR;
    token->code = code ? code : *at;
    token->end = at + (code ? length : 1);
    if (*at == '\0' || !strchr("+-*/%~!<>=&^|()[],:?.", *at))
        bad(token, at + 1,
            *at == '#'
                ? "unexpected '#': numbers have no prefix, and comments begin with ';'"
                : "unexpected character");
}

static void lex_name(struct token *token, const char *end, enum token_kind kind)
{
    const char *at = token->begin + 1;
    while (at < end && is_name_part(*at))
        at++;
    token->kind = kind;
    token->end = at;
}

/* Reads the next token of a line. The position is the only state of the lexer, so a
 * copy of a cursor can look ahead. */
static struct token lex(const char *at, const char *end)
{
    static const struct token empty;
    struct token token = empty;
    char second;
    while (at < end && isspace((unsigned char)*at))
        at++;
    token.begin = token.end = at;
    if (at == end || *at == ';')
        return token;
    second = end - at > 1 ? at[1] : '\0';
    if ((*at == 'X' || *at == 'x') && second == '\'')
        lex_word(&token, end);
    else if (is_name_start(*at))
        lex_name(&token, end, TOKEN_NAME);
    else if (*at == '.' && is_name_start(second))
        lex_name(&token, end, TOKEN_DIRECTIVE);
    else if (is_digit(*at) || (*at == '.' && is_digit(second)))
        lex_any_number(&token, end);
    else if (*at == '"')
        lex_string(&token, end);
    else
        lex_operator(&token);
    return token;
}

struct cursor cursor_start(struct assembler *assembler, const struct line *line)
{
    struct cursor cursor;
    cursor.assembler = assembler;
    cursor.line = line;
    cursor.token = lex(line->begin, line->end);
    cursor.depth = 0;
    return cursor;
}

void cursor_next(struct cursor *cursor)
{
    cursor->token = lex(cursor->token.end, cursor->line->end);
}

bool cursor_at(const struct cursor *cursor, int code)
{
    return cursor->token.kind == TOKEN_OPERATOR && cursor->token.code == code;
}

bool cursor_take(struct cursor *cursor, int code)
{
    if (!cursor_at(cursor, code))
        return false;
    cursor_next(cursor);
    return true;
}

bool cursor_at_end(const struct cursor *cursor)
{
    return cursor->token.kind == TOKEN_END;
}

void cursor_skip(struct cursor *cursor, const struct cursor *start)
{
    int depth = 0;
    *cursor = *start;
    while (!cursor_at_end(cursor)) {
        if (depth == 0 && (cursor_at(cursor, ',') || cursor_at(cursor, '?')))
            return;
        depth += cursor_at(cursor, '[') || cursor_at(cursor, '(');
        depth -= cursor_at(cursor, ']') || cursor_at(cursor, ')');
        depth = depth < 0 ? 0 : depth;
        cursor_next(cursor);
    }
}

bool expected(struct cursor *cursor, const char *what)
{
    const struct token *token = &cursor->token;
    int length = (int)(token->end - token->begin);
    if (token->kind == TOKEN_BAD)
        return report_at(cursor, token->begin, "%s", token->problem);
    if (token->kind == TOKEN_END)
        return report_at(cursor, token->begin,
                         "expected %s, found the end of the statement", what);
    return report_at(cursor, token->begin, "expected %s, found '%.*s'", what,
                     length < 40 ? length : 40, token->begin);
}

bool expect_operator(struct cursor *cursor, int code, const char *what)
{
    return cursor_take(cursor, code) || expected(cursor, what);
}

bool expect_end(struct cursor *cursor)
{
    return cursor_at_end(cursor) || expected(cursor, "the end of the statement");
}

bool expect_name(struct cursor *cursor, const char *what, const char **name,
                 size_t *length)
{
    if (cursor->token.kind != TOKEN_NAME)
        return expected(cursor, what);
    *name = cursor->token.begin;
    *length = (size_t)(cursor->token.end - cursor->token.begin);
    cursor_next(cursor);
    return true;
}

/* Decodes \n \t \\ \" \0 and \xHH. *at is after the backslash. Returns -1 for any other
 * escape. */
static int unescape(const char **at)
{
    static const char letters[] = "nt\\\"0", meanings[] = "\n\t\\\"";
    const char *found = strchr(letters, **at);
    if (**at && found) {
        ++*at;
        return meanings[found - letters];
    }
    if (**at == 'x' && hex_digit((*at)[1]) >= 0 && hex_digit((*at)[2]) >= 0) {
        *at += 3;
        return hex_digit((*at)[-2]) << 4 | hex_digit((*at)[-1]);
    }
    return -1;
}

char *expect_string(struct cursor *cursor, size_t *length)
{
    const char *at = cursor->token.begin + 1;
    const char *end = cursor->token.end - 1;
    char *bytes;
    *length = 0;
    if (cursor->token.kind != TOKEN_STRING) {
        expected(cursor, "a string");
        return NULL;
    }
    bytes = arena_take(cursor->assembler->arena, (size_t)(end - at) + 1);
    while (bytes && at < end) {
        int byte = (unsigned char)*at++;
        if (byte == '\\' && (byte = unescape(&at)) < 0) {
            report_at(cursor, at - 1, "expected one of \\n \\t \\\\ \\\" \\0 \\xHH");
            return NULL;
        }
        bytes[(*length)++] = (char)byte;
    }
    cursor_next(cursor);
    return bytes;
}

bool token_is(const struct token *token, const char *text)
{
    size_t i, length = (size_t)(token->end - token->begin);
    for (i = 0; i < length; i++)
        if (!text[i]
            || tolower((unsigned char)token->begin[i])
                   != tolower((unsigned char)text[i]))
            return false;
    return text[length] == '\0';
}
