/* statement.h - functions that the files of the parser share: they parse operands,
 * directives and expectations, and add items to the layout. */
#ifndef ASM_STATEMENT_H
#define ASM_STATEMENT_H

#include "asm/text/expression.h"

/* Adds an item of the given number of half words at the current address (layout.c). */
struct layout_item *layout_add(struct cursor *cursor, enum item_kind kind,
                               uint64_t halves);
/* Adds words with known values at the current address. */
bool layout_known(struct cursor *cursor, const c205_word *words, uint64_t count);
/* Aligns the current address. Labels that wait for data move with it. */
void layout_align(struct assembler *assembler, uint64_t bits);
bool layout_label(struct cursor *cursor, const char *name, size_t length,
                  const char *at);
void layout_resolve(struct assembler *assembler);

/* Parses a register or a half register, as a number or a name (operand.c). */
bool parse_any_register(struct cursor *cursor, struct register_name *found);
/* Parses a register that is not a half register. */
bool parse_register(struct cursor *cursor, uint8_t *number);
bool parse_instruction(struct cursor *cursor, const c205_insn *insn);

/* The function that parses a directive. find_directive returns NULL if a token is not
 * the name of a directive (directive.c). */
typedef bool directive_parser(struct cursor *cursor);
struct directive {
    const char *name;
    directive_parser *parse;
    enum asm_contents contents; /* type of its data; ASM_NOTHING: no data, so labels
                                   before it do not wait for an alignment */
};
const struct directive *find_directive(const struct token *token);

/* Defined in register.c. */
directive_parser parse_reg, parse_regs, parse_share, parse_endshare;
/* Records that an instruction uses a register by its name. */
bool mention_register(struct assembler *assembler, struct register_name named);

/* Defined in record.c. */
directive_parser parse_record, parse_field, parse_at, parse_endrecord;

/* Defined in incfile.c. */
directive_parser parse_incfile;

/* Parses the expectation in the comment of a line, if any (expectation.c). */
bool parse_expectation(struct cursor *cursor);

#endif
