/* unwritten.h - finds registers that a program reads before it has written them. Not
 * public.
 *
 * The assembler checks the instructions from the entry to the first branch, which are
 * executed in the order of the text. The runtime checker checks all others.
 */
#ifndef ASM_UNWRITTEN_H
#define ASM_UNWRITTEN_H

#include "asm/view/operand_view.h"
#include "base/sink.h"

/* A set of registers. A half register counts as its register. */
struct register_set {
    uint64_t bits[C205_REGISTERS / 64];
};

void register_set_add(struct register_set *set, unsigned number);

/* An operand whose register is read before anything was written to it. */
struct unwritten {
    unsigned number;
    bool is_half, is_vector;
};

/* Returns true, and sets *found, if an instruction reads a register that is not in the
 * set. Adds all registers that it reads, so each is found once. Instructions that modify
 * a register, such as IS and ELEN, do not count as readers, unless they are branches:
 * registers are 0 at the start, so a program may count from there. SWAP may save
 * registers that are not in use. */
bool unwritten_find(struct register_set *written, const struct instruction_view *view,
                    struct unwritten *found);
/* Returns true if an instruction only copies a register. A macro may pass on an argument
 * that its function does not use. */
bool unwritten_is_copy(const c205_insn *insn);
/* Prints the message. name is the name of the register in the program, or "". */
void unwritten_print(const struct unwritten *found, const char *name,
                     const struct instruction_view *view, const struct sink *sink);

/* Adds the registers that an instruction writes. */
void unwritten_add_results(struct register_set *written,
                           const struct instruction_view *view);
/* Returns true if the next instruction in memory is executed after this instruction,
 * and unwritten_add_results knows all registers that it writes. */
bool unwritten_is_straight(const c205_insn *insn);

#endif
