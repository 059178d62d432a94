/* expect.h - the expectations of test programs, and their comparison with a run.
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
 * A program without expect-trap must end with EXIT. A tolerance allows a difference of
 * numbers: "= 0.1, 0.2 ~ 1e-9".
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
    const c205_word *words; /* halves are left-aligned in words; bits are
                             * packed from the left */
    bool has_tolerance;     /* numbers may differ by the tolerance; otherwise
                             * the words must be equal */
    c205_word tolerance;
    const char *text; /* of EXPECT_TRAP and later kinds */
    const char *file;
    size_t line;
};

const char *expectation_name(enum expectation_kind kind);

/* Returns whether the program has an expectation other than the model. */
bool expect_anything(const struct object *object);

/* Returns the model on which the expected clocks are valid, or NULL for any model. */
const char *expect_model(const struct object *object);

/* Returns whether the program expects clocks of another model. Such
 * clocks are not compared. */
bool expect_other_model(const struct object *object, const c205 *machine);

/* Returns the warnings that the program declares as intended. */
warning_set expect_warnings(const struct object *object);

/* Compares a stopped machine with the expectations of its program. printed: all its
 * output; warned: the warnings of the program. Each failure is a line of the report. */
bool expect_check(const struct object *object, const c205 *machine,
                  const c205_stop *stop, const char *printed, warning_set warned,
                  const struct sink *report);

#endif
