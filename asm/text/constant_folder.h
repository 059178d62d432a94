/* constant_folder.h - evaluates floating-point operations of expressions with the
 * machine's arithmetic.
 *
 * The assembler and a program compute the same bits for an expression. A machine
 * executes instructions for the operations, and routines of asm/lib for the functions.
 */
#ifndef ASM_CONSTANT_FOLDER_H
#define ASM_CONSTANT_FOLDER_H

#include "base/arena.h"
#include "vm/c205.h"

struct constant_folder;

struct constant_folder_function {
    const char *name; /* name or operator in an expression, such as "sin" or "+" */
    unsigned arguments;
    bool is_integer; /* the result is an integer, with exponent 0 */
    const char *label;
};

/* Returns the function with a name, or NULL. */
const struct constant_folder_function *constant_folder_find(const char *name,
                                                            size_t length);

/* Returns a constant folder, or NULL if memory is exhausted. */
struct constant_folder *constant_folder_new(void);
void constant_folder_free(struct constant_folder *constant_folder);

/* Computes a function. Only functions of two arguments use y. */
c205_word constant_folder_compute(struct constant_folder *constant_folder,
                                  const struct constant_folder_function *function,
                                  c205_word x, c205_word y);

#endif
