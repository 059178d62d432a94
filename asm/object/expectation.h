/* expectation.h - the expectations of test programs, from their comments.
 *
 *   ; expect: r10 = 5            the register holds this word
 *   ; expect: h10 = 1.5          the half register holds this half word
 *   ; expect: [label] = 1.5, 2   the words from the label on
 *   ; expect-halves: [label] = 1.5, 2   the half words from the label on
 *   ; expect-bits: [label] = 1011 0010
 *   ; expect-flags: X'0000 0000 0040 0000'
 *   ; expect-clocks: 150
 *   ; expect-trap: bad-descriptor
 *   ; expect-print: text         the next line that the program prints
 *   ; expect-model: NAME         the model on which the clocks are compared
 *   ; expect-warning: NAME       the program causes this warning intentionally
 *
 * A program without expect-trap must end with EXIT. A tolerance such as "= 0.1, 0.2 ~
 * 1e-9" allows numbers to differ.
 */
#ifndef ASM_EXPECTATION_H
#define ASM_EXPECTATION_H

#include "vm/c205.h"

enum expectation_kind {
    EXPECT_REGISTER,
    EXPECT_HALF_REGISTER,
    EXPECT_WORDS,
    EXPECT_HALVES,
    EXPECT_BITS,
    EXPECT_FLAGS,
    EXPECT_CLOCKS,
    EXPECT_TRAP,
    EXPECT_PRINT,
    EXPECT_MODEL,
    EXPECT_WARNING,
    EXPECT_KINDS
};

struct asm_expectation {
    enum expectation_kind kind;
    unsigned number;        /* number of the register */
    uint64_t address;       /* bit address of the first element */
    size_t count;           /* number of words, half words or bits */
    const c205_word *words; /* half words are left-aligned in words; bits are packed
                               from the left */
    bool has_tolerance;     /* numbers may differ by the tolerance; otherwise words must
                               be equal */
    c205_word tolerance;
    const char *text; /* for EXPECT_TRAP and later kinds */
    const char *file;
    size_t line;
};

/* Returns the keyword for a kind of expectation in object files. */
const char *expectation_name(enum expectation_kind kind);

#endif
