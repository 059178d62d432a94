/* expression_tree.h - the tree of an expression. expression.c builds it, and evaluate.c
 * evaluates it. Not public.
 */
#ifndef ASM_EXPRESSION_TREE_H
#define ASM_EXPRESSION_TREE_H

#include "asm/text/constant_folder.h"
#include "asm/text/expression.h"
#include "asm/text/operators.h"

enum operation { VALUE, SYMBOL, UNARY, BINARY, BITS, WORD, FUNCTION };

struct expression {
    enum operation operation;
    int code; /* code of an operator */
    unsigned depth;
    const char *at;
    struct value value;
    const struct symbol *symbol;
    const struct constant_folder_function *function;
    const struct expression *left, *right;
};

#endif
