#include "asm/statement.h"

static bool parse_labels(struct cursor *cursor)
{
    struct cursor label = *cursor;
    const char *name, *at;
    size_t length;

    while (label.token.kind == TOKEN_NAME) {
        at = label.token.begin;
        expect_name(&label, "a label", &name, &length);
        if (!cursor_take(&label, ':'))
            break;
        *cursor = label;
        if (!layout_label(cursor, name, length, at))
            return false;
    }
    return true;
}

static bool parse_directive(struct cursor *cursor)
{
    const struct directive *directive = find_directive(&cursor->token);

    if (!directive)
        return expected(cursor, "a directive");
    if (!directive->is_data)
        layout_settle(cursor->assembler);
    cursor_next(cursor);
    return directive->parse(cursor) && expect_end(cursor);
}

static bool parse_mnemonic(struct cursor *cursor)
{
    const char *name = cursor->token.begin;
    size_t length = (size_t)(cursor->token.end - name);
    const c205_insn *insn = c205_insn_named(name, length);

    if (!insn)
        return expected(cursor, "an instruction or a macro");
    cursor_next(cursor);
    return parse_instruction(cursor, insn);
}

static bool parse_statement(struct cursor *cursor)
{
    if (!parse_labels(cursor))
        return false;
    if (cursor_at_end(cursor))
        return true;
    if (cursor->token.kind == TOKEN_DIRECTIVE)
        return parse_directive(cursor);
    if (cursor->token.kind == TOKEN_NAME)
        return parse_mnemonic(cursor);
    return expected(cursor, "an instruction");
}

bool parse_line(struct assembler *assembler, const struct line *line)
{
    struct cursor cursor = cursor_start(assembler, line);

    return parse_statement(&cursor) && parse_wish(&cursor);
}
