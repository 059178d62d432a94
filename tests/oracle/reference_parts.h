/* reference_parts.h - declarations for the files of the reference interpreter. */
#ifndef REFERENCE_PARTS_H
#define REFERENCE_PARTS_H

#include "tests/oracle/arithmetic_oracle.h"
#include "tests/oracle/reference.h"

/* Names of the rows of the instruction table, such as DO_ADDNV. */
enum reference_insn {
#define INSN(mnemonic, opcode, subop, mask, format, operands, unit, timing, flags, \
             semantics, operation, provenance, effect) \
    DO_##mnemonic,
#include "vm/insn.def"
    DO_NOTHING
};

/* Widths of operands in bits. */
enum { BIT = 1, HALF_BITS = 32, BITS = 64 };

enum { COEFFICIENT_BITS = 48 };
#define LOW_48 UINT64_C(0xFFFFFFFFFFFF)
#define LOW_24 UINT64_C(0xFFFFFF)

/* A half word is in the left half of a word. The right half is zero. */
#define LEFT_HALF UINT64_C(0xFFFFFFFF00000000)
#define HALF_ONE UINT64_C(0xEA40000000000000)

/* Set after the job interval timer has expired. */
#define FLAG_TIMER (UINT64_C(1) << (63 - 36))

static inline enum reference_insn reference_which(const c205_insn *insn)
{
    return (enum reference_insn)(insn - c205_insns);
}

/* Returns the rule of an operation on words, for registers and for elements. Returns
 * NULL if the instruction is of another kind. */
oracle_rule *reference_rule(const c205_insn *insn);

static inline const struct oracle_format *format_of(unsigned width)
{
    return width == HALF_BITS ? &oracle_half : &oracle_full;
}

/* Returns the width of the operand with this letter. */
unsigned width_of_letter(char letter);

/* ---- Words as integers and descriptors --------------------------------- */

static inline int64_t as_integer(c205_word word)
{
    int64_t low = (int64_t)(word & LOW_48);
    return low >> 47 ? low - (INT64_C(1) << COEFFICIENT_BITS) : low;
}

/* Returns a word with the low 48 bits of `low` and the high 16 bits of `high`. */
static inline c205_word with_low(c205_word high, uint64_t low)
{
    return (high & ~LOW_48) | (low & LOW_48);
}

static inline uint64_t length_of(c205_word descriptor)
{
    return descriptor >> COEFFICIENT_BITS;
}

static inline c205_word with_length(c205_word descriptor, uint64_t length)
{
    return length << COEFFICIENT_BITS | (descriptor & LOW_48);
}

/* ---- Registers and memory ---------------------------------------------- */

/* Returns a 64-bit register as a bit string. */
c205_word read_bits(const struct reference *reference, unsigned number);
void write_register(struct reference *reference, unsigned number, c205_word word);

/* Returns a register or a half register, depending on the operand's letter. Register 0,
 * h0 and h1 are read as machine zero if the operand is a number, otherwise as 0. */
c205_word read_operand(const struct reference *reference, char letter, unsigned number);
void write_operand(struct reference *reference, char letter, unsigned number,
                   c205_word word);

void add_fault(struct reference *reference, c205_trap trap, uint64_t address,
               bool certain);

/* Returns a word, a half word, or a bit as 1 or 0 at an address. */
c205_word read_memory(struct reference *reference, uint64_t address, unsigned width);
void write_memory(struct reference *reference, uint64_t address, unsigned width,
                  c205_word word);
/* pass_by_memory adds the possible faults of a load that was not needed. leave_memory
 * adds the possible faults of a store that the control vector excluded. */
void pass_by_memory(struct reference *reference, uint64_t address, unsigned width);
void leave_memory(struct reference *reference, uint64_t address, unsigned width);

void add_extent(struct reference *reference, uint64_t address, uint64_t bits);

/* ---- The instructions -------------------------------------------------- */

void do_scalar(struct reference *reference, const c205_insn *insn,
               const c205_fields *fields);
void do_branch(struct reference *reference, const c205_insn *insn,
               const c205_fields *fields);
void do_vector(struct reference *reference, const c205_insn *insn,
               const c205_fields *fields);
/* Executes deed.insns[1] and [2], the two instructions after the prefix. */
void do_linked(struct reference *reference);

#endif
