/* scalar.c - executes arithmetic on registers, loads, stores and the register swap.
 * Register 0 needs no special case (see SLOT_MACHINE_ZERO and SLOT_SINK).
 */
#include "vm/machine.h"
#include "vm/number/fast_path.h"

#include <string.h>

/* Defines an instruction T := value; a and b are the words of R and S. */
#define TO_T(name, value) \
    c205_trap execute_##name(struct c205 *machine, const struct decoded *d) \
    { \
        c205_word a = machine->slot[d->a], b = machine->slot[d->b]; \
        (void)a, (void)b; \
        machine->slot[d->c] = (value); \
        return C205_TRAP_NONE; \
    }

/* Defines an instruction R := value; a is the word of R and i the immediate. */
#define TO_R(name, value) \
    c205_trap execute_##name(struct c205 *machine, const struct decoded *d) \
    { \
        c205_word a = machine->slot[d->a]; \
        uint64_t i = (uint64_t)d->fields.immediate; \
        (void)a; \
        machine->slot[d->result[0]] = (value); \
        return C205_TRAP_NONE; \
    }

/* ---- Registers: enter, move, index and address arithmetic -------------- */

TO_R(enter_short, LOW(i))
TO_R(enter_long, LOW(i))
TO_R(increase_short, HIGH(a) | LOW(a + i))
TO_R(increase_long, HIGH(a) | LOW(a + i))
TO_R(enter_length, LOW(a) | i << LENGTH_SHIFT)

TO_T(add_length, a + (b << LENGTH_SHIFT))
TO_T(length_to_register, a >> LENGTH_SHIFT)
TO_T(move_register, a)
TO_T(add_index, HIGH(a) | LOW(a + b))
TO_T(subtract_index, HIGH(a) | LOW(a - b))
TO_T(multiply_index, LOW((a) * (b)))

/* ---- Special registers ------------------------------------------------- */

uint64_t *machine_raise_flags(struct c205 *machine)
{
    machine->data_flags = machine_flags(machine);
    if (machine_timer_has_run_out(machine))
        machine->timer = 0;
    return &machine->data_flags;
}

c205_trap execute_exchange_flags(struct c205 *machine, const struct decoded *decoded)
{
    uint64_t *flags = machine_raise_flags(machine);
    c205_word before = *flags;
    *flags = machine->slot[decoded->a];
    machine->slot[decoded->c] = before;
    return C205_TRAP_NONE;
}

TO_T(read_clock, LOW(machine_clocks(machine)))

static uint64_t clocks_left(const struct c205 *machine)
{
    uint64_t now = machine_clocks(machine);
    return machine->timer > now ? machine->timer - now : 0;
}

TO_T(read_timer, LOW(clocks_left(machine)))

c205_trap execute_set_timer(struct c205 *machine, const struct decoded *decoded)
{
    uint64_t clocks = LOW(machine->slot[decoded->a]);
    machine_raise_flags(machine);
    machine->timer = clocks ? machine_clocks(machine) + clocks : 0;
    return C205_TRAP_NONE;
}

/* ---- Arithmetic -------------------------------------------------------- */

/* Defines an instruction T := value; a and b are the half words of R and S. */
#define TO_HALF(name, value) \
    c205_trap execute_##name(struct c205 *machine, const struct decoded *d) \
    { \
        c205_word a = machine_half(machine, d->a, d->shift[OPERAND_A]); \
        c205_word b = machine_half(machine, d->b, d->shift[OPERAND_B]); \
        (void)a, (void)b; \
        machine_deliver(machine, d, value); \
        return C205_TRAP_NONE; \
    }
