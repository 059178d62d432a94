/* decode.c - decodes the word of an instruction to slots and sources, as the syntax and
 * the operand letters of its row in insn.def specify.
 */
#include "vm/machine.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static semantics *const functions[] = {
#define INSN(mnemonic, opcode, subop, mask, format, operands, unit, timing, flags, \
             function, operation, provenance, effect) \
    execute_##function,
#include "vm/insn.def"
};

/* ---- Fetch -------------------------------------------------------------- */

/* Returns a half word of code. The code of an interrupted instruction is read from its
 * saved copy, because memory may have changed. */
static c205_trap fetch_half(struct c205 *machine, uint64_t address, c205_word *half)
{
    uint64_t skip = address % WORD_BITS;
    c205_word word;
    if (resume_holds(&machine->resume, machine->pc, address, half))
        return C205_TRAP_NONE;
    c205_trap trap = address > ADDRESS_MASK
                         ? C205_TRAP_UNMAPPED_ADDRESS
                         : memory_load(&machine->memory, address - skip, &word);
    if (trap != C205_TRAP_NONE)
        return machine_fault(machine, trap, address & ADDRESS_MASK);
    memory_mark_code(&machine->memory, address);
    *half = word << skip >> HALF_BITS;
    return C205_TRAP_NONE;
}

/* Fetches the word of the instruction at pc, in the form that c205_decode expects. */
static c205_trap fetch(struct c205 *machine, uint64_t pc, const c205_insn **insn,
                       c205_word *word)
{
    c205_word high, low = 0;
    if (pc % INSTRUCTION_STEP)
        return machine_fault(machine, machine_refuse(machine, RULE_ALIGNED_CODE), pc);
    c205_trap trap = fetch_half(machine, pc, &high);
    if (trap != C205_TRAP_NONE)
        return trap;
    *insn = c205_insn_coded((uint8_t)(high >> 24), (uint8_t)(high >> 16));
    if (!*insn)
        return C205_TRAP_UNDEFINED_INSTRUCTION;
    if (c205_format_halves((*insn)->format) == 2)
        trap = fetch_half(machine, pc + HALF_BITS, &low);
    *word = high << HALF_BITS | low;
    return trap;
}

/* ---- Checks of the coding ----------------------------------------------- */

/* Returns true if a letter is one of a few constant letters. This test runs for every
 * instruction that is decoded, and the loop costs less than a function call. */
static inline bool is_one_of(char letter, const char *letters)
{
    for (; *letters; letters++)
        if (letter == *letters)
            return true;
    return false;
}

static bool has_letter(const char *syntax, const char *letters)
{
    for (; *syntax; syntax++)
        if (is_one_of(*syntax, letters))
            return true;
    return false;
}

/* Returns the letter of the operand in field C of a vector instruction. */
static char result_letter(const c205_insn *insn)
{
    const char *syntax = c205_format_syntax(insn->format);
    size_t commas = 0;
    if (!c205_unit_is_vector(insn->unit) || !has_letter(syntax, "C"))
        return '\0';
    for (const char *c = syntax; *c != 'C'; c++)
        commas += *c == ',';
    return insn->operands[commas];
}

/* Returns true if Z of this instruction is an input or a result, depending on its G
 * bit. */
static bool may_be_given(const c205_insn *insn)
{
    return has_letter(insn->operands, "g");
}

/* Returns true if the result may have an offset. The G bit for the offset has another
 * meaning if Z may be an input. */
static bool may_have_offset(const c205_insn *insn)
{
    char letter = result_letter(insn);
    return is_one_of(letter, "dDeqco") && !may_be_given(insn);
}

/* Returns the G bits that an instruction may have. */
static uint8_t possible_g(const c205_insn *insn, const c205_fields *fields)
{
    const char *syntax = c205_format_syntax(insn->format);
    unsigned g = insn->subop_mask;
    if (has_letter(syntax, "@"))
        return (uint8_t)(g | C205_G_RELATIVE);
    if (has_letter(syntax, "a") && !fields->x)
        g |= C205_G_BROADCAST_A;
    if (has_letter(syntax, "b") && !fields->y)
        g |= C205_G_BROADCAST_B;
    if (insn->flags & C205_INSN_SIGN)
        g |= C205_G_NEGATE_A | C205_G_MAGNITUDE_A;
    if (insn->flags & C205_INSN_SIGN && has_letter(syntax, "bB"))
        g |= C205_G_MAGNITUDE_B;
    if (has_letter(syntax, "?!") && fields->z)
        g |= C205_G_ZEROS;
    if (insn->flags & C205_INSN_HALF)
        g |= C205_G_HALF;
    if (may_have_offset(insn) && fields->c + 1 < C205_REGISTERS)
        g |= C205_G_OFFSET;
    if (may_be_given(insn))
        g |= C205_G_GIVEN;
    return (uint8_t)g;
}

