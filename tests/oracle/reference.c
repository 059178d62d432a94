/* reference.c - one instruction: fetched, taken apart, done or taken back. */
#include "reference_parts.h"

#include <stdlib.h>
#include <string.h>

/* ---- Faults ------------------------------------------------------------ */

void add_fault(struct reference *reference, c205_trap trap, uint64_t address,
               bool certain)
{
    struct fault *fault = reference->faults + trap;

    address = plain_address(address);
    if (!fault->possible || address < fault->low)
        fault->low = address;
    if (!fault->possible || address > fault->high)
        fault->high = address;
    fault->possible = true;
    fault->certain |= certain;
}

bool reference_has_fault(const struct reference *reference, c205_trap trap,
                         uint64_t address)
{
    const struct fault *fault = reference->faults + trap;

    return fault->possible && address >= fault->low && address <= fault->high;
}

static bool certain_fault(const struct reference *reference)
{
    for (int trap = 0; trap < C205_TRAPS; trap++)
        if (reference->faults[trap].certain)
            return true;
    return false;
}

/* ---- Registers --------------------------------------------------------- */

c205_word read_as_number(const struct reference *reference, unsigned number)
{
    return number == 0 ? C205_MACHINE_ZERO : reference->now.registers[number];
}

c205_word read_bits(const struct reference *reference, unsigned number)
{
    return number == 0 ? 0 : reference->now.registers[number];
}

void write_register(struct reference *reference, unsigned number,
                    c205_word word)
{
    if (number >= C205_REGISTERS)
        add_fault(reference, C205_TRAP_BAD_DESCRIPTOR, 0, true);
    else if (number != 0)
        reference->now.registers[number] = word;
}

/* ---- Memory ------------------------------------------------------------ */

static uint64_t word_of(uint64_t address)
{
    return plain_address(address) / BITS * BITS;
}

static void check_word(struct reference *reference, uint64_t address,
                       bool certain)
{
    if (plain_address(address) % BITS != 0)
        add_fault(reference, C205_TRAP_MISALIGNED_OPERAND, address, certain);
}

static void check_read(struct reference *reference, uint64_t address,
                       bool certain)
{
    if (!plain_is_mapped(&reference->memory, address))
        add_fault(reference, C205_TRAP_UNMAPPED_ADDRESS, address, certain);
}

static void check_write(struct reference *reference, uint64_t address,
                        bool certain)
{
    if (!plain_is_mapped(&reference->memory, address))
        add_fault(reference, C205_TRAP_UNMAPPED_ADDRESS, address, certain);
    else if (!plain_is_writable(&reference->memory, address))
        add_fault(reference, C205_TRAP_PROTECTED_ADDRESS, address, certain);
}

c205_word read_word(struct reference *reference, uint64_t address)
{
    check_word(reference, address, true);
    check_read(reference, address, true);
    return plain_read(&reference->memory, word_of(address));
}

void write_word(struct reference *reference, uint64_t address, c205_word word)
{
    check_word(reference, address, true);
    check_write(reference, address, true);
    plain_store(&reference->memory, word_of(address), word);
}

void pass_by_word(struct reference *reference, uint64_t address)
{
    check_word(reference, address, false);
    check_read(reference, address, false);
}

void pass_by_bit(struct reference *reference, uint64_t address)
{
    check_read(reference, address, false);
}

void leave_word(struct reference *reference, uint64_t address)
{
    check_word(reference, address, false);
    check_write(reference, address, false);
}

void leave_bit(struct reference *reference, uint64_t address)
{
    check_write(reference, address, false);
}

/* Bit 0 of a word is its leftmost. */
static uint64_t bit_in_word(uint64_t address)
{
    return UINT64_C(1) << (BITS - 1 - address % BITS);
}

bool read_bit(struct reference *reference, uint64_t address)
{
    check_read(reference, address, true);
    return plain_read(&reference->memory, word_of(address))
           & bit_in_word(address);
}

void write_bit(struct reference *reference, uint64_t address, bool bit)
{
    const uint64_t mask = bit_in_word(address);
    const c205_word word = plain_read(&reference->memory, word_of(address));

    check_write(reference, address, true);
    plain_store(&reference->memory, word_of(address),
                bit ? word | mask : word & ~mask);
}

void add_extent(struct reference *reference, uint64_t address, uint64_t bits)
{
    struct deed *deed = &reference->deed;

    if (bits > 0)
        deed->extents[deed->extent_count++] = (struct extent){
            plain_address(address), bits
        };
}

/* ---- Fetching ---------------------------------------------------------- */

static uint64_t read_half(struct reference *reference, uint64_t address)
{
    const c205_word word = plain_read(&reference->memory, word_of(address));

    check_read(reference, address, true);
    return address % BITS == 0 ? word >> HALF_BITS
                               : word & UINT64_C(0xFFFFFFFF);
}

/* The next instruction of the deed, at the program counter, which moves on.
 * False: there is none, or memory ends before it does. */
static bool fetch(struct reference *reference)
{
    struct deed *deed = &reference->deed;
    uint64_t *pc = &reference->now.pc;
    c205_word word = read_half(reference, *pc) << HALF_BITS;
    const c205_insn *insn;

    if (certain_fault(reference))
        return false;
    insn = c205_insn_coded((uint8_t)(word >> 56), (uint8_t)(word >> 48));
    if (insn == NULL) {
        add_fault(reference, C205_TRAP_UNDEFINED_INSTRUCTION, *pc, true);
        return false;
    }
    *pc = plain_address(*pc + HALF_BITS);
    if (c205_format_halves(insn->format) == 2) {
        word |= read_half(reference, *pc);
        *pc = plain_address(*pc + HALF_BITS);
    }
    deed->insns[deed->insn_count] = insn;
    deed->words[deed->insn_count] = word;
    deed->fields[deed->insn_count++] = c205_decode(insn, word);
    return !certain_fault(reference);
}