#define BINARY_REGISTERS(name) \
    TO_T(name, arith_##name(a, b, &machine->data_flags)) \
    TO_HALF(half_##name, half_##name(a, b, &machine->data_flags))
#define UNARY_REGISTERS(name) \
    TO_T(name, arith_##name(a, &machine->data_flags)) \
    TO_HALF(half_##name, half_##name(a, &machine->data_flags))
#define BINARY_COMMON(name) \
    TO_T(name, fast_##name(a, b, &machine->data_flags)) \
    TO_HALF(half_##name, half_##name(a, b, &machine->data_flags))
#define UNARY_COMMON(name) \
    TO_T(name, fast_##name(a, &machine->data_flags)) \
    TO_HALF(half_##name, half_##name(a, &machine->data_flags))
/* These rows of arith.def expand to nothing: they have no register instruction, or it
 * is defined below. */
#define BINARY_VECTORS(name)
#define UNARY_VECTORS(name)

#define BINARY(name, spans, registers, specials) BINARY_##registers(name)
#define UNARY(name, spans, registers, specials) UNARY_##registers(name)
#include "vm/arith.def"

/* ---- Half registers ----------------------------------------------------- */

TO_HALF(move_half, a)
TO_HALF(extend, arith_extend(a, &machine->data_flags))

static c205_trap cut_to_half(struct c205 *machine, const struct decoded *decoded,
                             arith_unary *contract)
{
    machine_deliver(machine, decoded,
                    contract(machine->slot[decoded->a], &machine->data_flags));
    return C205_TRAP_NONE;
}

c205_trap execute_contract(struct c205 *machine, const struct decoded *decoded)
{
    return cut_to_half(machine, decoded, arith_contract);
}

c205_trap execute_contract_rounded(struct c205 *machine, const struct decoded *decoded)
{
    return cut_to_half(machine, decoded, arith_contract_rounded);
}

/* Mask of the coefficient of a half word in the left half of a word. */
#define HALF_COEFFICIENT UINT64_C(0x00FFFFFF00000000)

c205_trap execute_enter_half(struct c205 *machine, const struct decoded *decoded)
{
    c205_word i = (c205_word)decoded->fields.immediate << HALF_BITS;
    machine_set_half(machine, decoded->result[0], decoded->shift[OPERAND_A],
                     i & HALF_COEFFICIENT);
    return C205_TRAP_NONE;
}

c205_trap execute_increase_half(struct c205 *machine, const struct decoded *decoded)
{
    c205_word i = (c205_word)decoded->fields.immediate << HALF_BITS;
    uint8_t shift = decoded->shift[OPERAND_A];
    c205_word a = machine_half(machine, decoded->a, shift);
    machine_set_half(machine, decoded->result[0], shift,
                     (a & ~HALF_COEFFICIENT) | ((a + i) & HALF_COEFFICIENT));
    return C205_TRAP_NONE;
}

/* ---- Shift and logical ------------------------------------------------- */

TO_T(shift_immediate, format_shift(whole_words, a, d->fields.immediate))
TO_T(shift_register, arith_shift(a, b, &machine->data_flags))
TO_T(exclusive_or, a ^ b)
TO_T(and, (a) & (b))
TO_T(or, a | b)

/* ---- Fields of bits ---------------------------------------------------- */

/* A field of a word. Its descriptor contains the length in the high 16 bits and the
 * index of the first bit in the low 48 bits. */
struct field {
    uint64_t ones;  /* as many right-justified ones as the field has bits */
    unsigned right; /* number of bits of the word after the field */
};

static c205_trap describe_field(struct c205 *machine, c205_word descriptor,
                                struct field *field)
{
    uint64_t length = descriptor >> LENGTH_SHIFT, first = LOW(descriptor);
    if (first + length > WORD_BITS)
        return machine_refuse(machine, RULE_FIELD);
    field->ones = length > 0 ? UINT64_MAX >> (WORD_BITS - length) : 0;
    field->right = length > 0 ? (unsigned)(WORD_BITS - first - length) : 0;
    return C205_TRAP_NONE;
}

c205_trap execute_insert_bits(struct c205 *machine, const struct decoded *decoded)
{
    c205_word word = machine->slot[decoded->c], bits;
    struct field field;
    c205_trap trap = describe_field(machine, machine->slot[decoded->b], &field);
    if (trap != C205_TRAP_NONE)
        return trap;
    bits = machine->slot[decoded->a] & field.ones;
    machine->slot[decoded->result[0]] = (word & ~(field.ones << field.right))
                                        | bits << field.right;
    return C205_TRAP_NONE;
}

c205_trap execute_extract_bits(struct c205 *machine, const struct decoded *decoded)
{
    struct field field;
    c205_trap trap = describe_field(machine, machine->slot[decoded->b], &field);
    if (trap == C205_TRAP_NONE)
        machine->slot[decoded->c] = machine->slot[decoded->a] >> field.right
                                    & field.ones;
    return trap;
}

/* ---- Memory ------------------------------------------------------------ */

/* Returns the bit address R + 64 S of a word. */
static uint64_t operand_address(const struct c205 *machine,
                                const struct decoded *decoded)
{
    return LOW(machine->slot[decoded->a] + machine->slot[decoded->b] * WORD_BITS);
}

c205_trap execute_load_word(struct c205 *machine, const struct decoded *decoded)
{
    uint64_t address = operand_address(machine, decoded);
    c205_trap trap = memory_load(&machine->memory, address, &machine->slot[decoded->c]);
    if (trap != C205_TRAP_NONE)
        return machine_fault(machine, trap, address);
    machine_touch(machine, address, WORD_BITS);
    return C205_TRAP_NONE;
}

/* Ends the block if a store has changed decoded code. */
static void count_changes(struct c205 *machine, uint64_t before)
{
    machine->effect.ends = machine->memory.code_changes != before;
}

c205_trap execute_store_word(struct c205 *machine, const struct decoded *decoded)
{
    uint64_t address = operand_address(machine, decoded);
    uint64_t changes = machine->memory.code_changes;
    c205_trap trap = memory_store(&machine->memory, address, machine->slot[decoded->c]);
    if (trap != C205_TRAP_NONE)
        return machine_fault(machine, trap, address);
    count_changes(machine, changes);
    machine_touch_result(machine, address, WORD_BITS);
    return C205_TRAP_NONE;
}

/* Returns the bit address R + 32 S of a half word. */
static uint64_t half_address(const struct c205 *machine, const struct decoded *decoded)
{
    return LOW(machine->slot[decoded->a] + machine->slot[decoded->b] * HALF_BITS);
}

c205_trap execute_load_half(struct c205 *machine, const struct decoded *decoded)
{
    uint64_t address = half_address(machine, decoded);
    c205_word half;
    c205_trap trap = memory_load_half(&machine->memory, address, &half);
    if (trap != C205_TRAP_NONE)
        return machine_fault(machine, trap, address);
    machine_deliver(machine, decoded, half);
    machine_touch(machine, address, HALF_BITS);
    return C205_TRAP_NONE;
}

c205_trap execute_store_half(struct c205 *machine, const struct decoded *decoded)
{
    uint64_t address = half_address(machine, decoded);
    uint64_t changes = machine->memory.code_changes;
    c205_word half = machine_half(machine, decoded->c, decoded->shift[OPERAND_C]);
    c205_trap trap = memory_store_half(&machine->memory, address, half);
    if (trap != C205_TRAP_NONE)
        return machine_fault(machine, trap, address);
    count_changes(machine, changes);
    machine_touch_result(machine, address, HALF_BITS);
    return C205_TRAP_NONE;
}

/* ---- Swap -------------------------------------------------------------- */

/* Checks that the registers from first on can be saved to the vector of a descriptor or
 * loaded from it. */
static c205_trap check_swap(struct c205 *machine, c205_word descriptor, unsigned first,
                            bool save)
{
    uint64_t address = LOW(descriptor);
    size_t length = (size_t)(descriptor >> LENGTH_SHIFT);
    if (first + length > C205_REGISTERS)
        return machine_fault(machine, machine_refuse(machine, RULE_SWAPPED), address);
    if (length > 0 && address % WORD_BITS)
        return machine_fault(machine, C205_TRAP_MISALIGNED_OPERAND, address);
    return memory_check(&machine->memory, address, length * WORD_BITS, save,
                        &machine->fault);
}

/* Saves registers to vector T, then loads registers from vector R. If the vectors
 * overlap, the saved values are loaded. */
c205_trap execute_swap_registers(struct c205 *machine, const struct decoded *decoded)
{
    unsigned first = decoded->fields.s;
    c205_word from = machine->slot[decoded->a], to = machine->slot[decoded->c];
    size_t loaded = (size_t)(from >> LENGTH_SHIFT);
    size_t saved = (size_t)(to >> LENGTH_SHIFT);
    c205_trap trap = check_swap(machine, from, first, false);
    if (trap == C205_TRAP_NONE)
        trap = check_swap(machine, to, first, true);
    if (trap != C205_TRAP_NONE)
        return trap;
    memory_write_words(&machine->memory, LOW(to), machine->slot + first, saved);
    memory_read_words(&machine->memory, LOW(from), machine->slot + first, loaded);
    machine->slot[0] = 0;
    machine->effect.swapped = loaded + saved;
    machine->effect.saved = saved;
    if (loaded > 0)
        machine_touch(machine, LOW(from), loaded * WORD_BITS);
    if (saved > 0)
        machine_touch_result(machine, LOW(to), saved * WORD_BITS);
    return C205_TRAP_NONE;
}
