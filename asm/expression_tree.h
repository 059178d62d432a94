/* expression_tree.h - the inside of an expression: expression.c makes it of a text,
 * evaluate.c a value of it.  Not public.
 */
#ifndef ASM_EXPRESSION_TREE_H
#define ASM_EXPRESSION_TREE_H

#include "asm/constant_folder.h"
#include "asm/expression.h"

enum operation { VALUE, SYMBOL, UNARY, BINARY, BITS, WORD, FUNCTION };

struct expression {
    enum operation operation;
    int code; /* of an operator */
    unsigned depth;
    const char *at;
    struct value value;
    const struct symbol *symbol;
    const struct constant_folder_function *function;
    const struct expression *left, *right;
};

/* Of integers.  NULL, or what is wrong. */
const char *integer_operation(int code, int64_t a, int64_t b, uint64_t *result);
/* - ~ ! */
uint64_t integer_negation(int code, uint64_t a);

#endif