/* ---- The bits of G ----------------------------------------------------- */

/* From the operands of the row: which may be broadcast or signed, whether
 * there is a control vector, and a result that may have an offset. */
static unsigned vector_bits(const c205_insn *insn)
{
    const char *syntax = c205_format_syntax(insn->format);
    const bool signs = insn->flags & C205_INSN_SIGN;
    unsigned bits = insn->subop_mask;

    if (strchr(syntax, 'a'))
        bits |= C205_G_BROADCAST_A;
    if (strchr(syntax, 'b'))
        bits |= C205_G_BROADCAST_B;
    if (strstr(syntax, "?Z") || strstr(syntax, "!Z"))
        bits |= C205_G_ZEROS;
    if (strstr(syntax, "[C]") && insn->format != C205_FORMAT_SPREAD)
        bits |= C205_G_OFFSET;
    if (signs)
        bits |= C205_G_NEGATE_A | C205_G_MAGNITUDE_A;
    if (signs && strpbrk(syntax, "bB"))
        bits |= C205_G_MAGNITUDE_B;
    return bits;
}

unsigned reference_bits_of_g(const c205_insn *insn)
{
    return insn->unit == C205_UNIT_VECTOR
               ? vector_bits(insn)
               : insn->subop_mask | C205_G_RELATIVE;
}

/* Fields that a format lacks are zero; so is the offset of what is broadcast,
 * and the zeros of a control vector that there is not; r255 has no register
 * after it. */
static bool has_only(const c205_insn *insn, c205_word word,
                     const c205_fields *fields)
{
    const unsigned g = fields->g;

    if ((g & ~reference_bits_of_g(insn)) != 0
        || c205_encode(insn, fields) != word)
        return false;
    return insn->unit != C205_UNIT_VECTOR
           || !((g & C205_G_BROADCAST_A && fields->x != 0)
                || (g & C205_G_BROADCAST_B && fields->y != 0)
                || (g & C205_G_ZEROS && fields->z == 0)
                || (fields->c == C205_REGISTERS - 1
                    && (g & C205_G_OFFSET & reference_bits_of_g(insn)
                        || insn->flags & C205_INSN_INDEX)));
}

static bool lacks_control(const c205_insn *insn, const c205_fields *fields)
{
    return strstr(c205_format_syntax(insn->format), "!Z") && fields->z == 0;
}

/* The instruction i of the deed. */
static void check_code(struct reference *reference, size_t i)
{
    const struct deed *deed = &reference->deed;

    if (!has_only(deed->insns[i], deed->words[i], deed->fields + i))
        add_fault(reference, C205_TRAP_UNDEFINED_INSTRUCTION, deed->pc, true);
    if (lacks_control(deed->insns[i], deed->fields + i))
        add_fault(reference, C205_TRAP_BAD_DESCRIPTOR, 0, true);
}

/* ---- A step ------------------------------------------------------------ */

static void do_one(struct reference *reference, const c205_insn *insn,
                   const c205_fields *fields)
{
    if (insn->unit == C205_UNIT_VECTOR)
        do_vector(reference, insn, fields);
    else if (insn->unit == C205_UNIT_BRANCH)
        do_branch(reference, insn, fields);
    else
        do_scalar(reference, insn, fields);
}

static void do_pair(struct reference *reference)
{
    const struct deed *deed = &reference->deed;

    if (!fetch(reference) || !fetch(reference)) {
        add_fault(reference, C205_TRAP_BAD_LINK, deed->pc, true);
        return;
    }
    for (size_t i = 1; i <= PAIR; i++)
        check_code(reference, i);
    do_linked(reference);
}

static void do_fetched(struct reference *reference)
{
    const struct deed *deed = &reference->deed;

    check_code(reference, 0);
    if (certain_fault(reference))
        return;
    if (!reference_knows(deed->insns[0]))
        reference->lost = true;
    else if (reference_which(deed->insns[0]) == DO_LINKV)
        do_pair(reference);
    else
        do_one(reference, deed->insns[0], deed->fields);
}

static void begin_step(struct reference *reference)
{
    struct deed *deed = &reference->deed;

    memset(reference->faults, 0, sizeof reference->faults);
    reference->before = reference->now;
    plain_settle(&reference->memory);
    deed->pc = reference->now.pc;
    deed->insn_count = deed->extent_count = deed->indexed_count = 0;
    deed->elements = deed->swapped = deed->target = 0;
    deed->taken = false;
}

void reference_undo(struct reference *reference)
{
    reference->now = reference->before;
    reference->ended = false;
    plain_undo(&reference->memory);
}

bool reference_step(struct reference *reference)
{
    begin_step(reference);
    if (fetch(reference))
        do_fetched(reference);
    if (!certain_fault(reference))
        return true;
    reference_undo(reference);
    return false;
}

void reference_begin(struct reference *reference)
{
    memset(reference, 0, sizeof *reference);
    plain_begin(&reference->memory);
}

void reference_end(struct reference *reference)
{
    free(reference->deed.indexed);
    plain_end(&reference->memory);
}
