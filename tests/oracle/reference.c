/* reference.c - fetches, decodes, executes and undoes an instruction (reference.h). */
#include "reference_parts.h"

#include <ctype.h>
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

/* ---- Operands by their letters ----------------------------------------- */

/* Applies G to a letter. With 32-bit operands some letters become capitals. An order
 * vector is a source if it is given, otherwise a result. */
static char by_g(const c205_insn *insn, unsigned g, char letter)
{
    bool half = insn->flags & C205_INSN_HALF && g & C205_G_HALF;
    if (letter == 'g')
        return g & C205_G_GIVEN ? 'b' : 'o';
    return half && letter && strchr("fwpvudcx", letter) ? (char)toupper(letter)
                                                        : letter;
}

/* An offset follows a + in the syntax, and has no letter. */
char reference_table_letter(const c205_insn *insn, char field)
{
    const char *syntax = c205_format_syntax(insn->format);
    const char *letter = insn->operands;
    for (const char *p = syntax; *p && *letter; p++) {
        if ((!isalpha(*p) && *p != '@') || (p > syntax && p[-1] == '+'))
            continue;
        if (toupper(*p) == field)
            return *letter;
        letter++;
    }
    return '\0';
}

char reference_letter(const c205_insn *insn, unsigned g, char field)
{
    return by_g(insn, g, reference_table_letter(insn, field));
}

bool reference_is_half_register(char letter, bool broadcast)
{
    return letter && strchr(broadcast ? "FIWPMVU" : "FIWPM", letter);
}

unsigned width_of_letter(char letter)
{
    return letter && strchr("beoz", letter) ? BIT : isupper(letter) ? HALF_BITS : BITS;
}

/* ---- Registers --------------------------------------------------------- */

c205_word read_bits(const struct reference *reference, unsigned number)
{
    return number == 0 ? 0 : reference->now.registers[number];
}

void write_register(struct reference *reference, unsigned number, c205_word word)
{
    if (number >= C205_REGISTERS)
        add_fault(reference, C205_TRAP_BAD_DESCRIPTOR, 0, true);
    else if (number != 0)
        reference->now.registers[number] = word;
}

/* Returns the number of the register that contains a half register. */
static unsigned whole_register(unsigned number)
{
    return number / 2;
}

static unsigned shift_of_half(unsigned number)
{
    return number % 2 * HALF_BITS;
}

c205_word read_operand(const struct reference *reference, char letter, unsigned number)
{
    bool half = width_of_letter(letter) == HALF_BITS;
    unsigned whole = half ? whole_register(number) : number;
    c205_word word = read_bits(reference, whole);
    if (whole == 0)
        return strchr("fFvV", letter) ? C205_MACHINE_ZERO : 0;
    return half ? word << shift_of_half(number) & LEFT_HALF : word;
}

void write_operand(struct reference *reference, char letter, unsigned number,
                   c205_word word)
{
    unsigned whole = whole_register(number);
    c205_word mask = LEFT_HALF >> shift_of_half(number);
    if (width_of_letter(letter) == HALF_BITS)
        write_register(reference, whole,
                       (read_bits(reference, whole) & ~mask)
                           | (word >> shift_of_half(number) & mask));
    else
        write_register(reference, number, word);
}

/* ---- Memory ------------------------------------------------------------ */

static uint64_t word_of(uint64_t address)
{
    return plain_address(address) / BITS * BITS;
}

static void check_place(struct reference *reference, uint64_t address, unsigned width,
                        bool certain)
{
    if (plain_address(address) % width != 0)
        add_fault(reference, C205_TRAP_MISALIGNED_OPERAND, address, certain);
    if (!plain_is_mapped(&reference->memory, address))
        add_fault(reference, C205_TRAP_UNMAPPED_ADDRESS, address, certain);
}

static void check_write(struct reference *reference, uint64_t address, unsigned width,
                        bool certain)
{
    check_place(reference, address, width, certain);
    if (plain_is_mapped(&reference->memory, address)
        && !plain_is_writable(&reference->memory, address))
        add_fault(reference, C205_TRAP_PROTECTED_ADDRESS, address, certain);
}

/* Returns a mask of an operand's bits in a word. Bit 0 is the leftmost bit. */
static uint64_t bits_in_word(uint64_t address, unsigned width)
{
    return UINT64_MAX << (BITS - width) >> address % BITS;
}

c205_word read_memory(struct reference *reference, uint64_t address, unsigned width)
{
    c205_word word = plain_read(&reference->memory, word_of(address));
    check_place(reference, address, width, true);
    word = (word & bits_in_word(address, width)) << address % BITS;
    return width == BIT ? word >> (BITS - BIT) : word;
}

void write_memory(struct reference *reference, uint64_t address, unsigned width,
                  c205_word word)
{
    c205_word old = plain_read(&reference->memory, word_of(address));
    uint64_t mask = bits_in_word(address, width);
    check_write(reference, address, width, true);
    if (width == BIT)
        word <<= BITS - BIT;
    plain_store(&reference->memory, word_of(address),
                (old & ~mask) | (word >> address % BITS & mask));
}

void pass_by_memory(struct reference *reference, uint64_t address, unsigned width)
{
    check_place(reference, address, width, false);
}

void leave_memory(struct reference *reference, uint64_t address, unsigned width)
{
    check_write(reference, address, width, false);
}

void add_extent(struct reference *reference, uint64_t address, uint64_t bits)
{
    struct deed *deed = &reference->deed;
    if (bits > 0)
        deed->extents[deed->extent_count++] = (struct extent){ plain_address(address),
                                                               bits };
}

/* ---- Fetching ---------------------------------------------------------- */

/* Fetches the instruction at the program counter, and advances the program counter.
 * Returns false if there is no instruction, or if memory ends within it. */
