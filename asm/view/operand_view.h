/* operand_view.h - the operands of an instruction before it is executed, as the
 * registers of the machine describe them. Not public.
 *
 * The debugger, the runtime checks and the reports of traps use it. It does
 * not change the machine.
 */
#ifndef ASM_OPERAND_VIEW_H
#define ASM_OPERAND_VIEW_H

#include "vm/c205.h"

enum { VIEW_OPERANDS = 8 };

struct operand_view {
    char letter;      /* of insn.def; a capital for 32 bits, also with ,H */
    char field;       /* of c205_fields; 0: an immediate or a target */
    uint8_t number;   /* of the register */
    uint8_t offset;   /* of the register with its offset; 0: none */
    bool is_half;     /* it is a half register */
    bool is_vector;   /* the register holds a descriptor */
    unsigned width;   /* bits of an element */
    bool is_bad;      /* its offset is negative */
    c205_word word;   /* contents of the register; a half is left-aligned */
    uint64_t address; /* of the first element, after the offset */
    size_t length;    /* number of elements from that address on */
};

struct instruction_view {
    uint64_t pc;
    const c205_insn *insn; /* NULL: not an instruction */
    c205_fields fields;
    unsigned halves;
    size_t count;
    struct operand_view operands[VIEW_OPERANDS];
};

/* Decodes the part that does not depend on registers. */
void view_decode(struct instruction_view *view, const c205 *machine, uint64_t pc);
/* Reads the part that depends on registers; needed again before each execution. */
void view_fill(struct instruction_view *view, const c205 *machine);

/* Decodes and fills the instruction at an address, or the two that a LINKV there links,
 * and returns their number. An insn is NULL if the word is not an instruction. */
enum { VIEW_LINKED = 2 };
size_t view_at(struct instruction_view views[VIEW_LINKED], const c205 *machine,
               uint64_t pc);

/* Returns the operand with one of these letters, or NULL. */
const struct operand_view *view_find(const struct instruction_view *view,
                                     const char *letters);

/* Returns whether the instruction has the operand. An immediate and a branch target are
 * not operands in registers, and register 0 means that there is no control vector. */
bool view_is_present(const struct operand_view *operand);
/* Returns the same for an operand that the instruction reads. A vector that it writes
 * counts, since its descriptor is read. */
bool view_is_read(const struct operand_view *operand);

/* Reads n elements of a width in bits, from the element `first` after an address on.
 * Elements of 32 bits are left-aligned in words, bits are right-aligned. Fails if memory
 * is not mapped. */
bool view_read(const c205 *machine, uint64_t address, unsigned width, size_t first,
               size_t n, c205_word *words);

/* Returns the word of a register, or a half register left-aligned in a word. */
c205_word view_register(const c205 *machine, unsigned number, bool half);
/* Returns the word at an address of a half word; unmapped memory reads as zero. */
c205_word view_word_at(const c205 *machine, uint64_t address);

#endif
