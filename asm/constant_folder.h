/* constant_folder.h - floating-point values in expressions, as the machine has them.
 *
 * What an expression computes at assembly, a program computes bit for bit the same: the
 * operations are instructions, the functions are routines of asm/lib, and a machine
 * runs them.
 */
#ifndef ASM_CONSTANT_FOLDER_H
#define ASM_CONSTANT_FOLDER_H

#include "base/arena.h"
#include "vm/c205.h"

struct constant_folder;

struct constant_folder_function {
    const char *name; /* as in an expression, or an operator: "sin", "+" */
    unsigned arguments;
    bool is_integer; /* its result: exponent 0 */
    const char *label;
};

/* NULL: there is none. */
const struct constant_folder_function *constant_folder_find(const char *name,
                                                            size_t length);

/* NULL: the host has no memory. */
struct constant_folder *constant_folder_new(void);
void constant_folder_free(struct constant_folder *constant_folder);

/* y counts where there are two arguments. */
c205_word constant_folder_compute(struct constant_folder *constant_folder,
                                  const struct constant_folder_function *function,
                                  c205_word x, c205_word y);

#endif
