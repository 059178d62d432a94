/* wish.c - expectations, as they stand in the comments of test programs. */
#include <ctype.h>
#include <string.h>

#include "asm/statement.h"
#include "base/spelling.h"

static const struct expression **add_value(struct cursor *cursor, struct wish *wish,
                                           size_t *capacity)
{
    const struct expression **values;

    values = arena_grow(cursor->assembler->arena, wish->values, wish->count, capacity,
                        sizeof *values);
    if (values)
        wish->values = values;
    return values;
}

static bool parse_values(struct cursor *cursor, struct wish *wish)
{
    size_t capacity = 0;

    do {
        const struct expression *value = parse_expression(cursor);

        if (!value || !add_value(cursor, wish, &capacity))
            return false;
        wish->values[wish->count++] = value;
    } while (cursor_take(cursor, ','));
    if (cursor_take(cursor, '~') && !(wish->tolerance = parse_expression(cursor)))
        return false;
    return expect_end(cursor);
}

static bool parse_place(struct cursor *cursor, struct wish *wish)
{
    return expect_operator(cursor, '[', "'['")
           && (wish->address = parse_expression(cursor)) != NULL
           && expect_operator(cursor, ']', "']'");
}

/* [label] = 1, 2, 3 */
static bool parse_memory(struct cursor *cursor, struct wish *wish)
{
    return parse_place(cursor, wish) && expect_operator(cursor, '=', "'='")
           && parse_values(cursor, wish);
}

/* r10 = 5, h10 = 5, or words of memory */
static bool parse_expect(struct cursor *cursor, struct wish *wish)
{
    struct register_name named;

    if (cursor_at(cursor, '[')) {
        wish->kind = EXPECT_WORDS;
        return parse_memory(cursor, wish);
    }
    if (!parse_any_register(cursor, &named) || !expect_operator(cursor, '=', "'='")
        || !parse_values(cursor, wish))
        return false;
    wish->kind = named.half ? EXPECT_HALF_REGISTER : EXPECT_REGISTER;
    wish->number = named.number;
    return wish->count == 1
           || report(cursor->assembler, cursor->line, cursor->line->begin,
                     "expected one value: a register holds one");
}

/* [label] = 1011 0010 */
static bool parse_bits(struct cursor *cursor, struct wish *wish)
{
    const char *at, *end = cursor->line->end;
    c205_word *bits;

    if (!parse_place(cursor, wish))
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
            return report(cursor->assembler, cursor->line, at,
                          "expected the digits 0 and 1");
        bits[wish->count / 64] |= (c205_word)(*at == '1') << (63 - wish->count % 64);
        wish->count++;
    }
    wish->bits = bits;
    return true;
}

static bool parse_one(struct cursor *cursor, struct wish *wish)
{
    wish->values = arena_take(cursor->assembler->arena, sizeof *wish->values);
    wish->count = 1;
    return wish->values && (wish->values[0] = parse_expression(cursor)) != NULL
           && expect_end(cursor);
}

static bool parse_rest(struct cursor *cursor, struct wish *wish)
{
    const char *begin = cursor->line->begin, *end = cursor->line->end;

    begin += begin < end && *begin == ' ';
    while (begin < end && isspace((unsigned char)end[-1]))
        end--;
    wish->text = arena_text(cursor->assembler->arena, begin, (size_t)(end - begin));
    return wish->text != NULL;
}

static bool parse_trap(struct cursor *cursor, struct wish *wish)
{
    unsigned trap;

    if (!parse_rest(cursor, wish))
        return false;
    for (trap = C205_TRAP_NONE + 1; trap < C205_TRAP_PAUSED; trap++)
        if (strcmp(c205_trap_name((c205_trap)trap), wish->text) == 0)
            return true;
    return report(cursor->assembler, cursor->line, cursor->token.begin,
                  "expected the name of a trap, found '%s'", wish->text);
}

static bool parse_warning(struct cursor *cursor, struct wish *wish)
{
    return parse_rest(cursor, wish)
           && (warning_named(wish->text) != WARNINGS
               || report(cursor->assembler, cursor->line, cursor->token.begin,
                         "expected the name of a warning, found '%s';"
                         " c205 asm -W list prints them",
                         wish->text));
}

/* A program names one at the most. */
static bool parse_model(struct cursor *cursor, struct wish *wish)
{
    const struct assembler *assembler = cursor->assembler;
    size_t i;

    for (i = 0; i < assembler->wish_count; i++)
        if (assembler->wishes[i].kind == EXPECT_MODEL)
            return report(cursor->assembler, cursor->line, cursor->token.begin,
                          "there is an expect-model already, in %s:%zu",
                          assembler->wishes[i].line->file,
                          assembler->wishes[i].line->number);
    if (cursor_at_end(cursor))
        return expected(cursor, "the name of a model");
    return parse_rest(cursor, wish);
}

static bool add_wish(struct assembler *assembler, struct wish wish)
{
    struct wish *wishes;

    wishes = arena_grow(assembler->arena, assembler->wishes, assembler->wish_count,
                        &assembler->wish_capacity, sizeof *wishes);
    if (!wishes)
        return false;
    assembler->wishes = wishes;
    wishes[assembler->wish_count++] = wish;
    return true;
}

static bool parse_named(struct cursor *cursor, const char *name, size_t length,
                        const char *rest)
{
    static const struct {
        const char *name;
        enum expectation_kind kind;
        bool (*parse)(struct cursor *, struct wish *);
    } wishes[] = { { "expect", EXPECT_REGISTER, parse_expect },
                   { "expect-halves", EXPECT_HALVES, parse_memory },
                   { "expect-bits", EXPECT_BITS, parse_bits },
                   { "expect-flags", EXPECT_FLAGS, parse_one },
                   { "expect-clocks", EXPECT_CLOCKS, parse_one },
                   { "expect-trap", EXPECT_TRAP, parse_trap },
                   { "expect-print", EXPECT_PRINT, parse_rest },
                   { "expect-model", EXPECT_MODEL, parse_model },
                   { "expect-warning", EXPECT_WARNING, parse_warning } };
    static const struct wish empty;
    struct line *line = arena_take(cursor->assembler->arena, sizeof *line);
    size_t i;

    if (!line)
        return false;
    *line = *cursor->line;
    line->begin = rest;
    for (i = 0; i < sizeof wishes / sizeof *wishes; i++) {
        struct cursor inside = cursor_start(cursor->assembler, line);
        struct wish wish = empty;

        if (strlen(wishes[i].name) != length
            || memcmp(wishes[i].name, name, length) != 0)
            continue;
        wish.line = line;
        wish.kind = wishes[i].kind;
        return wishes[i].parse(&inside, &wish) && add_wish(cursor->assembler, wish);
    }
    return report(cursor->assembler, cursor->line, name,
                  "expected expect: or expect-halves: -bits: -flags: -clocks:"
                  " -trap: -print: -model: -warning:");
}

/* ---- Misspelt ones ---- */

/* Its first word, up to a '-', is almost "expect", in any case. */
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

/* "r10 = .." or "[..] = .." */
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

/* As an expectation does: words of prose do not. */
static bool goes_on(const char *at, const char *end, bool dashed)
{
    at = skip_blanks(at, end);
    if (at < end && *at == ':')
        return dashed || is_equation(at + 1, end);
    return !dashed && is_equation(at, end);
}

bool parse_wish(struct cursor *cursor)
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
             "is this an expectation? '%.*s' makes it none; it would begin"
             " with '; expect%s'",
             (int)(length < 40 ? length : 40), name,
             memchr(name, '-', length) ? "-..:" : ":");
    return true;
}
