/* precision.h - bits that arithmetic loses because an operand is an integer
 * word.  Not public.
 *
 * An integer has the exponent 0 and as few significant bits as its value
 * needs.  The significant results (MPYS, DIVS, SQRT) have no more than the
 * operand that has fewer; the upper ones (ADDU, MPYU, DIVU) begin where the
 * coefficients do.  So 3 x 1 is 2 where both are integers, and no flag tells.
 */
#ifndef ASM_PRECISION_H
#define ASM_PRECISION_H

#include "vm/c205.h"

enum precision_rule {
    PRECISION_FULL, /* integers lose nothing */
    PRECISION_PRODUCT,
    PRECISION_QUOTIENT,
    PRECISION_ROOT,
    PRECISION_UPPER_SUM,
    PRECISION_UPPER_DIFFERENCE,
    PRECISION_UPPER_PRODUCT,
    PRECISION_UPPER_QUOTIENT
};

/* The rule of an instruction. */
enum precision_rule precision_rule(const c205_insn *insn);

/* Exponent 0 and not normalised; half words at the left of a word. */
bool precision_is_integer(c205_word word, bool half);

/* What becomes of two operands. */
struct precision {
    double exact, kept;
};

/* Whether more than a few bits are lost that normalised operands would have
 * kept. */
bool precision_is_lost(enum precision_rule rule, bool half, c205_word a, c205_word b,
                       struct precision *precision);

#endif
