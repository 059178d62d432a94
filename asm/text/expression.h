/* expression.h - parses and evaluates expressions, whose value may depend on labels
 * that are defined later.
 *
 * Integers have 64 bits, with C's operators and precedence; sums, differences and
 * products wrap. An operation with a floating-point number has a floating-point result,
 * computed by the machine's arithmetic. The bits of a word X'..' count as an integer,
 * except in an operation with a floating-point number, where X'..' counts as the word.
 */
#ifndef ASM_EXPRESSION_H
#define ASM_EXPRESSION_H

#include "asm/text/lex.h"

struct expression;

/* Parses an expression. After an error it reports the error and returns NULL. */
const struct expression *parse_expression(struct cursor *cursor);

bool evaluate(struct assembler *assembler, const struct line *line,
              const struct expression *expression, struct value *value);
/* Evaluates an expression to an integer. A floating-point number is an error. */
bool evaluate_integer(struct assembler *assembler, const struct line *line,
                      const struct expression *expression, int64_t *integer);
/* Evaluates an expression to an integer from low to high. `what` describes the integer
 * in an error. */
bool evaluate_range(struct assembler *assembler, const struct line *line,
                    const struct expression *expression, int64_t low, int64_t high,
                    const char *what, int64_t *integer);
/* Evaluates an expression to a word of memory. An integer becomes a number with
 * exponent 0. */
bool evaluate_word(struct assembler *assembler, const struct line *line,
                   const struct expression *expression, c205_word *word);
/* Evaluates an expression to a half word, left-aligned in *half. An integer becomes a
 * number with exponent 0. A word must fit 32 bits. */
bool evaluate_half(struct assembler *assembler, const struct line *line,
                   const struct expression *expression, c205_word *half);
bool evaluate_address(struct assembler *assembler, const struct line *line,
                      const struct expression *expression, uint64_t *address);

/* Parse and evaluate an expression of symbols that are already defined. */
bool parse_value(struct cursor *cursor, struct value *value);
bool parse_integer(struct cursor *cursor, int64_t low, int64_t high, const char *what,
                   int64_t *integer);

#endif
