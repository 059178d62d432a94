/* reader.c - tokens in, reports out. */
#include "rt/scene/reader.h"

#include <stdarg.h>
#include <string.h>

enum { MESSAGE_LONGEST = 300, TOKEN_LONGEST = 40 };

static bool same_place(const struct token *a, const struct token *b)
{
    return a->source == b->source && a->offset == b->offset;
}

static void stop(struct reader *reader)
{
    reader->stopped = true;
    reader->token.kind = TOKEN_END;
}

static void add(struct reader *reader, bool error, const struct token *at,
                const char *format, va_list arguments)
{
    char message[MESSAGE_LONGEST];
    struct position position = token_position(at);

    if (reader->stopped)
        return;
    vsnprintf(message, sizeof message, format, arguments);
    reports_add(reader->reports, error, &position, message);
    if (reader->reports->count == REPORTS_MOST) {
        reports_add(reader->reports, true, &position,
                    "too many reports: the rest of the scene is not read");
        stop(reader);
    }
}

bool reader_fault(struct reader *reader, const struct token *at,
                  const char *format, ...)
{
    va_list arguments;

    if (same_place(&reader->fault, at))
        return false;
    reader->fault = *at;
    va_start(arguments, format);
    add(reader, true, at, format, arguments);
    va_end(arguments);
    return false;
}

void reader_report(struct reader *reader, const struct token *at,
                   const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    add(reader, reader->options && reader->options->strict, at, format,
        arguments);
    va_end(arguments);
}

bool reader_no_memory(struct reader *reader)
{
    reader_fault(reader, &reader->token, "there is not enough memory");
    stop(reader);
    return false;
}

static bool is_undeclared(const struct reader *reader)
{
    const struct token *token = &reader->token;

    return token->kind == TOKEN_WORD && token->length < TOKEN_LONGEST
        && !reader_value(reader) && token->text[0] >= 'A'
        && token->text[0] <= 'Z';
}

bool reader_expected(struct reader *reader, const char *what)
{
    const struct token *token = &reader->token;
    const struct value *value = reader_value(reader);
    const char *mark = token->kind == TOKEN_DIRECTIVE ? "#" : "";
    const char *more = token->length > TOKEN_LONGEST ? "..." : "";
    const char *note = is_undeclared(reader) ? ", which is not declared"
                                             : "";
    int length = more[0] ? TOKEN_LONGEST : (int)token->length;

    if (value && value->kind == VALUE_FAULTY)
        return false;
    if (token->kind == TOKEN_END)
        return reader_fault(reader, token,
                            "expected %s, found the end of the file", what);
    if (token->kind == TOKEN_STRING)
        return reader_fault(reader, token, "expected %s, found a string",
                            what);
    return reader_fault(reader, token, "expected %s, found '%s%.*s%s'%s", what,
                        mark, length, token->text, more, note);
}

/* Bad bytes are reported here and left out, so that none is passed over. */
void reader_next(struct reader *reader)
{
    size_t depth = reader->lexer.depth;

    if (reader->stopped)
        return;
    reader->closed = reader_at_sign(reader, '}');
    if (reader_at_sign(reader, '{'))
        reader->braces++;
    else if (reader->closed && reader->braces)
        reader->braces--;
    do {
        reader->token = lexer_next(&reader->lexer);
        if (reader->token.fault)
            reader_fault(reader, &reader->token, "%s", reader->token.fault);
    } while (reader->token.kind == TOKEN_BAD);
    if (reader->lexer.depth < depth)
        symbols_leave(&reader->symbols, reader->lexer.depth);
}

bool reader_at_sign(const struct reader *reader, int sign)
{
    return token_is_sign(&reader->token, sign);
}

bool reader_accept_sign(struct reader *reader, int sign)
{
    bool there = reader_at_sign(reader, sign);

    if (there)
        reader_next(reader);
    return there;
}

bool reader_expect_sign(struct reader *reader, int sign)
{
    const char what[] = { '\'', (char)sign, '\'', '\0' };

    return reader_accept_sign(reader, sign) || reader_expected(reader, what);
}

bool reader_accept(struct reader *reader, const char *word)
{
    bool there = is_token(&reader->token, word);

    if (there)
        reader_next(reader);
    return there;
}

void reader_comma(struct reader *reader)
{
    reader_accept_sign(reader, ',');
}

const struct value *reader_value(const struct reader *reader)
{
    const struct token *token = &reader->token;

    return token->kind == TOKEN_WORD
        ? symbols_find(&reader->symbols, token->text, token->length)
        : NULL;
}

const struct value *reader_value_of(const struct reader *reader,
                                    enum value_kind kind)
{
    const struct value *value = reader_value(reader);

    return value && value->kind == kind ? value : NULL;
}

bool reader_enter(struct reader *reader)
{
    if (reader->nesting == NESTING_MOST)
        return reader_fault(reader, &reader->token,
                            "more than %d things within each other",
                            NESTING_MOST);
    reader->nesting++;
    return true;
}

void reader_leave(struct reader *reader)
{
    reader->nesting--;
}