static c205_trap check_coding(struct c205 *machine, const c205_insn *insn,
                              c205_word word, const c205_fields *fields)
{
    if (c205_encode(insn, fields) != word || fields->g & ~possible_g(insn, fields))
        return machine_refuse(machine, RULE_CODING);
    if (has_letter(c205_format_syntax(insn->format), "!") && !fields->z)
        return machine_refuse(machine, RULE_CONTROL);
    if (result_letter(insn) == 'p' && fields->c % 2)
        return machine_refuse(machine, RULE_EVEN);
    return C205_TRAP_NONE;
}

/* ---- Slots -------------------------------------------------------------- */

static void add_source(struct decoded *decoded, unsigned number)
{
    if (number > 0)
        decoded->source[decoded->source_count++] = (uint16_t)number;
}

static uint16_t add_result(struct decoded *decoded, unsigned number)
{
    uint16_t slot = number > 0 ? (uint16_t)number : SLOT_SINK;
    decoded->result[decoded->result_count] = slot;
    decoded->result_count = (uint8_t)(decoded->result_count + (number > 0));
    return slot;
}

/* Returns the slot of a register field with a given operand letter. */
static uint16_t slot_of(struct decoded *decoded, unsigned number, char letter,
                        bool broadcast)
{
    if (is_one_of(letter, "wkp"))
        return add_result(decoded, number);
    add_source(decoded, number);
    if (is_one_of(letter, "mco"))
        add_result(decoded, number);
    if (number == 0 && (letter == 'f' || (letter == 'v' && broadcast)))
        return SLOT_MACHINE_ZERO;
    return (uint16_t)number;
}

/* Returns the operand letter for this instruction: a capital letter if the operand has
 * 32 bits. The letter g becomes b if Z is an input, and o if Z is a result. */
static char sized(const struct decoded *decoded, char letter)
{
    bool half = decoded->insn->flags & C205_INSN_HALF
                && decoded->fields.g & C205_G_HALF;
    if (letter == 'g')
        return decoded->fields.g & C205_G_GIVEN ? 'b' : 'o';
    if (!half || !is_one_of(letter, "fwvudcxp"))
        return letter;
    return (char)toupper((unsigned char)letter);
}

static uint8_t operand_width(char letter)
{
    if (isupper((unsigned char)letter))
        return HALF_BITS;
    return is_one_of(letter, "beo") ? 1 : WORD_BITS;
}

/* Binds operand A, B or C, or R, S or T of the short formats, to a register. */
static uint16_t bind_operand(struct decoded *decoded, unsigned operand, unsigned number,
                             char letter, bool broadcast)
{
    letter = sized(decoded, letter);
    decoded->width[operand] = operand_width(letter);
    if (is_one_of(letter, "FIWMP") || (broadcast && is_one_of(letter, "VU"))) {
        bool right = number > 1 && number % 2;
        decoded->shift[operand] = right ? HALF_BITS : 0;
        number /= 2;
    }
    return slot_of(decoded, number, (char)tolower((unsigned char)letter), broadcast);
}

static void bind_a(struct decoded *decoded, uint8_t number, char letter, bool broadcast)
{
    decoded->a = bind_operand(decoded, OPERAND_A, number, letter, broadcast);
}

static void bind_b(struct decoded *decoded, uint8_t number, char letter, bool broadcast)
{
    decoded->b = bind_operand(decoded, OPERAND_B, number, letter, broadcast);
}

static void bind_c(struct decoded *decoded, uint8_t number, char letter)
{
    decoded->c = bind_operand(decoded, OPERAND_C, number, letter, false);
    if (sized(decoded, letter) == 'p')
        add_result(decoded, number ? number + 1u : 0);
}

static void bind(struct decoded *decoded, char field, char letter)
{
    const c205_fields *f = &decoded->fields;
    switch (field) {
    case 'R': bind_a(decoded, f->r, letter, false); break;
    case 'S': bind_b(decoded, f->s, letter, false); break;
    case 'T': bind_c(decoded, f->t, letter); break;
    case 'A': bind_a(decoded, f->a, letter, false); break;
    case 'B':
        if (letter == 'k')
            decoded->index = slot_of(decoded, f->b, letter, false);
        else
            bind_b(decoded, f->b, letter, false);
        break;
    case 'C': bind_c(decoded, f->c, letter); break;
    case 'X': decoded->x = slot_of(decoded, f->x, letter, false); break;
    case 'Y': decoded->y = slot_of(decoded, f->y, letter, false); break;
    case 'Z': decoded->z = slot_of(decoded, f->z, sized(decoded, letter), false); break;
    case 'a':
        bind_a(decoded, f->a, letter, f->g & C205_G_BROADCAST_A);
        decoded->x = slot_of(decoded, f->x, 'i', false);
        break;
    case 'b':
        bind_b(decoded, f->b, letter, f->g & C205_G_BROADCAST_B);
        decoded->y = slot_of(decoded, f->y, 'i', false);
        break;
    case '@':
        if (!(f->g & C205_G_RELATIVE)) {
            decoded->y = slot_of(decoded, f->y, 'i', false);
            decoded->b = slot_of(decoded, f->b, 'i', false);
        }
        break;
    default: /* an immediate */ break;
    }
}

