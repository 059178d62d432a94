/* parse.c - parses a statement: labels, followed by a directive or an instruction. */
#include "asm/text/statement.h"
#include "asm/text/suggest.h"

static bool parse_labels(struct cursor *cursor)
{
    struct cursor label = *cursor;
    const char *name, *at;
    size_t length;
    bool good = true;
    while (label.token.kind == TOKEN_NAME) {
        at = label.token.begin;
        expect_name(&label, "a label", &name, &length);
        if (!cursor_take(&label, ':'))
            break;
        *cursor = label;
        good = layout_label(cursor, name, length, at) && good;
    }
    return good;
}

static bool parse_directive(struct cursor *cursor)
{
    const struct directive *directive = find_directive(&cursor->token);
    if (!directive)
        return expected_name(cursor, "a directive", SUGGEST_DIRECTIVE);
    if (directive->contents == ASM_NOTHING)
        layout_resolve(cursor->assembler);
    cursor->assembler->contents = directive->contents;
    cursor_next(cursor);
    return directive->parse(cursor) && expect_end(cursor);
}

static bool parse_mnemonic(struct cursor *cursor)
{
    const char *name = cursor->token.begin;
    size_t length = (size_t)(cursor->token.end - name);
    const c205_insn *insn = c205_insn_named(name, length);
    if (!insn)
        return expected_name(cursor, "an instruction or a macro", SUGGEST_MNEMONIC);
    cursor_next(cursor);
    return parse_instruction(cursor, insn);
}

static bool parse_body(struct cursor *cursor)
{
    if (cursor->token.kind == TOKEN_DIRECTIVE)
        return parse_directive(cursor);
    if (cursor->token.kind == TOKEN_NAME)
        return parse_mnemonic(cursor);
    return expected(cursor, "an instruction");
}

/* Parses the labels of a statement and its directive or instruction, even after an
 * error in a label. */
static bool parse_statement(struct cursor *cursor)
{
    bool good = parse_labels(cursor);
    if (cursor_at_end(cursor))
        return good;
    good = parse_body(cursor) && good;
    while (!cursor_at_end(cursor))
        cursor_next(cursor);
    return good;
}

bool parse_line(struct assembler *assembler, const struct line *line)
{
    struct cursor cursor = cursor_start(assembler, line);
    bool good = parse_statement(&cursor);
    return parse_expectation(&cursor) && good;
}
