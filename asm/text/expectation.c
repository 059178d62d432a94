/* expectation.c - parses the expectations in the comments of test programs. */
#include <ctype.h>
#include <string.h>

#include "asm/text/statement.h"
#include "base/spelling.h"

static bool parse_values(struct cursor *cursor, struct expectation *expectation)
{
    size_t capacity = 0;
    do {
        const struct expression *value = parse_expression(cursor);
        if (!value
            || !arena_add(cursor->assembler->arena, &expectation->values,
                          &expectation->count, &capacity, &value, sizeof value))
            return false;
    } while (cursor_take(cursor, ','));
    if (cursor_take(cursor, '~')
        && !(expectation->tolerance = parse_expression(cursor)))
        return false;
    return expect_end(cursor);
}

static bool parse_place(struct cursor *cursor, struct expectation *expectation)
{
    return expect_operator(cursor, '[', "'['")
           && (expectation->address = parse_expression(cursor)) != NULL
           && expect_operator(cursor, ']', "']'");
}

/* Parses [label] = 1, 2, 3. */
static bool parse_memory(struct cursor *cursor, struct expectation *expectation)
{
    return parse_place(cursor, expectation) && expect_operator(cursor, '=', "'='")
           && parse_values(cursor, expectation);
}

/* Parses r10 = 5, h10 = 5, or words of memory. */
static bool parse_expect(struct cursor *cursor, struct expectation *expectation)
{
    struct register_name named;
    if (cursor_at(cursor, '[')) {
        expectation->kind = EXPECT_WORDS;
        return parse_memory(cursor, expectation);
    }
    if (!parse_any_register(cursor, &named) || !expect_operator(cursor, '=', "'='")
        || !parse_values(cursor, expectation))
        return false;
    expectation->kind = named.half ? EXPECT_HALF_REGISTER : EXPECT_REGISTER;
    expectation->number = named.number;
    return expectation->count == 1
           || report_at(cursor, cursor->line->begin,
                        "expected one value for a register");
}

/* Parses [label] = 1011 0010. */
static bool parse_bits(struct cursor *cursor, struct expectation *expectation)
{
    const char *at, *end = cursor->line->end;
    c205_word *bits;
    if (!parse_place(cursor, expectation))
        return false;
    if (!cursor_at(cursor, '='))
        return expected(cursor, "'='");
    at = cursor->token.end;
    bits = arena_take(cursor->assembler->arena,
                      ((size_t)(end - at) / 64 + 1) * sizeof *bits);
    if (!bits)
        return false;
    for (; at < end; at++) {
        if (isspace((unsigned char)*at))
            continue;
        if (*at != '0' && *at != '1')
            return report_at(cursor, at, "expected the digits 0 and 1");
        bits[expectation->count / 64] |= (c205_word)(*at == '1')
                                         << (63 - expectation->count % 64);
        expectation->count++;
    }
    expectation->bits = bits;
    return true;
}

static bool parse_one(struct cursor *cursor, struct expectation *expectation)
{
    expectation->values = arena_take(cursor->assembler->arena,
                                     sizeof *expectation->values);
    expectation->count = 1;
    return expectation->values
           && (expectation->values[0] = parse_expression(cursor)) != NULL
           && expect_end(cursor);
}

static bool parse_rest(struct cursor *cursor, struct expectation *expectation)
{
    const char *begin = cursor->line->begin, *end = cursor->line->end;
    begin += begin < end && *begin == ' ';
    while (begin < end && isspace((unsigned char)end[-1]))
        end--;
    expectation->text = arena_text(cursor->assembler->arena, begin,
                                   (size_t)(end - begin));
    return expectation->text != NULL;
}

static bool parse_trap(struct cursor *cursor, struct expectation *expectation)
{
    unsigned trap;
    if (!parse_rest(cursor, expectation))
        return false;
    for (trap = C205_TRAP_NONE + 1; trap < C205_TRAP_PAUSED; trap++)
        if (strcmp(c205_trap_name((c205_trap)trap), expectation->text) == 0)
            return true;
    return report_at(cursor, cursor->token.begin,
                     "expected the name of a trap, found '%s'", expectation->text);
}

static bool parse_warning(struct cursor *cursor, struct expectation *expectation)
{
    return parse_rest(cursor, expectation)
           && (warning_named(expectation->text) != WARNINGS
               || report_at(cursor, cursor->token.begin,
                            "expected the name of a warning, found '%s';"
                            " c205 asm -W list prints them",
                            expectation->text));
}

