/* cmd_isa.h - descriptions of an instruction, derived from its row in insn.def.
 *
 * Texts are constant and have one line. A missing description is an empty text, not
 * NULL.
 */
#ifndef ASM_CMD_ISA_H
#define ASM_CMD_ISA_H

#include "asm/command/session.h"
#include "vm/text.h"

/* Writes "82", or "9D.1" if bits of G belong to the operation. */
enum { ISA_CODE = 8 };
void isa_code(const c205_insn *insn, char text[ISA_CODE]);

/* Writes the fields of a format and their bits: "| F 8 | R 8 | I 16 |". */
enum { ISA_DRAWING = 64 };
void isa_drawing(const c205_insn *insn, char text[ISA_DRAWING]);

/* An operand, in the order of the syntax. */
struct isa_operand {
    const char *written; /* in the syntax of the format */
    int length;          /* characters of `written` */
    const char *meaning; /* NULL: the letter has no explanation */
};
/* Returns the next operand, or false after the last. *letter must be NULL at first. */
bool isa_next_operand(const c205_insn *insn, const char **letter,
                      struct isa_operand *operand);

/* A rule of an instruction, with its name in a terminal and in the reference. */
struct isa_rule {
    const char *name, *page_name;
    const char *text; /* NULL: it has no explanation */
};
/* The length, the continuation of a short source, the effect of a control vector,
 * special values, the operands with ",H", and notes. Rules that do not apply are
 * omitted. */
enum { MAX_ISA_RULES = 16, ISA_HALF = 200 };
struct isa_rules {
    size_t count;
    struct isa_rule rule[MAX_ISA_RULES];
    char half[ISA_HALF]; /* the text about ",H" */
};
void isa_list_rules(const c205_insn *insn, struct isa_rules *rules);

/* Describes the elements that the clock counts, if these are not the results. */
const char *isa_clocked(const c205_insn *insn);
const char *isa_provenance(char letter);

/* Returns the heading directly above the row in the reference, or NULL. */
const char *isa_family(const c205_insn *insn);

/* Returns a constant of the model, as for "startup", "vadd", or NULL. */
const c205_constant *isa_constant(const c205_model *model, const char *kind,
                                  const char *timing);
/* Returns the clocks per element of a stream. A stream that the pipes share is
 * faster for half words. */
double isa_per_element(const c205_model *model, const c205_constant *stream, bool half);

/* Returns the lines of a short example program, or NULL. */
const char *const *isa_example(const c205_insn *insn);

/* Prints the whole reference in Markdown on stdout, with the clocks of the model.
 * Returns CMD_FAILED if a row has no example or something unexplained. */
int isa_page(const char *command, const c205_model *model);

/* Prints a card of two pages for groff on stdout, with the clocks of the model. */
void isa_card(const c205_model *model);

/* Prints a TextMate grammar on stdout. Returns the exit code. */
int isa_grammar(const char *command);

#endif
