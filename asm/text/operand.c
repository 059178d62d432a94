/* operand.c - parses the operands of an instruction by its syntax. */
#include "asm/text/statement.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/text/suggest.h"

/* Returns true if a token resembles a register but has an invalid number, as in r256 or
 * r01. */
static bool is_numbered(const struct token *token)
{
    const char *at = token->begin;
    if (!strchr("rRhH", *at) || ++at == token->end)
        return false;
    while (at < token->end && isdigit((unsigned char)*at))
        at++;
    return at == token->end;
}

bool parse_any_register(struct cursor *cursor, struct register_name *found)
{
    const struct token *token = &cursor->token;
    const struct symbol *symbol;
    size_t length;
    if (token->kind != TOKEN_NAME)
        return expected_name(cursor, "a register", SUGGEST_REGISTER);
    length = (size_t)(token->end - token->begin);
    symbol = symbol_find(cursor->assembler, token->begin, length);
    if (symbol
        && (symbol->kind == SYMBOL_REGISTER || symbol->kind == SYMBOL_HALF_REGISTER)) {
        found->half = symbol->kind == SYMBOL_HALF_REGISTER;
        found->number = (uint8_t)symbol->value.bits;
        found->naming = symbol->naming;
    } else if (is_register_name(token->begin, length)) {
        found->half = tolower((unsigned char)*token->begin) == 'h';
        found->number = (uint8_t)strtoul(token->begin + 1, NULL, 10);
        found->naming = 0;
    } else {
        return expected_name(cursor,
                             is_numbered(token) ? "a register, r0 .. r255 or"
                                                  " h0 .. h255"
                                                : "a register",
                             SUGGEST_REGISTER);
    }
    cursor_next(cursor);
    return true;
}

/* Parses a register or a half register. */
static bool parse_sized(struct cursor *cursor, bool half, uint8_t *number)
{
    struct register_name found = { false, 0, 0 };
    const char *at = cursor->token.begin;
    if (!parse_any_register(cursor, &found))
        return false;
    *number = found.number;
    if (found.half == half)
        return mention_register(cursor->assembler, found);
    return report_at(cursor, at,
                     half ? "expected a half register, h0 .. h255, found the"
                            " whole register r%u"
                          : "expected a whole register, r0 .. r255, found the"
                            " half register h%u",
                     found.number);
}

bool parse_register(struct cursor *cursor, uint8_t *number)
{
    return parse_sized(cursor, false, number);
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
    fields->g |= C205_G_OFFSET;
    if (first < C205_REGISTERS - 1 && second != first + 1)
        return report_at(cursor, at,
                         "expected r%u: the offset of a result is in the"
                         " register after it",
                         first + 1u);
    return true;
}

static bool parse_bracket(struct cursor *cursor, const struct operand *operand,
                          c205_fields *fields)
{
    return expect_operator(cursor, '[', "'['")
           && parse_register(cursor, syntax_field(fields, operand->field))
           && (!cursor_at(cursor, ',') || parse_second(cursor, operand, fields))
           && expect_operator(cursor, ']', "']'");
}

/* Reports a vector at a scalar operand, and suggests the vector form of the
 * instruction: SUBNV for SUBN, ADDNV,H for ADDNH. */
static bool expected_scalar(struct cursor *cursor)
{
    static const char what[] = "a register without brackets";
    const struct instruction *writing = cursor->assembler->writing;
    const char *mnemonic = writing ? writing->insn->mnemonic : "";
    size_t length = strlen(mnemonic);
    bool half = length > 1 && mnemonic[length - 1] == 'H';
    char name[16];
    snprintf(name, sizeof name, "%.*sV", (int)(length - half), mnemonic);
    if (length == 0 || !c205_insn_named(name, strlen(name)))
        return expected(cursor, what);
    return report_at(cursor, cursor->token.begin,
                     "expected %s, found '['; did you mean %s%s, which operates on "
                     "vectors?",
                     what, name, half ? SYNTAX_HALF : "");
}

static bool parse_unsigned(struct cursor *cursor, const struct operand *operand,
                           c205_fields *fields)
{
    if (operand->kind == OPERAND_BRACKET
        || (operand->kind == OPERAND_SOURCE && cursor_at(cursor, '[')))
        return parse_bracket(cursor, operand, fields);
    if (operand->kind == OPERAND_REGISTER && cursor_at(cursor, '['))
        return expected_scalar(cursor);
    if (operand->kind == OPERAND_SOURCE && cursor->token.kind != TOKEN_NAME)
        return expected(cursor, "a vector [..] or a register");
    fields->g |= operand->broadcast;
    return parse_sized(cursor, operand->half, syntax_field(fields, operand->field));
}

/* Parses -[A], |[A]|, -|[A]| or |[B]|. */
static bool parse_signed(struct cursor *cursor, const struct operand *operand,
                         c205_fields *fields)
{
    bool magnitude;
    if (cursor_at(cursor, '-') && !operand->negate)
        return report_at(cursor, cursor->token.begin,
                         operand->magnitude ? "only the first source can be negated"
                                            : "this operand has no sign control");
    if (cursor_at(cursor, '|') && !operand->magnitude)
        return report_at(cursor, cursor->token.begin,
                         "this operand has no sign control");
    if (cursor_take(cursor, '-'))
        fields->g |= operand->negate;
    magnitude = cursor_take(cursor, '|');
    if (magnitude)
        fields->g |= operand->magnitude;
    return parse_unsigned(cursor, operand, fields)
           && (!magnitude || expect_operator(cursor, '|', "'|'"));
}

