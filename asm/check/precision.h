/* precision.h - computes the bits that arithmetic loses because an operand is an
 * integer word. Not public.
 *
 * An integer has exponent 0 and only the significant bits that its value needs. A
 * significant result (MPYS, DIVS, SQRT) has at most the bits of the operand with fewer
 * bits. The upper results (ADDU, MPYU, DIVU) start at the position of the coefficients.
 * For example, 3 x 1 is 2 if both are integers, and no data flag reports the loss.
 */
#ifndef ASM_PRECISION_H
#define ASM_PRECISION_H

#include "vm/c205.h"

enum precision_rule {
    PRECISION_FULL, /* integers lose no bits */
    PRECISION_PRODUCT,
    PRECISION_QUOTIENT,
    PRECISION_ROOT,
    PRECISION_UPPER_SUM,
    PRECISION_UPPER_DIFFERENCE,
    PRECISION_UPPER_PRODUCT,
    PRECISION_UPPER_QUOTIENT
};

/* Returns the rule by which an instruction loses bits of integers. */
enum precision_rule precision_rule(const c205_insn *insn);

/* Returns true if a word has exponent 0 and is not normalised. A half
 * word is left-aligned. */
bool precision_is_integer(c205_word word, bool half);

/* The result of an operation: the exact value and the value that the machine stores. */
struct precision {
    double exact, kept;
};

/* Returns true if the result of an operation on a and b loses more than a few bits that
 * normalised operands would preserve, and sets *precision. */
bool precision_is_lost(enum precision_rule rule, bool half, c205_word a, c205_word b,
                       struct precision *precision);

#endif
