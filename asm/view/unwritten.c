/* unwritten.c - finds registers that are read before they are written, from the letters
 * of the operands in insn.def. */
#include "asm/view/unwritten.h"

#include <ctype.h>
#include <string.h>

void register_set_add(struct register_set *set, unsigned number)
{
    set->bits[number / 64] |= UINT64_C(1) << number % 64;
}

static bool has(const struct register_set *set, unsigned number)
{
    return set->bits[number / 64] >> number % 64 & 1;
}

static unsigned register_of(const struct operand_view *operand)
{
    return operand->is_half ? operand->number / 2u : operand->number;
}

static bool is_written(const struct operand_view *operand)
{
    return operand->letter != '\0'
           && strchr("wpmk", tolower((unsigned char)operand->letter));
}

static bool is_read(const struct instruction_view *view,
                    const struct operand_view *operand)
{
    char letter = (char)tolower((unsigned char)operand->letter);
    return view_is_read(operand) && letter != 'k'
           && (letter != 'm' || view->insn->unit == C205_UNIT_BRANCH);
}

/* Adds a register. Returns true if it was not in the set. Register 0 is a constant. */
static bool add_new(struct register_set *set, unsigned number)
{
    bool is_new = number > 0 && !has(set, number);
    register_set_add(set, number);
    return is_new;
}

bool unwritten_find(struct register_set *written, const struct instruction_view *view,
                    struct unwritten *found)
{
    bool any = false;
    if (view->insn->format == C205_FORMAT_SWAP)
        return false;
    for (size_t i = 0; i < view->count; i++) {
        const struct operand_view *operand = &view->operands[i];
        if (is_read(view, operand) && add_new(written, register_of(operand)) && !any) {
            any = true;
            *found = (struct unwritten){ operand->number, operand->is_half,
                                         operand->is_vector };
        }
        if (operand->offset && add_new(written, operand->offset) && !any) {
            any = true;
            *found = (struct unwritten){ operand->offset, false, false };
        }
    }
    return any;
}

bool unwritten_is_copy(const c205_insn *insn)
{
    return strncmp(insn->mnemonic, "RTOR", 4) == 0;
}

void unwritten_print(const struct unwritten *found, const char *name,
                     const struct instruction_view *view, const struct sink *sink)
{
    char kind = found->is_half ? 'h' : 'r';
    const struct operand_view *last = &view->operands[view->count - 1];
    if (view->count > 1 && last->letter == 'z')
        last--;
    if (*name)
        sink_print(sink, "%s (%c%u)", name, kind, found->number);
    else
        sink_print(sink, "%c%u", kind, found->number);
    sink_put(sink, " is read before anything was written to it");
    if (found->is_vector)
        sink_put(sink, ", so it describes no vector");
    else if (view->insn->unit != C205_UNIT_BRANCH
             && (is_written(last) || last->is_vector))
        sink_print(sink, "; in this language the result of %s comes last",
                   view->insn->mnemonic);
}

void unwritten_add_results(struct register_set *written,
                           const struct instruction_view *view)
{
    for (size_t i = 0; i < view->count; i++) {
        const struct operand_view *operand = &view->operands[i];
        if (!is_written(operand))
            continue;
        register_set_add(written, register_of(operand));
        if (operand->letter == 'p' && operand->number + 1 < C205_REGISTERS)
            register_set_add(written, operand->number + 1u);
        if (operand->letter == 'P') /* two half registers */
            register_set_add(written, (operand->number + 1u) / 2);
    }
}

bool unwritten_is_straight(const c205_insn *insn)
{
    return insn->format == C205_FORMAT_REQUEST
           || (insn->unit != C205_UNIT_BRANCH && insn->format != C205_FORMAT_SWAP);
}
