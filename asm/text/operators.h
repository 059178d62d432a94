/* operators.h - the operators of expressions, with the same precedence as in C. The
 * assembler and the debugger share them.
 */
#ifndef ASM_OPERATORS_H
#define ASM_OPERATORS_H

#include <stddef.h>
#include <stdint.h>

/* The code of an operator of two characters. An operator of one character has that
 * character as its code. */
#define OPERATOR(first, second) ((first) | (second) << 8)

/* Returns the code and the length of the binary operator at the start of a text, or 0
 * if there is none. */
int operator_at(const char *text, size_t *length);
/* Returns the precedence of a binary operator. A higher precedence binds more tightly.
 * Returns 0 if the code is not a binary operator. */
int operator_precedence(int code);

/* Computes a binary operation on integers of 64 bits. Sums, differences and products
 * wrap. Returns NULL, or the text of an error. */
const char *integer_operation(int code, int64_t a, int64_t b, uint64_t *result);
/* Computes the unary operation -, ~ or !. */
uint64_t integer_negation(int code, uint64_t a);

#endif
