/* resume.h - how far a vector instruction came before it was interrupted:
 * the machine's "invisible package" (that there is one is S, what is in it
 * is R).
 *
 * An instruction whose elements are not all done when the clock limit comes
 * leaves here what its loop carries from one element to the next; what it
 * stored is in memory already, and its other operands are described and
 * claimed again when it continues.  The instruction itself is kept as well: it
 * continues even if its result lies upon its own code.
 */
#ifndef C205_RESUME_STATE_H
#define C205_RESUME_STATE_H

#include "vm/decode.h"

/* A linked pair: a short prefix and two long instructions. */
enum { PACKAGE_HALVES = 5 };

struct resume_state {
    bool interrupted; /* the instruction at the program counter was; if not,
                         all of this is zero */
    size_t first;     /* elements done */
    size_t count[2];  /* merge: how many came from A and from B; compress: how
                         many were kept; search: how many comparisons were
                         made; maximum, minimum, select: the place found */
    bool found;
    c205_word word;  /* reductions: the result so far; an interval: the next
                         element .. */
    c205_word lower; /* the lower part of a sum so far */
    uint64_t flags;  /* .. and its data flags */
    size_t kept;     /* words in SCRATCH_KEPT: the indices of a gather or
                         scatter, the order vectors of a sparse operation */
    unsigned halves; /* of the instruction, .. */
    uint32_t half[PACKAGE_HALVES]; /* .. these */
};

/* The elements that an instruction goes through this time. */
struct turn {
    size_t first, end;
    size_t n; /* of all */
};

struct serializer;

/* The instruction was interrupted; its loop has left the rest. */
void resume_interrupt(struct resume_state *resume, const struct decoded *decoded);
/* The half word at an address belongs to the instruction at pc that was
 * interrupted. */
bool resume_holds(const struct resume_state *resume, uint64_t pc, uint64_t address,
                  c205_word *half);
/* To or from a serializer; SCRATCH_KEPT aside. */
void resume_walk(struct resume_state *resume, struct serializer *serializer);

#endif
