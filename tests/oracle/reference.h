/* reference.h - a second, simple implementation of the machine.
 *
 * Written from docs/machine.md and vm/insn.def: it executes one instruction at a time,
 * one element at a time, in element order, without spans, decoded programs or a clock.
 * Arithmetic is that of arithmetic_oracle.h; from vm/ it uses only the instruction
 * table.
 *
 * The text does not always define whether an address is used: elements that a control
 * vector excludes, sources of which only some elements are needed.  A fault there is
 * *possible*: the machine may trap or not.  All other faults are certain.  If an
 * instruction has several faults, the machine may report any of them.
 *
 * The text leaves some points open, which follow the machine: the IBX branches
 * clear the high 16 bits; an unused field, and the zeros bit without a control vector,
 * are undefined.
 */
#ifndef REFERENCE_H
#define REFERENCE_H

#include "tests/oracle/plain_memory.h"

/* All faults of one kind of an instruction, as the lowest and the highest address at
 * fault. */
struct fault {
    bool possible, certain;
    uint64_t low, high;
};

/* A range of memory that an instruction uses, in bits. */
struct extent {
    uint64_t address, bits;
};

enum { PAIR = 2, EXTENTS = 8 };

/* The effects of an instruction that a clock needs. */
struct deed {
    uint64_t pc;
    size_t insn_count; /* 1, or 3: prefix and linked pair */
    const c205_insn *insns[PAIR + 1];
    c205_word words[PAIR + 1]; /* a short one is in the high half */
    c205_fields fields[PAIR + 1];
    uint64_t elements;
    uint64_t recurrent; /* elements that read an earlier result */
    uint64_t results;   /* of sparse vectors, computed from the elements */
    size_t extent_count;
    struct extent extents[EXTENTS];
    size_t indexed_count, indexed_room;
    uint64_t *indexed; /* addresses of gather and scatter, in order */
    uint64_t swapped;  /* words */
    bool taken;
    uint64_t target;
};

struct reference_state {
    c205_word registers[C205_REGISTERS];
    uint64_t flags, pc;
    uint64_t timer; /* the clock at which it expires; 0: it is off */
};

struct reference {
    struct reference_state now, before;
    struct plain_memory memory;
    uint64_t clock; /* value of CLOCK; set by the caller */
    struct fault faults[C205_TRAPS];
    struct deed deed;
    bool ended;
    bool lost; /* instruction without a rule, or too much work */
    int64_t status;
};

static inline uint64_t lesser(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

void reference_begin(struct reference *reference);
void reference_end(struct reference *reference);

/* Executes one instruction.  Returns false if it has a certain fault; nothing changes
 * then.  Its stores are in memory.changes until the next step. */
bool reference_step(struct reference *reference);

/* Undoes the last instruction, which had only possible faults. */
void reference_undo(struct reference *reference);

/* Returns whether the faults of the last instruction include this one. */
bool reference_has_fault(const struct reference *reference, c205_trap trap,
                         uint64_t address);

/* Returns whether the instruction has a rule. */
bool reference_knows(const c205_insn *insn);

/* Returns the data flags at a clock, which includes the flag of the timer. */
uint64_t reference_flags(const struct reference *reference, uint64_t clock);

/* Returns the bits of G that an instruction may have. */
unsigned reference_bits_of_g(const c205_insn *insn);

/* Returns whether register C+1 is an offset of the result. */
bool reference_has_offset(const c205_insn *insn, const c205_fields *fields);

/* Returns the letter of the instruction table for a field of the syntax, A for a. */
char reference_table_letter(const c205_insn *insn, char field);
/* Returns the same letter, a capital if its width is 32 bits, also by G.  For an order
 * vector that may be a source or a result, G decides.  0: there is no such field. */
char reference_letter(const c205_insn *insn, unsigned g, char field);
/* Returns whether the letter means a half register; with broadcast, of a vector operand
 * that is broadcast. */
bool reference_is_half_register(char letter, bool broadcast);

#endif
