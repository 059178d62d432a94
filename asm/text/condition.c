/* condition.c - the conditional directives: .if .ifdef .ifndef .elseif .else .endif. */
#include "asm/text/expand.h"
#include "asm/text/suggest.h"
#include "asm/text/expression.h"

bool condition_skips(const struct expander *expander)
{
    unsigned depth = expander->condition_depth;
    return depth > 0 && !expander->conditions[depth - 1].active;
}

/* Reports the conditions that lack an .endif at the end of a text. */
void condition_close(struct expander *expander, unsigned depth)
{
    while (expander->condition_depth > depth) {
        const struct line *line;
        line = expander->conditions[--expander->condition_depth].line;
        report(expander->assembler, line, line->begin, "this .if has no .endif");
    }
}

static bool holds(struct cursor *cursor)
{
    const struct expression *expression = parse_expression(cursor);
    int64_t integer = 0;
    return expression && expect_end(cursor)
           && evaluate_integer(cursor->assembler, cursor->line, expression, &integer)
           && integer != 0;
}

static bool is_defined(struct cursor *cursor)
{
    const char *name;
    size_t length;
    struct symbol *symbol;
    if (!expect_name(cursor, "a name", &name, &length) || !expect_end(cursor))
        return false;
    symbol = symbol_find(cursor->assembler, name, length);
    if (symbol)
        symbol->used = true;
    return symbol && (symbol->kind != SYMBOL_UNDEFINED || symbol->macro);
}

static bool is_not_defined(struct cursor *cursor)
{
    return !is_defined(cursor);
}

static void open(struct expander *expander, struct cursor *cursor,
                 bool (*test)(struct cursor *))
{
    bool outside = !condition_skips(expander);
    struct asm_condition *condition;
    if (expander->condition_depth == MAX_CONDITIONS) {
        report_at(cursor, cursor->line->begin, "more than %u nested conditions",
                  MAX_CONDITIONS);
        expander->halted = true;
        return;
    }
    condition = &expander->conditions[expander->condition_depth];
    condition->line = cursor->line;
    condition->outside = outside;
    condition->active = outside && test(cursor);
    condition->decided = condition->active;
    condition->last = false;
    expander->condition_depth++;
}

static struct asm_condition *innermost(struct expander *expander, struct cursor *cursor)
{
    const struct expansion *frame = &expander->frames[expander->depth - 1];
    if (expander->condition_depth > frame->conditions)
        return &expander->conditions[expander->condition_depth - 1];
    report_at(cursor, cursor->line->begin,
              "expected an .if before this line, in the same text");
    return NULL;
}

static void obey_else(struct expander *expander, struct cursor *cursor,
                      bool (*test)(struct cursor *))
{
    struct asm_condition *condition = innermost(expander, cursor);
    if (!condition)
        return;
    if (condition->last)
        report_at(cursor, cursor->line->begin, "expected .endif after .else");
    condition->last = !test;
    condition->active = condition->outside && !condition->decided
                        && (test ? test(cursor) : expect_end(cursor));
    condition->decided = condition->decided || condition->active;
}

static void close_one(struct expander *expander, struct cursor *cursor,
                      bool (*test)(struct cursor *))
{
    (void)test;
    if (innermost(expander, cursor) && expect_end(cursor))
        expander->condition_depth--;
}

static const struct {
    const char *name;
    void (*obey)(struct expander *, struct cursor *, bool (*)(struct cursor *));
    bool (*test)(struct cursor *);
} directives[] = { { ".if", open, holds },
                   { ".ifdef", open, is_defined },
                   { ".ifndef", open, is_not_defined },
                   { ".elseif", obey_else, holds },
                   { ".else", obey_else, NULL },
                   { ".endif", close_one, NULL } };
enum { DIRECTIVES = sizeof directives / sizeof *directives };

const char *condition_name(size_t i)
{
    return i < DIRECTIVES ? directives[i].name : NULL;
}

static size_t directive_index(const struct token *token)
{
    size_t i = token->kind == TOKEN_DIRECTIVE ? 0 : DIRECTIVES;
    while (i < DIRECTIVES && !token_is(token, directives[i].name))
        i++;
    return i;
}

bool condition_names(const struct token *token)
{
    return directive_index(token) < DIRECTIVES;
}

bool condition_directive(struct expander *expander, struct cursor *cursor)
{
    size_t found = directive_index(&cursor->token);
    if (found == DIRECTIVES)
        return false;
    cursor_next(cursor);
    directives[found].obey(expander, cursor, directives[found].test);
    return true;
}
