/* fallthrough.c - warns if a program can continue at an address without code. */
#include "asm/text/expression.h"

bool ends_program(struct assembler *assembler, const struct layout_item *item)
{
    const struct instruction *instruction = item->of.instruction;
    struct value value = { VALUE_INTEGER, 0 };
    if (instruction->insn->format != C205_FORMAT_REQUEST)
        return false;
    return !instruction->value
           || (evaluate(assembler, item->line, instruction->value, &value)
               && value.bits == 0);
}

/* Returns true if the instruction branches whatever the registers contain. */
static bool always_branches(const c205_insn *insn)
{
    return insn->format == C205_FORMAT_JUMP
           || (insn->format == C205_FORMAT_CALL && insn->operands[0] == 'w');
}

/* Returns true if an instruction follows directly. A .half counts, because it may be an
 * instruction. */
static bool goes_on_with(const struct layout_item *next, const struct layout_item *item)
{
    return next->address == layout_end(item)
           && (next->kind == ITEM_INSTRUCTION || next->kind == ITEM_HALF);
}

static bool expects_trap(const struct assembler *assembler)
{
    for (size_t i = 0; i < assembler->expectation_count; i++)
        if (assembler->expectations[i].kind == EXPECT_TRAP)
            return true;
    return false;
}

/* Warns of instructions after which the program can continue at an address without
 * code. The items must be sorted by address. A program that expects a trap is not
 * checked. */
void check_ends(struct assembler *assembler)
{
    const struct layout_item *items = assembler->items;
    size_t count = assembler->item_count;
    for (size_t i = 0; i < count && !expects_trap(assembler); i++)
        if (items[i].kind == ITEM_INSTRUCTION
            && !always_branches(items[i].of.instruction->insn)
            && !(i + 1 < count && goes_on_with(&items[i + 1], &items[i]))
            && !ends_program(assembler, &items[i]))
            warn(assembler, WARNING_RUN_OFF, items[i].line, items[i].line->begin,
                 "the program can continue after this line, where there is no code; "
                 "end it with EXIT or a branch");
}
