/* operand_view.c - decodes the operands of an instruction and reads their values. */
#include "asm/view/operand_view.h"

#include <ctype.h>
#include <string.h>

#include "asm/object/syntax.h"

enum { WORD_BITS = 64, HALF_BITS = 32 };

c205_word view_word_at(const c205 *machine, uint64_t address)
{
    c205_word pair[2] = { 0, 0 };
    uint64_t first = address / WORD_BITS * WORD_BITS;
    if (!c205_read(machine, first, pair, 2))
        c205_read(machine, first, pair, 1);
    return first == address ? pair[0] : pair[0] << HALF_BITS | pair[1] >> HALF_BITS;
}

c205_word view_register(const c205 *machine, unsigned number, bool half)
{
    return half ? c205_register(machine, number / 2) << number % 2 * HALF_BITS
                      & ~(c205_word)UINT32_MAX
                : c205_register(machine, number);
}

/* ---- Decode ---- */

static uint8_t field_of(const c205_fields *fields, char field)
{
    return *syntax_field((c205_fields *)(uintptr_t)fields, field);
}

static bool is_broadcast(const c205_fields *fields, char field)
{
    return fields->g & (field == 'A' ? C205_G_BROADCAST_A : C205_G_BROADCAST_B);
}

/* Returns the width of an element in bits: 1, 32 for a capital letter, or 64. */
static unsigned element_width(char letter)
{
    if (strchr("beoz", letter))
        return 1;
    return isupper((unsigned char)letter) ? HALF_BITS : WORD_BITS;
}

/* Sets the register that contains the offset of a vector operand. In the syntax, a
 * lower-case letter is a field whose offset is in X or Y, and "A+X" has its offset in
 * X. With C205_G_OFFSET the result and the control vector have an offset in register
 * C+1, except in instructions with an operand "g", where the bit means C205_G_GIVEN. */
static void add_offset(struct operand_view *operand,
                       const struct instruction_view *view, const char *syntax)
{
    const c205_fields *fields = &view->fields;
    bool after = strchr("cdeqoz", tolower((unsigned char)operand->letter))
                 && fields->g & C205_G_OFFSET && !strchr(view->insn->operands, 'g');
    if (syntax[1] == '+')
        operand->offset = field_of(fields, syntax[2]);
    else if (islower((unsigned char)*syntax))
        operand->offset = operand->field == 'A' ? fields->x : fields->y;
    if (after)
        operand->offset = (uint8_t)(fields->c + 1);
}

static void decode_one(struct operand_view *operand,
                       const struct instruction_view *view, const char *syntax,
                       char letter)
{
    bool half = view->insn->flags & C205_INSN_HALF && view->fields.g & C205_G_HALF
                && strchr("fwpvudcx", letter);
    memset(operand, 0, sizeof *operand);
    if (letter == 'g')
        letter = view->fields.g & C205_G_GIVEN ? 'b' : 'o';
    operand->letter = half ? (char)toupper((unsigned char)letter) : letter;
    if (strchr("nt", letter))
        return;
    operand->field = (char)toupper((unsigned char)*syntax);
    operand->number = field_of(&view->fields, operand->field);
    letter = (char)tolower((unsigned char)letter);
    operand->is_vector = strchr("lbdeqcoxz", letter)
                         || (strchr("vu", letter)
                             && !(islower((unsigned char)*syntax)
                                  && is_broadcast(&view->fields, operand->field)));
    operand->width = element_width(operand->letter);
    operand->is_half = !operand->is_vector && operand->width == HALF_BITS;
    if (operand->is_vector)
        add_offset(operand, view, syntax);
}

/* Decodes the operands. Letters of the syntax name fields of the instruction. insn.def
 * has a letter for the operand in each field, except for an offset "+X". */
static void decode_operands(struct instruction_view *view)
{
    const char *syntax = c205_format_syntax(view->insn->format);
    const char *letter = view->insn->operands;
    for (; *syntax && *letter && view->count < VIEW_OPERANDS; syntax++)
        if (*syntax == '+')
            syntax++;
        else if (isalpha((unsigned char)*syntax) || *syntax == '@')
            decode_one(&view->operands[view->count++], view, syntax, *letter++);
}

