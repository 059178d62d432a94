/* operand_view.h - describes the operands of an instruction before its execution, from
 * the registers of the machine. Not public.
 *
 * The debugger, the run-time checks and the reports of traps use these functions, which
 * do not change the machine.
 */
#ifndef ASM_OPERAND_VIEW_H
#define ASM_OPERAND_VIEW_H

#include "vm/c205.h"

enum { VIEW_OPERANDS = 8 };

struct operand_view {
    char letter;      /* letter of insn.def; a capital for 32 bits, also with ,H */
    char field;       /* letter of c205_fields; 0: an immediate or a target */
    uint8_t number;   /* number of the register */
    uint8_t offset;   /* number of the register with its offset; 0: none */
    bool is_half;     /* the register is a half register */
    bool is_vector;   /* the register contains a descriptor */
    unsigned width;   /* bits per element */
    bool is_bad;      /* the offset is negative */
    c205_word word;   /* value of the register; a half word is left-aligned */
    uint64_t address; /* address of the first element, after the offset */
    size_t length;    /* number of elements after the offset */
};

struct instruction_view {
    uint64_t pc;
    const c205_insn *insn; /* NULL: not an instruction */
    c205_fields fields;
    unsigned halves;
    size_t count;
    struct operand_view operands[VIEW_OPERANDS];
};

/* Decodes an instruction, and the properties of its operands that do not depend on the
 * contents of registers. */
void view_decode(struct instruction_view *view, const c205 *machine, uint64_t pc);
/* Describes an instruction by its fields instead of its word in memory. */
void view_take(struct instruction_view *view, uint64_t pc, const c205_insn *insn,
               c205_fields fields);
/* Adds the properties of the operands that depend on the contents of registers. Must be
 * called again before each execution. */
void view_fill(struct instruction_view *view, const c205 *machine);

/* The number of instructions that a LINKV links. view_at describes the instruction at
 * an address or, if it is a LINKV, the two instructions after it. It returns their
 * number. insn is NULL if the word is not an instruction. */
enum { VIEW_LINKED = 2 };
size_t view_at(struct instruction_view views[VIEW_LINKED], const c205 *machine,
               uint64_t pc);

/* Returns the operand that has one of these letters in insn.def, or NULL. */
const struct operand_view *view_find(const struct instruction_view *view,
                                     const char *letters);

/* Returns true if the instruction has the operand. Immediates and branch targets do not
 * count, and register 0 means that there is no control vector. */
bool view_is_present(const struct operand_view *operand);
/* Returns true if the instruction has and reads the operand. A vector that it writes
 * counts, because its descriptor is read. */
bool view_is_read(const struct operand_view *operand);

/* Reads n elements of the given width in bits, from element `first` of the vector at an
 * address. Elements of 32 bits are left-aligned in words, bits are right-aligned.
 * Returns false if memory is not mapped. */
bool view_read(const c205 *machine, uint64_t address, unsigned width, size_t first,
               size_t n, c205_word *words);

/* Returns the contents of a register, or of a half register left-aligned in a word. */
c205_word view_register(const c205 *machine, unsigned number, bool half);
/* Returns the word at the address of a half word. Unmapped memory reads as zero. */
c205_word view_word_at(const c205 *machine, uint64_t address);

#endif
