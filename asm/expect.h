/* expect.h - what test programs say of themselves, and whether it came true.
 *
 *   ; expect: r10 = 5            the register holds this word
 *   ; expect: h10 = 1.5          the half register holds this half word
 *   ; expect: [label] = 1.5, 2   the words from there
 *   ; expect-halves: [label] = 1.5, 2   the half words from there
 *   ; expect-bits: [label] = 1011 0010
 *   ; expect-flags: X'0000 0000 0040 0000'
 *   ; expect-clocks: 150
 *   ; expect-trap: bad-descriptor
 *   ; expect-print: text         the next line that the program prints
 *   ; expect-model: NAME         the model on which the clocks hold
 *   ; expect-warning: NAME       it is warned of this, and means it
 *
 * A program without expect-trap is expected to end with EXIT.  Numbers may be off
 * by a tolerance: "= 0.1, 0.2 ~ 1e-9".
 */
#ifndef ASM_EXPECT_H
#define ASM_EXPECT_H

#include "asm/assemble.h"

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
    unsigned number;        /* of the register */
    uint64_t address;       /* of the first word, half or bit */
    size_t count;           /* words, halves or bits */
    const c205_word *words; /* a half is at the left of one; bits are packed
                               from the left */
    bool has_tolerance;     /* numbers may be off by this; else the words are
                               the same */
    c205_word tolerance;
    const char *text; /* EXPECT_TRAP and those after it */
    const char *file;
    size_t line;
};

const char *expectation_name(enum expectation_kind kind);

/* More than the model. */
bool expect_anything(const struct object *object);

/* The model on which the clocks that a program expects hold; NULL: on any. */
const char *expect_model(const struct object *object);

/* Whether the program expects clocks that were counted on another model, which
 * are not compared. */
bool expect_other_model(const struct object *object, const c205 *machine);

/* The warnings that the program means. */
warning_set expect_warnings(const struct object *object);

/* Compare a machine that has stopped with what its program expects; printed
 * is all that it printed, and warned what it was warned of.  Each failure is
 * a line put to the report. */
bool expect_check(const struct object *object, const c205 *machine,
                  const c205_stop *stop, const char *printed, warning_set warned,
                  const struct sink *report);

#endif
