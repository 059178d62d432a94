/* operand.c - the operands of an instruction, as its syntax says. */
#include "asm/statement.h"

#include "asm/syntax.h"

bool parse_register(struct cursor *cursor, uint8_t *number)
{
    const struct token *token = &cursor->token;
    const struct symbol *symbol;
    size_t length;
    int known;

    if (token->kind != TOKEN_NAME)
        return expected(cursor, "a register");
    length = (size_t)(token->end - token->begin);
    known = register_number(token->begin, length);
    symbol = symbol_find(cursor->assembler, token->begin, length);
    if (known < 0 && symbol && symbol->kind == SYMBOL_REGISTER)
        known = (int)symbol->value.bits;
    if (known < 0)
        return expected(cursor, "a register");
    *number = (uint8_t)known;
    cursor_next(cursor);
    return true;
}

/* ---- Sources and results ---- */

static bool parse_second(struct cursor *cursor, const struct operand *operand,
                         c205_fields *fields)
{
    const char *at;
    uint8_t first = *syntax_field(fields, operand->field), second;

    if (!operand->second)
        return expected(cursor, "']': this operand has no offset");
    cursor_next(cursor);
    at = cursor->token.begin;
    if (!parse_register(cursor, &second))
        return false;
    if (operand->second != SECOND_IS_NEXT) {
        *syntax_field(fields, operand->second) = second;
        return true;
    }
    if (second != (uint8_t)(first + 1))
        return report(cursor->assembler, cursor->line, at,
                      "expected r%u: the offset of a result is in the"
                      " register after it", (first + 1u) % C205_REGISTERS);
    fields->g |= C205_G_OFFSET;
    return true;
}

static bool parse_bracket(struct cursor *cursor,
                          const struct operand *operand, c205_fields *fields)
{
    return expect_operator(cursor, '[', "'['")
           && parse_register(cursor, syntax_field(fields, operand->field))
           && (!cursor_at(cursor, ',')
               || parse_second(cursor, operand, fields))
           && expect_operator(cursor, ']', "']'");
}

static bool parse_unsigned(struct cursor *cursor,
                           const struct operand *operand,
                           c205_fields *fields)
{
    if (operand->kind == OPERAND_BRACKET
        || (operand->kind == OPERAND_SOURCE && cursor_at(cursor, '[')))
        return parse_bracket(cursor, operand, fields);
    if (operand->kind == OPERAND_REGISTER && cursor_at(cursor, '['))
        return expected(cursor, "a register without brackets");
    if (operand->kind == OPERAND_SOURCE && cursor->token.kind != TOKEN_NAME)
        return expected(cursor, "a vector [..] or a register");
    fields->g |= operand->broadcast;
    return parse_register(cursor, syntax_field(fields, operand->field));
}

/* -[A], |[A]|, -|[A]|, |[B]| */
static bool parse_signed(struct cursor *cursor, const struct operand *operand,
                         c205_fields *fields)
{
    bool magnitude;

    if (cursor_at(cursor, '-') && !operand->negate)
        return report(cursor->assembler, cursor->line, cursor->token.begin,
                      operand->magnitude
                          ? "only the first source can be negated"
                          : "this operand has no sign control");
    if (cursor_at(cursor, '|') && !operand->magnitude)
        return report(cursor->assembler, cursor->line, cursor->token.begin,
                      "this operand has no sign control");
    if (cursor_take(cursor, '-'))
        fields->g |= operand->negate;
    magnitude = cursor_take(cursor, '|');
    if (magnitude)
        fields->g |= operand->magnitude;
    return parse_unsigned(cursor, operand, fields)
           && (!magnitude || expect_operator(cursor, '|', "'|'"));
}

/* ---- The other kinds ---- */

static bool parse_target(struct cursor *cursor,
                         struct instruction *instruction)
{
    c205_fields *fields = &instruction->fields;

    if (!cursor_take(cursor, '[')) {
        fields->g |= C205_G_RELATIVE;
        instruction->relative = true;
        instruction->value = parse_expression(cursor);
        return instruction->value != NULL;
    }
    return parse_register(cursor, &fields->y)
           && (!cursor_take(cursor, ',')
               || parse_register(cursor, &fields->b))
           && expect_operator(cursor, ']', "']'");
}

static bool parse_control(struct cursor *cursor,
                          const struct operand *operand, c205_fields *fields)
{
    if (!cursor_take(cursor, '?'))
        return expected(cursor, "a control vector ? [..] or ?! [..]");
    if (cursor_take(cursor, '!'))
        fields->g |= C205_G_ZEROS;
    return parse_bracket(cursor, operand, fields);
}

static bool parse_operand(struct cursor *cursor,
                          const struct operand *operand,
                          struct instruction *instruction)
{
    switch (operand->kind) {
    case OPERAND_IMMEDIATE:
        instruction->value = parse_expression(cursor);
        return instruction->value != NULL;
    case OPERAND_TARGET:
        return parse_target(cursor, instruction);
    case OPERAND_CONTROL:
        return parse_control(cursor, operand, &instruction->fields);
    default:
        return parse_signed(cursor, operand, &instruction->fields);
    }
}

static bool parse_operands(struct cursor *cursor,
                           struct instruction *instruction)
{
    struct operand operands[MAX_OPERANDS];
    size_t i, count = syntax_operands(instruction->insn, operands);

    for (i = 0; i < count; i++) {
        if (operands[i].may_be_left_out && cursor_at_end(cursor))
            break;
        if (i > 0 && operands[i].kind != OPERAND_CONTROL
            && !expect_operator(cursor, ',', "','"))
            return false;
        if (!parse_operand(cursor, &operands[i], instruction))
            return false;
    }
    return expect_end(cursor);
}

bool parse_instruction(struct cursor *cursor, const c205_insn *insn)
{
    unsigned halves = c205_format_halves(insn->format);
    struct instruction *instruction;
    struct item *item;
    bool good;

    instruction = arena_take(cursor->assembler->arena, sizeof *instruction);
    if (!instruction)
        return false;
    instruction->insn = insn;
    instruction->fields.f = insn->opcode;
    instruction->fields.g = insn->subop;
    good = parse_operands(cursor, instruction);
    item = layout_add(cursor, ITEM_INSTRUCTION, halves); /* errors or not */
    if (item)
        item->of.instruction = instruction;
    return good && item;
}
