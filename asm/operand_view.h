/* operand_view.h - what an instruction is about to work on: its operands, as
 * the registers of a machine that is before it describe them.  Not public.
 *
 * For who watches a program or tells why it trapped.  It reads the machine
 * and changes nothing.
 */
#ifndef ASM_OPERAND_VIEW_H
#define ASM_OPERAND_VIEW_H

#include "vm/c205.h"

enum { VIEW_OPERANDS = 8 };

struct operand_view {
    char letter;      /* of insn.def; a capital for 32 bits, with ,H too */
    char field;       /* of c205_fields; 0: an immediate or a target */
    uint8_t number;   /* of the register .. */
    uint8_t offset;   /* .. and of that with its offset; 0: none */
    bool is_half;     /* it is a half register */
    bool is_vector;   /* the register holds a descriptor of elements .. */
    unsigned width;   /* .. of so many bits */
    bool is_bad;      /* its offset is negative */
    c205_word word;   /* what the register holds, a half at the left */
    uint64_t address; /* of the first element, after the offset .. */
    size_t length;    /* .. and how many there are from it on */
};

struct instruction_view {
    uint64_t pc;
    const c205_insn *insn; /* NULL: there is none */
    c205_fields fields;
    unsigned halves;
    size_t count;
    struct operand_view operands[VIEW_OPERANDS];
};

/* What does not depend on registers. */
void view_decode(struct instruction_view *view, const c205 *machine, uint64_t pc);
/* What does: again before each execution. */
void view_fill(struct instruction_view *view, const c205 *machine);

/* The next instruction with what its registers hold, or the two that a LINKV links: how many
 * these are.  What is none has no insn. */
enum { VIEW_NEXT = 2 };
size_t view_next(struct instruction_view views[VIEW_NEXT], const c205 *machine);

/* The operand with one of these letters; NULL: it has none. */
const struct operand_view *view_find(const struct instruction_view *view,
                                     const char *letters);

/* n elements from the first on, those of 32 bits at the left of words, bits at
 * the right.  False: not all lie in mapped memory. */
bool view_read(const c205 *machine, const struct operand_view *operand, size_t first,
               size_t n, c205_word *words);

/* The word at an address on a half word; what is not mapped is zero. */
c205_word view_word_at(const c205 *machine, uint64_t address);

#endif