/* ---- Branch targets, control vectors, all operands ---- */

static bool parse_target(struct cursor *cursor, struct instruction *instruction)
{
    c205_fields *fields = &instruction->fields;
    if (!cursor_take(cursor, '[')) {
        fields->g |= C205_G_RELATIVE;
        instruction->relative = true;
        instruction->value = parse_expression(cursor);
        return instruction->value != NULL;
    }
    return parse_register(cursor, &fields->y)
           && (!cursor_take(cursor, ',') || parse_register(cursor, &fields->b))
           && expect_operator(cursor, ']', "']'");
}

static bool parse_control(struct cursor *cursor, const struct operand *operand,
                          c205_fields *fields)
{
    const char *at;
    if (!cursor_take(cursor, '?'))
        return expected(cursor, "a control vector ? [..] or ?! [..]");
    if (cursor_take(cursor, '!'))
        fields->g |= C205_G_ZEROS;
    at = cursor->token.begin;
    if (!parse_bracket(cursor, operand, fields))
        return false;
    return fields->z != 0 || report_at(cursor, at, "r0 cannot be a control vector");
}

static bool parse_operand(struct cursor *cursor, const struct operand *operand,
                          struct instruction *instruction)
{
    switch (operand->kind) {
    case OPERAND_IMMEDIATE:
        instruction->value = parse_expression(cursor);
        return instruction->value != NULL;
    case OPERAND_TARGET: return parse_target(cursor, instruction);
    case OPERAND_CONTROL: return parse_control(cursor, operand, &instruction->fields);
    default: return parse_signed(cursor, operand, &instruction->fields);
    }
}

static bool check_operands(struct cursor *cursor, struct instruction *instruction,
                           const struct operand *operands, size_t count,
                           const char *const *at)
{
    size_t blamed;
    const char *problem = syntax_refusal(instruction->insn, operands, count,
                                         &instruction->fields, &blamed);
    return !problem || report_at(cursor, at[blamed], "%s", problem);
}

/* Parses the separator before an operand other than the first. */
static bool parse_between(struct cursor *cursor, const struct operand *operand,
                          c205_fields *fields)
{
    if (operand->kind == OPERAND_CONTROL)
        return true;
    if (!operand->given || !cursor_take(cursor, '?'))
        return expect_operator(cursor, ',', operand->given ? "',' or '?'" : "','");
    fields->g |= operand->given;
    return true;
}

/* Parses all operands. After an error the parser continues at the next comma, so one
 * run reports the errors of all operands. The number of operands is checked only
 * without errors, because it is otherwise uncertain where each operand ends. */
static bool parse_operands(struct cursor *cursor, struct instruction *instruction)
{
    struct operand operands[MAX_OPERANDS];
    const char *at[MAX_OPERANDS] = { NULL };
    bool half = instruction->fields.g & C205_G_HALF;
    size_t i, count = syntax_operands(instruction->insn, half, operands);
    bool good = true;
    cursor->assembler->writing = instruction;
    for (i = 0; i < count; i++) {
        struct cursor start;
        if ((operands[i].may_be_left_out || !good) && cursor_at_end(cursor))
            break;
        if (i > 0 && !parse_between(cursor, &operands[i], &instruction->fields)) {
            good = false;
            cursor_skip(cursor, cursor);
            cursor_take(cursor, ',');
        }
        at[i] = cursor->token.begin;
        start = *cursor;
        if (cursor_at_end(cursor) && !good)
            break;
        if (!parse_operand(cursor, &operands[i], instruction)) {
            good = false;
            cursor_skip(cursor, &start);
        }
    }
    good = good && expect_end(cursor)
           && check_operands(cursor, instruction, operands, count, at);
    cursor->assembler->writing = NULL;
    return good;
}

/* Parses ",H" directly after a mnemonic. */
static bool parse_size(struct cursor *cursor, struct instruction *instruction)
{
    const char *at = cursor->token.begin;
    if (!cursor_at(cursor, ',') || !is_name_part(at[-1]))
        return true;
    cursor_next(cursor);
    if (!token_is(&cursor->token, "H"))
        return expected(cursor, "H, for 32-bit operands");
    if (!(instruction->insn->flags & C205_INSN_HALF))
        return report_at(cursor, at, "%s has no form with " SYNTAX_HALF,
                         instruction->insn->mnemonic);
    instruction->fields.g |= C205_G_HALF;
    cursor_next(cursor);
    return true;
}

bool parse_instruction(struct cursor *cursor, const c205_insn *insn)
{
    unsigned halves = c205_format_halves(insn->format);
    struct instruction *instruction;
    struct layout_item *item;
    bool good;
    instruction = arena_take(cursor->assembler->arena, sizeof *instruction);
    if (!instruction)
        return false;
    instruction->insn = insn;
    instruction->fields.f = insn->opcode;
    instruction->fields.g = insn->subop;
    instruction->mention = cursor->assembler->registers.mention_count;
    good = parse_size(cursor, instruction) && parse_operands(cursor, instruction);
    instruction->mentions = cursor->assembler->registers.mention_count
                            - instruction->mention;
    item = layout_add(cursor, ITEM_INSTRUCTION, halves); /* also after errors, for
                                                            correct addresses of later
                                                            items */
    if (item)
        item->of.instruction = instruction;
    return good && item;
}