/* Parses a model. A program may name at most one. */
static bool parse_model(struct cursor *cursor, struct expectation *expectation)
{
    const struct assembler *assembler = cursor->assembler;
    for (size_t i = 0; i < assembler->expectation_count; i++)
        if (assembler->expectations[i].kind == EXPECT_MODEL)
            return report_at(cursor, cursor->token.begin,
                             "expect-model is already defined, in %s:%zu",
                             assembler->expectations[i].line->file,
                             assembler->expectations[i].line->number);
    if (cursor_at_end(cursor))
        return expected(cursor, "the name of a model");
    return parse_rest(cursor, expectation);
}

static bool parse_named(struct cursor *cursor, const char *name, size_t length,
                        const char *rest)
{
    static const struct {
        const char *name;
        enum expectation_kind kind;
        bool (*parse)(struct cursor *, struct expectation *);
    } expectations[] = { { "expect", EXPECT_REGISTER, parse_expect },
                         { "expect-halves", EXPECT_HALVES, parse_memory },
                         { "expect-bits", EXPECT_BITS, parse_bits },
                         { "expect-flags", EXPECT_FLAGS, parse_one },
                         { "expect-clocks", EXPECT_CLOCKS, parse_one },
                         { "expect-trap", EXPECT_TRAP, parse_trap },
                         { "expect-print", EXPECT_PRINT, parse_rest },
                         { "expect-model", EXPECT_MODEL, parse_model },
                         { "expect-warning", EXPECT_WARNING, parse_warning } };
    static const struct expectation empty;
    struct assembler *assembler = cursor->assembler;
    struct line *line = arena_take(assembler->arena, sizeof *line);
    if (!line)
        return false;
    *line = *cursor->line;
    line->begin = rest;
    for (size_t i = 0; i < sizeof expectations / sizeof *expectations; i++) {
        struct cursor inside = cursor_start(assembler, line);
        struct expectation expectation = empty;
        if (strlen(expectations[i].name) != length
            || memcmp(expectations[i].name, name, length) != 0)
            continue;
        expectation.line = line;
        expectation.kind = expectations[i].kind;
        return expectations[i].parse(&inside, &expectation)
               && arena_add(assembler->arena, &assembler->expectations,
                            &assembler->expectation_count,
                            &assembler->expectation_capacity, &expectation,
                            sizeof expectation);
    }
    return report_at(cursor, name,
                     "expected expect: or expect-halves: -bits: -flags: -clocks:"
                     " -trap: -print: -model: -warning:");
}

/* ---- Misspelled expectations  */

/* Returns true if the first word, up to a '-', resembles "expect". Case does not
 * matter. */
static bool resembles(const char *name, const char *end)
{
    enum { NEAR = 2 };
    const char *dash = memchr(name, '-', (size_t)(end - name));
    return spelling_distance(name, (size_t)((dash ? dash : end) - name), "expect", 6)
           <= NEAR;
}

static const char *skip_blanks(const char *at, const char *end)
{
    while (at < end && isspace((unsigned char)*at))
        at++;
    return at;
}

/* Returns true if the text has the form "r10 = .." or "[..] = ..". */
static bool is_equation(const char *at, const char *end)
{
    at = skip_blanks(at, end);
    if (at < end && *at == '[') {
        while (at < end && *at != ']')
            at++;
        at += at < end;
    } else {
        while (at < end && is_name_part(*at))
            at++;
    }
    at = skip_blanks(at, end);
    return at < end && *at == '=';
}

/* Returns true if the text after a word that resembles "expect" has the form of an
 * expectation. Prose does not have this form. */
static bool goes_on(const char *at, const char *end, bool dashed)
{
    at = skip_blanks(at, end);
    if (at < end && *at == ':')
        return dashed || is_equation(at + 1, end);
    return !dashed && is_equation(at, end);
}

bool parse_expectation(struct cursor *cursor)
{
    const char *at = cursor->token.begin, *end = cursor->line->end, *name;
    size_t length;
    while (at < end && (*at == ';' || *at == ' '))
        at++;
    name = at;
    while (at < end && (isalpha((unsigned char)*at) || *at == '-'))
        at++;
    length = (size_t)(at - name);
    if (at < end && *at == ':' && length >= 6 && memcmp(name, "expect", 6) == 0
        && (length == 6 || name[6] == '-'))
        return parse_named(cursor, name, length, at + 1);
    if (resembles(name, at) && goes_on(at, end, memchr(name, '-', length)))
        warn(cursor->assembler, WARNING_MISSPELT_EXPECT, cursor->line, name,
             "'%.*s' does not begin an expectation; did you mean '; expect%s'?",
             (int)(length < 40 ? length : 40), name,
             memchr(name, '-', length) ? "-..:" : ":");
    return true;
}
