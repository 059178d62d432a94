/* statement.h - what the files of the parser share. */
#ifndef ASM_STATEMENT_H
#define ASM_STATEMENT_H

#include "asm/expression.h"

/* layout.c: where things go. */
struct layout_item *layout_add(struct cursor *cursor, enum item_kind kind,
                               uint64_t halves);
/* Words that are known already. */
bool layout_known(struct cursor *cursor, const c205_word *words, uint64_t count);
/* Data begin on words; labels that wait for them go along. */
void layout_align(struct assembler *assembler, uint64_t bits);
bool layout_label(struct cursor *cursor, const char *name, size_t length,
                  const char *at);
void layout_resolve(struct assembler *assembler);

/* operand.c */
bool parse_any_register(struct cursor *cursor, struct register_name *found);
/* A whole one. */
bool parse_register(struct cursor *cursor, uint8_t *number);
bool parse_instruction(struct cursor *cursor, const c205_insn *insn);

/* directive.c: NULL: there is none of this name. */
typedef bool directive_parser(struct cursor *cursor);
struct directive {
    const char *name;
    directive_parser *parse;
    enum asm_contents contents; /* of what it puts, before which labels wait for its
                                   alignment; or NOTHING */
};
const struct directive *find_directive(const struct token *token);

/* register.c */
directive_parser parse_reg, parse_regs, parse_share, parse_endshare;
/* An instruction has it. */
bool mention_register(struct assembler *assembler, struct register_name named);

/* record.c */
directive_parser parse_record, parse_field, parse_at, parse_endrecord;

/* incfile.c */
directive_parser parse_incfile;

/* expectation.c: the expectation in the comment at the end of a line, if any. */
bool parse_expectation(struct cursor *cursor);

#endif
