/* reference_parts.h - what the parts of the reference interpreter share. */
#ifndef REFERENCE_PARTS_H
#define REFERENCE_PARTS_H

#include "tests/oracle/arithmetic_oracle.h"
#include "tests/oracle/reference.h"

/* A name for each row of the instruction table: DO_ADDNV .. */
enum reference_insn {
#define INSN(mnemonic, opcode, subop, mask, format, operands, unit, timing, \
             flags, semantics, provenance, effect) \
    DO_##mnemonic,
#include "vm/insn.def"
    DO_NOTHING
};

enum { BITS = 64, HALF_BITS = 32, COEFFICIENT_BITS = 48 };
#define LOW_48 UINT64_C(0xFFFFFFFFFFFF)

static inline enum reference_insn reference_which(const c205_insn *insn)
{
    return (enum reference_insn)(insn - c205_insns);
}

/* The rule of an operation on words, for registers and for elements; NULL:
 * the instruction is of another kind. */
oracle_rule *reference_rule(const c205_insn *insn);

/* ---- Words as integers and descriptors --------------------------------- */

static inline int64_t as_integer(c205_word word)
{
    const int64_t low = (int64_t)(word & LOW_48);

    return low >> 47 ? low - (INT64_C(1) << COEFFICIENT_BITS) : low;
}

/* The low 48 bits, the high 16 taken from another word. */
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

/* Register 0 is machine zero to those who read numbers, 0 to others. */
c205_word read_as_number(const struct reference *reference, unsigned number);
c205_word read_bits(const struct reference *reference, unsigned number);
void write_register(struct reference *reference, unsigned number,
                    c205_word word);

void add_fault(struct reference *reference, c205_trap trap, uint64_t address,
               bool certain);

c205_word read_word(struct reference *reference, uint64_t address);
void write_word(struct reference *reference, uint64_t address,
                c205_word word);
bool read_bit(struct reference *reference, uint64_t address);
void write_bit(struct reference *reference, uint64_t address, bool bit);
/* A load that was not needed, and a store that the control vector left
 * out: they may trap. */
void pass_by_word(struct reference *reference, uint64_t address);
void pass_by_bit(struct reference *reference, uint64_t address);
void leave_word(struct reference *reference, uint64_t address);
void leave_bit(struct reference *reference, uint64_t address);

void add_extent(struct reference *reference, uint64_t address, uint64_t bits);

/* ---- The instructions -------------------------------------------------- */

void do_scalar(struct reference *reference, const c205_insn *insn,
               const c205_fields *fields);
void do_branch(struct reference *reference, const c205_insn *insn,
               const c205_fields *fields);
void do_vector(struct reference *reference, const c205_insn *insn,
               const c205_fields *fields);
/* The two after the prefix, in deed.insns[1] and [2]. */
void do_linked(struct reference *reference);

#endif
