/* first_reads.c - warns of registers that are read before they are written. */
#include <string.h>

#include "asm/text/assembler.h"
#include "asm/text/shown_line.h"
#include "asm/view/unwritten.h"

/* Returns the name by which an instruction mentions a register, or "". */
static const char *name_of(const struct assembler *assembler,
                           const struct instruction *instruction,
                           const struct unwritten *found)
{
    const struct registers *registers = &assembler->registers;
    for (size_t i = 0; i < instruction->mentions; i++) {
        const struct naming *naming =
            &registers->namings[registers->mentions[instruction->mention + i]];
        if (naming->named.number == found->number
            && naming->named.half == found->is_half)
            return naming->symbol->name;
    }
    return "";
}

/* Returns true if a line is in a macro of another file than the line of its call. */
static bool is_of_other_file(const struct line *line)
{
    return strcmp(line->file, shown_line(line)->file) != 0;
}

static void check_item(struct assembler *assembler, const struct layout_item *item,
                       struct register_set *written)
{
    const struct instruction *instruction = item->of.instruction;
    struct instruction_view view;
    struct unwritten found;
    view_take(&view, item->address, instruction->insn, instruction->fields);
    if (unwritten_find(written, &view, &found)
        && !(unwritten_is_copy(view.insn) && is_of_other_file(item->line))) {
        struct text_line message = { "", 0 };
        struct sink sink = text_line_sink(&message);
        unwritten_print(&found, name_of(assembler, instruction, &found), &view, &sink);
        warn(assembler, WARNING_UNWRITTEN_REGISTER, item->line, item->line->begin, "%s",
             message.text);
    }
    unwritten_add_results(written, &view);
}

void check_first_reads(struct assembler *assembler, uint64_t entry)
{
    const struct layout_item *item = assembler->items;
    const struct layout_item *end = item + assembler->item_count;
    struct register_set written = { { 0 } };
    uint64_t next = entry;
    while (item < end && item->address < entry)
        item++;
    for (; item < end && item->address == next && item->kind == ITEM_INSTRUCTION;
         item++) {
        check_item(assembler, item, &written);
        if (!unwritten_is_straight(item->of.instruction->insn)
            || ends_program(assembler, item))
            break;
        next = layout_end(item);
    }
}
