/* reference.h - a second, simple implementation of the machine.
 *
 * Its sources are docs/machine.md and vm/insn.def. It executes one instruction at a
 * time, and one element at a time in element order, without spans, decoded programs or
 * a clock. It uses the arithmetic of arithmetic_oracle.h, and of vm/ only the
 * instruction table.
 *
 * The text does not always define whether an address is used. Examples are elements
 * that a control vector excludes, and sources of which only some elements are needed. A
 * fault there is *possible*: the machine may trap or not. All other faults are certain.
 * If an instruction has several faults, the machine may report any of them.
 *
 * In some points that the text leaves open, the reference follows the machine: the IBX
 * branches clear the high 16 bits; an unused field is undefined, and so is the zeros
 * bit without a control vector.
 */
#ifndef REFERENCE_H
#define REFERENCE_H

#include "tests/oracle/plain_memory.h"

/* All faults of one kind in an instruction, with the lowest and highest address. */
struct fault {
    bool possible, certain;
    uint64_t low, high;
};

/* A range of memory that an instruction uses. Units are bits. */
struct extent {
    uint64_t address, bits;
};

enum { PAIR = 2, EXTENTS = 8 };

/* The effects of an instruction that matter to a clock. */
struct deed {
    uint64_t pc;
    size_t insn_count; /* 1, or 3 for a prefix and a linked pair */
    const c205_insn *insns[PAIR + 1];
    c205_word words[PAIR + 1]; /* a short instruction is in the high half */
    c205_fields fields[PAIR + 1];
    uint64_t elements;
    uint64_t recurrent; /* number of elements that read an earlier result */
    uint64_t results;   /* number of results of sparse vectors */
    size_t extent_count;
    struct extent extents[EXTENTS];
    size_t indexed_count, indexed_room;
    uint64_t *indexed; /* addresses of a gather or scatter in order */
    uint64_t swapped;  /* number of words that SWAP moves */
    bool taken;
    uint64_t target;
};

struct reference_state {
    c205_word registers[C205_REGISTERS];
    uint64_t flags, pc;
    uint64_t timer; /* clock at which the job interval timer expires; 0: off */
};

struct reference {
    struct reference_state now, before;
    struct plain_memory memory;
    uint64_t clock; /* value of CLOCK, which the caller sets */
    struct fault faults[C205_TRAPS];
    struct deed deed;
    bool ended;
    bool lost; /* the instruction has no rule, or is too much work */
    int64_t status;
};

static inline uint64_t lesser(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

void reference_begin(struct reference *reference);
void reference_end(struct reference *reference);

/* Executes one instruction. If it has a certain fault, changes nothing and returns
 * false. Its stores are in memory.changes until the next step. */
bool reference_step(struct reference *reference);

/* Undoes the last instruction. Call it only if reference_step has returned true, that
 * is, if the instruction had no certain fault. */
void reference_undo(struct reference *reference);

/* Returns true if this is a fault of the last instruction. */
bool reference_has_fault(const struct reference *reference, c205_trap trap,
                         uint64_t address);

/* Returns true if the instruction has a rule. */
bool reference_knows(const c205_insn *insn);

/* Returns the data flags at a clock, including the flag of the timer. */
uint64_t reference_flags(const struct reference *reference, uint64_t clock);

/* Returns the bits of G that an instruction can have. */
unsigned reference_bits_of_g(const c205_insn *insn);

/* Returns true if register C+1 is an offset of the result. */
bool reference_has_offset(const c205_insn *insn, const c205_fields *fields);

/* Returns the table's letter for a field of the syntax. The field 'a' means A. */
char reference_table_letter(const c205_insn *insn, char field);
/* Returns the letter of reference_table_letter, as a capital if the operand has 32
 * bits, which may depend on G. G also decides whether an order vector is a source or a
 * result. Returns 0 if there is no such field. */
char reference_letter(const c205_insn *insn, unsigned g, char field);
/* Returns true if the letter, perhaps a broadcast operand, means a half register. */
bool reference_is_half_register(char letter, bool broadcast);

#endif