/* Binds the operands of an instruction to registers: walks over the syntax of its
 * format and over its operand letters in parallel. An offset (+X) has no operand
 * letter. */
static void bind_all(struct decoded *decoded)
{
    const c205_insn *insn = decoded->insn;
    const char *letter = insn->operands;
    for (const char *c = c205_format_syntax(insn->format); *c; c++)
        if (*c == '+')
            bind(decoded, *++c, 'i');
        else if (!is_one_of(*c, "[],?! 0123456789"))
            bind(decoded, *c, *letter++);
    if (may_have_offset(insn) && decoded->fields.g & C205_G_OFFSET)
        add_source(decoded, decoded->fields.c + 1u);
}

/* Returns true for an instruction on words without offsets and without sign control,
 * which vm/direct.h can execute. */
static bool is_plain(const struct decoded *decoded)
{
    const c205_insn *insn = decoded->insn;
    unsigned g = C205_G_HALF | C205_G_OFFSET;
    if (insn->flags & C205_INSN_SIGN)
        g |= C205_G_NEGATE_A | C205_G_MAGNITUDE_A | C205_G_MAGNITUDE_B;
    for (unsigned i = 0; i < OPERANDS; i++)
        if (decoded->width[i] == HALF_BITS)
            return false;
    return !(decoded->fields.g & g) && !decoded->x && !decoded->y
           && insn->format != C205_FORMAT_SCALARS;
}

/* ---- The cache ---------------------------------------------------------- */

struct decode_cache *decode_cache_new(void)
{
    struct decode_cache *cache = malloc(sizeof *cache);
    for (size_t i = 0; cache && i < DECODE_ENTRIES; i++)
        cache->pc[i] = NOT_DECODED;
    return cache;
}

c205_trap decode(struct c205 *machine, uint64_t pc, struct decoded *decoded)
{
    c205_word word;
    memset(decoded, 0, sizeof *decoded);
    c205_trap trap = fetch(machine, pc, &decoded->insn, &word);
    if (trap != C205_TRAP_NONE)
        return trap;
    const c205_insn *insn = decoded->insn;
    decoded->fields = c205_decode(insn, word);
    trap = check_coding(machine, insn, word, &decoded->fields);
    if (trap != C205_TRAP_NONE)
        return trap;
    decoded->pc = pc;
    decoded->version = machine->memory.code_changes;
    decoded->execute = functions[insn - c205_insns];
    decoded->next = (pc + HALF_BITS * c205_format_halves(insn->format)) & ADDRESS_MASK;
    decoded->region = machine_region(machine, pc);
    decoded->flops = (uint8_t)c205_operation_flops(insn->operation);
    bind_all(decoded);
    decoded->plain = is_plain(decoded);
    return C205_TRAP_NONE;
}

c205_trap decode_at(struct c205 *machine, uint64_t pc, const struct decoded **decoded)
{
    const struct decoded *cached = decode_cached(machine->cache,
                                                 machine->memory.code_changes, pc);
    c205_trap trap = C205_TRAP_NONE;
    if (!cached) {
        size_t i = decode_place(pc);
        struct decoded *entry = &machine->cache->entry[i];
        trap = decode(machine, pc, entry);
        machine->cache->pc[i] = trap == C205_TRAP_NONE ? pc : NOT_DECODED;
        cached = entry;
    }
    *decoded = cached;
    return trap;
}

c205_trap decode_pair(struct c205 *machine, const struct decoded *prefix)
{
    struct decoded *entry = &machine->cache->entry[decode_place(prefix->pc)];
    uint64_t pc = (prefix->pc + INSTRUCTION_STEP) & ADDRESS_MASK;
    for (size_t i = 0; i < 2; i++) {
        c205_trap trap = decode_at(machine, pc, &entry->linked[i]);
        if (trap != C205_TRAP_NONE)
            return trap;
        if (!c205_unit_links(entry->linked[i]->insn->unit))
            return machine_refuse(machine, RULE_PAIR);
        pc = entry->linked[i]->next;
    }
    entry->flops = (uint8_t)(entry->linked[0]->flops + entry->linked[1]->flops);
    entry->next = pc;
    return C205_TRAP_NONE;
}
