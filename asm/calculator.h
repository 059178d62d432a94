/* calculator.h - floating-point values in expressions, as the machine has them.
 *
 * What an expression computes at assembly, a program computes bit for bit the same: the
 * operations are instructions, the functions are routines of asm/lib, and a machine
 * runs them.
 */
#ifndef ASM_CALCULATOR_H
#define ASM_CALCULATOR_H

#include "base/arena.h"
#include "vm/c205.h"

struct calculator;

struct calculator_function {
    const char *name; /* as in an expression, or an operator: "sin", "+" */
    unsigned arguments;
    bool is_integer; /* its result: exponent 0 */
    const char *label;
};

/* NULL: there is none. */
const struct calculator_function *calculator_find(const char *name, size_t length);

/* NULL: the host has no memory. */
struct calculator *calculator_new(void);
void calculator_free(struct calculator *calculator);

/* y counts where there are two arguments. */
c205_word calculator_compute(struct calculator *calculator,
                             const struct calculator_function *function, c205_word x,
                             c205_word y);

#endif
