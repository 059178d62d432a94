/* reference.h - the machine a second time, as plainly as it can be said.
 *
 * Written from docs/machine.md and vm/insn.def: one instruction at a time,
 * one element at a time, in element order.  No spans, no decoded programs,
 * no clock.  Arithmetic is that of arithmetic_oracle.h; from vm/ it uses
 * only the instruction table.
 *
 * Where the text leaves open whether an address is used (elements that a
 * control vector leaves out, sources of which only some elements are
 * needed) a fault there is *possible*: the machine may trap or not.
 * Everything else is certain.  When an instruction has several faults any of
 * them may be the one that is told.
 *
 * What the text does not say was settled by comparing with the machine:
 * IBX.. clears the high 16 bits; an unused field, and zeros of no control
 * vector, are undefined.
 */
#ifndef REFERENCE_H
#define REFERENCE_H

#include "tests/oracle/plain_memory.h"

/* All faults of one kind that an instruction has: the lowest and the highest
 * address at fault. */
struct fault {
    bool possible, certain;
    uint64_t low, high;
};

/* Memory that an instruction uses, in bits. */
struct extent {
    uint64_t address, bits;
};

enum { PAIR = 2, EXTENTS = 8 };

/* What an instruction did, as far as a clock wants to know. */
struct deed {
    uint64_t pc;
    size_t insn_count; /* 1, or 3: prefix and linked pair */
    const c205_insn *insns[PAIR + 1];
    c205_word words[PAIR + 1]; /* a short one in its high half */
    c205_fields fields[PAIR + 1];
    uint64_t elements;
    uint64_t recurrent; /* elements that read what one before has stored */
    uint64_t results;   /* sparse vectors: made of so many of the elements */
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
    uint64_t timer; /* the clock at which it runs out; 0: it is off */
};

struct reference {
    struct reference_state now, before;
    struct plain_memory memory;
    uint64_t clock; /* as CLOCK reads it; set by who counts clocks */
    struct fault faults[C205_TRAPS];
    struct deed deed;
    bool ended;
    bool lost; /* no rule for the instruction, or too long a work */
    int64_t status;
};

void reference_begin(struct reference *reference);
void reference_end(struct reference *reference);

/* One instruction.  False: it has a certain fault, and nothing changed.
 * The stores it made are in memory.changes until the next step. */
bool reference_step(struct reference *reference);

/* Take the last instruction back, which had possible faults only. */
void reference_undo(struct reference *reference);

/* True: its faults include this one. */
bool reference_has_fault(const struct reference *reference, c205_trap trap,
                         uint64_t address);

/* False: no rule for this instruction has been written yet. */
bool reference_knows(const c205_insn *insn);

/* The data flags as they are at a clock: that of the timer comes by
 * itself. */
uint64_t reference_flags(const struct reference *reference, uint64_t clock);

/* The bits of G that an instruction may have. */
unsigned reference_bits_of_g(const c205_insn *insn);

/* Register C+1 holds an offset of the result. */
bool reference_has_offset(const c205_insn *insn, const c205_fields *fields);

/* What a field of the syntax is, A for a, by the letters of the table: in
 * capitals if it is of 32 bits, also where G says so; an order vector that may
 * be made or given is what G says.  0: no such field. */
char reference_letter(const c205_insn *insn, unsigned g, char field);
/* A half register, as a number broadcast if it may be a vector. */
bool reference_is_half_register(char letter, bool broadcast);

#endif
