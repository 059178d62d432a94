/* constant_folder.h - evaluates floating-point operations of expressions with the
 * machine's arithmetic.
 *
 * An expression has the same bits at assembly as in a program. The operations are
 * instructions, the functions are routines of asm/lib, and a machine executes both.
 */
#ifndef ASM_CONSTANT_FOLDER_H
#define ASM_CONSTANT_FOLDER_H

#include "base/arena.h"
#include "vm/c205.h"

struct constant_folder;

struct constant_folder_function {
    const char *name; /* name in an expression, or operator: "sin", "+" */
    unsigned arguments;
    bool is_integer; /* the result is an integer: exponent 0 */
    const char *label;
};

/* Returns NULL if there is no such function. */
const struct constant_folder_function *constant_folder_find(const char *name,
                                                            size_t length);

/* Returns NULL if memory is exhausted. */
struct constant_folder *constant_folder_new(void);
void constant_folder_free(struct constant_folder *constant_folder);

/* y is used by functions of two arguments. */
c205_word constant_folder_compute(struct constant_folder *constant_folder,
                                  const struct constant_folder_function *function,
                                  c205_word x, c205_word y);

#endif
