/* expression.h - values that may depend on labels still to come.
 *
 * Integers of 64 bits with C's operators and precedence; sums, differences
 * and products wrap.  With floating-point numbers the result is one, as the machine
 * computes it; the bits of an X'..' word take part as an integer, in a sum with
 * floating-point numbers as the word.
 */
#ifndef ASM_EXPRESSION_H
#define ASM_EXPRESSION_H

#include "asm/lex.h"

struct expression;

/* NULL: reported. */
const struct expression *parse_expression(struct cursor *cursor);

bool evaluate(struct assembler *assembler, const struct line *line,
              const struct expression *expression, struct value *value);
/* An integer; a floating-point number is an error. */
bool evaluate_integer(struct assembler *assembler, const struct line *line,
                      const struct expression *expression, int64_t *integer);
/* An integer from low to high; what names it in the error. */
bool evaluate_range(struct assembler *assembler, const struct line *line,
                    const struct expression *expression, int64_t low, int64_t high,
                    const char *what, int64_t *integer);
/* As a word of memory: an integer has exponent 0. */
bool evaluate_word(struct assembler *assembler, const struct line *line,
                   const struct expression *expression, c205_word *word);
/* As a half word, at the left of *half: an integer has exponent 0, of a word
 * 32 bits are left. */
bool evaluate_half(struct assembler *assembler, const struct line *line,
                   const struct expression *expression, c205_word *half);
bool evaluate_address(struct assembler *assembler, const struct line *line,
                      const struct expression *expression, uint64_t *address);

/* Parse and evaluate with the symbols known so far. */
bool parse_value(struct cursor *cursor, struct value *value);
bool parse_integer(struct cursor *cursor, int64_t low, int64_t high, const char *what,
                   int64_t *integer);

#endif
