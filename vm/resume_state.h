/* resume_state.h - the progress of an interrupted vector instruction. The real machine
 * had an "invisible package" for it. A secondary source mentions this package. Its
 * content is reconstructed.
 *
 * If the clock limit interrupts an instruction, its loop saves here the values that it
 * carries from one element to the next. Stored elements are already in memory. When the
 * instruction continues, the descriptors of its operands are evaluated and their memory
 * is checked again. The instruction is saved as well, so it continues even if its
 * result overwrites its code.
 */
#ifndef C205_RESUME_STATE_H
#define C205_RESUME_STATE_H

#include "vm/decode.h"

/* Length of a linked pair in half words: a short prefix and two long instructions. */
enum { PACKAGE_HALVES = 5 };

struct resume_state {
    bool interrupted; /* the instruction at the program counter was interrupted;
                         otherwise all fields are zero */
    size_t first;     /* number of elements done */
    size_t count[2];  /* merge: elements taken from A and from B; compress: elements
                         kept; search: comparisons; maximum, minimum, select: index of
                         the element found */
    bool found;
    c205_word word;  /* reductions: the result so far; interval: the next element */
    c205_word lower; /* the lower part of a sum so far */
    uint64_t flags;  /* interval: data flags of word */
    size_t kept;     /* words in SCRATCH_KEPT: the indices of a gather or scatter, the
                        order vectors of a sparse operation */
    unsigned halves; /* length of the instruction in half words */
    uint32_t half[PACKAGE_HALVES]; /* the instruction */
};

/* The elements that an instruction processes before a limit. */
struct turn {
    size_t first, end;
    size_t n; /* number of all elements */
};

struct serializer;

/* Marks the instruction as interrupted and saves it. The loop must have saved the other
 * fields. */
void resume_interrupt(struct resume_state *resume, const struct decoded *decoded);
/* Returns true and sets *half if the interrupted instruction at pc contains the
 * address. */
bool resume_holds(const struct resume_state *resume, uint64_t pc, uint64_t address,
                  c205_word *half);
/* Serializes all fields, but not the words in SCRATCH_KEPT. */
void resume_walk(struct resume_state *resume, struct serializer *serializer);

#endif