void view_take(struct instruction_view *view, uint64_t pc, const c205_insn *insn,
               c205_fields fields)
{
    memset(view, 0, sizeof *view);
    view->pc = pc;
    view->insn = insn;
    view->halves = c205_format_halves(insn->format);
    view->fields = fields;
    decode_operands(view);
}

void view_decode(struct instruction_view *view, const c205 *machine, uint64_t pc)
{
    c205_word word = view_word_at(machine, pc);
    const c205_insn *insn = c205_insn_coded((uint8_t)(word >> 56),
                                            (uint8_t)(word >> 48));
    memset(view, 0, sizeof *view);
    view->pc = pc;
    view->halves = 1;
    if (insn)
        view_take(view, pc, insn, c205_decode(insn, word));
}

/* ---- Fill ---- */

static void describe(struct operand_view *operand, const c205 *machine)
{
    int64_t skip = 0;
    operand->address = c205_descriptor_address(operand->word);
    operand->length = c205_descriptor_length(operand->word);
    if (operand->offset)
        skip = c205_to_integer(c205_register(machine, operand->offset));
    operand->is_bad = skip < 0;
    if (skip <= 0)
        return;
    operand->address = c205_descriptor_address(operand->address
                                               + (uint64_t)skip * operand->width);
    operand->length -= (uint64_t)skip < operand->length ? (size_t)skip
                                                        : operand->length;
}

/* Returns true if the operand is register 0, h0 or h1 and is read as a number. */
static bool reads_zero(const struct operand_view *operand)
{
    return strchr("fFvV", operand->letter) && !operand->is_vector
           && operand->number / (operand->is_half ? 2 : 1) == 0;
}

void view_fill(struct instruction_view *view, const c205 *machine)
{
    for (size_t i = 0; i < view->count; i++) {
        struct operand_view *operand = &view->operands[i];
        if (!operand->field)
            continue;
        operand->word = view_register(machine, operand->number, operand->is_half);
        if (reads_zero(operand))
            operand->word = C205_MACHINE_ZERO;
        if (operand->is_vector)
            describe(operand, machine);
    }
}

size_t view_at(struct instruction_view views[VIEW_LINKED], const c205 *machine,
               uint64_t pc)
{
    size_t count = 1;
    view_decode(&views[0], machine, pc);
    if (views[0].insn && views[0].insn->timing == C205_TIMING_vlink) {
        count = VIEW_LINKED;
        pc += HALF_BITS * (uint64_t)views[0].halves;
        view_decode(&views[0], machine, pc);
        pc += HALF_BITS * (uint64_t)views[0].halves;
        view_decode(&views[1], machine, pc);
    }
    for (size_t i = 0; i < count; i++)
        if (views[i].insn)
            view_fill(&views[i], machine);
    return count;
}

const struct operand_view *view_find(const struct instruction_view *view,
                                     const char *letters)
{
    for (size_t i = 0; i < view->count; i++)
        if (strchr(letters, view->operands[i].letter))
            return &view->operands[i];
    return NULL;
}

bool view_is_present(const struct operand_view *operand)
{
    return operand->field && !(operand->letter == 'z' && operand->number == 0);
}

bool view_is_read(const struct operand_view *operand)
{
    return view_is_present(operand) && !strchr("wWpP", operand->letter);
}

/* ---- Elements ---- */

static c205_word pick(c205_word word, uint64_t bit, unsigned width)
{
    return width == HALF_BITS ? word << bit & ~(c205_word)UINT32_MAX
                              : word >> (WORD_BITS - 1 - bit) & 1;
}

bool view_read(const c205 *machine, uint64_t address, unsigned width, size_t first,
               size_t n, c205_word *words)
{
    uint64_t at = c205_descriptor_address(address + (uint64_t)first * width);
    if (width == WORD_BITS)
        return c205_read(machine, at, words, n);
    for (size_t i = 0; i < n; i++, at += width) {
        if (!c205_read(machine, at / WORD_BITS * WORD_BITS, &words[i], 1))
            return false;
        words[i] = pick(words[i], at % WORD_BITS, width);
    }
    return true;
}