static bool fetch(struct reference *reference)
{
    struct deed *deed = &reference->deed;
    uint64_t *pc = &reference->now.pc;
    c205_word word = read_memory(reference, *pc, HALF_BITS);
    if (certain_fault(reference))
        return false;
    const c205_insn *insn = c205_insn_coded((uint8_t)(word >> 56),
                                            (uint8_t)(word >> 48));
    if (!insn) {
        add_fault(reference, C205_TRAP_UNDEFINED_INSTRUCTION, *pc, true);
        return false;
    }
    *pc = plain_address(*pc + HALF_BITS);
    if (c205_format_halves(insn->format) == 2) {
        word |= read_memory(reference, *pc, HALF_BITS) >> HALF_BITS;
        *pc = plain_address(*pc + HALF_BITS);
    }
    deed->insns[deed->insn_count] = insn;
    deed->words[deed->insn_count] = word;
    deed->fields[deed->insn_count++] = c205_decode(insn, word);
    return !certain_fault(reference);
}

/* ---- The bits of G ----------------------------------------------------- */

/* Derives the bits of G from the operands of the row: which operands may be broadcast
 * or signed, and whether it has a control vector or an offset of the result. */
static unsigned vector_bits(const c205_insn *insn)
{
    const char *syntax = c205_format_syntax(insn->format);
    bool signs = insn->flags & C205_INSN_SIGN;
    unsigned bits = insn->subop_mask;
    if (strchr(syntax, 'a'))
        bits |= C205_G_BROADCAST_A;
    if (strchr(syntax, 'b'))
        bits |= C205_G_BROADCAST_B;
    if (strstr(syntax, "?Z") || strstr(syntax, "!Z"))
        bits |= C205_G_ZEROS;
    /* for a sparse vector this bit means C205_G_GIVEN */
    if (strstr(syntax, "[C]") && insn->format != C205_FORMAT_SPREAD
        && insn->format != C205_FORMAT_SPACED)
        bits |= C205_G_OFFSET;
    if (signs)
        bits |= C205_G_NEGATE_A | C205_G_MAGNITUDE_A;
    if (signs && strpbrk(syntax, "bB"))
        bits |= C205_G_MAGNITUDE_B;
    if (insn->flags & C205_INSN_HALF)
        bits |= C205_G_HALF;
    return bits;
}

unsigned reference_bits_of_g(const c205_insn *insn)
{
    return c205_unit_is_vector(insn->unit) ? vector_bits(insn)
                                           : insn->subop_mask | C205_G_RELATIVE;
}

bool reference_has_offset(const c205_insn *insn, const c205_fields *fields)
{
    return fields->g & C205_G_OFFSET && c205_unit_is_vector(insn->unit)
           && insn->format != C205_FORMAT_SPARSE
           && reference_bits_of_g(insn) & C205_G_OFFSET;
}

/* Returns true for a sum in two parts, whose result has the letter p. */
static bool is_sum(const c205_insn *insn)
{
    return strchr(insn->operands, 'p');
}

/* Checks the reserved fields. Fields that a format does not have must be zero. The
 * offset of a broadcast operand must be zero, and so must the zeros bit without a
 * control vector. r255 has no register after it. A sum in two registers must start with
 * an even register. */
static bool has_only(const c205_insn *insn, c205_word word, const c205_fields *fields)
{
    unsigned g = fields->g;
    if ((g & ~reference_bits_of_g(insn)) != 0 || c205_encode(insn, fields) != word)
        return false;
    return !c205_unit_is_vector(insn->unit)
           || !((g & C205_G_BROADCAST_A && fields->x != 0)
                || (g & C205_G_BROADCAST_B && fields->y != 0)
                || (g & C205_G_ZEROS && fields->z == 0)
                || (fields->c == C205_REGISTERS - 1
                    && reference_has_offset(insn, fields))
                || (is_sum(insn) && fields->c % 2 != 0));
}

/* Checks instruction i of the step. */
static void check_code(struct reference *reference, size_t i)
{
    const struct deed *deed = &reference->deed;
    if (!has_only(deed->insns[i], deed->words[i], deed->fields + i))
        add_fault(reference, C205_TRAP_UNDEFINED_INSTRUCTION, deed->pc, true);
    if (strstr(c205_format_syntax(deed->insns[i]->format), "!Z")
        && deed->fields[i].z == 0) /* there is no control vector */
        add_fault(reference, C205_TRAP_BAD_DESCRIPTOR, 0, true);
}

/* ---- A step ------------------------------------------------------------ */

static bool has_run_out(const struct reference_state *state, uint64_t clock)
{
    return state->timer != 0 && state->timer <= clock;
}

uint64_t reference_flags(const struct reference *reference, uint64_t clock)
{
    return reference->now.flags
           | (has_run_out(&reference->now, clock) ? FLAG_TIMER : 0);
}

static void do_one(struct reference *reference, const c205_insn *insn,
                   const c205_fields *fields)
{
    if (c205_unit_is_vector(insn->unit))
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

/* Sets the flag of the timer if it has expired. An expired timer stops. */
static void look_at_timer(struct reference *reference)
{
    reference->now.flags = reference_flags(reference, reference->clock);
    if (has_run_out(&reference->now, reference->clock))
        reference->now.timer = 0;
}

static void begin_step(struct reference *reference)
{
    struct deed *deed = &reference->deed;
    memset(reference->faults, 0, sizeof reference->faults);
    look_at_timer(reference);
    reference->before = reference->now;
    plain_commit(&reference->memory);
    deed->pc = reference->now.pc;
    deed->insn_count = deed->extent_count = deed->indexed_count = 0;
    deed->elements = deed->recurrent = 0;
    deed->swapped = deed->target = 0;
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
