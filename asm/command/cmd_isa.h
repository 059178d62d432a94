/* cmd_isa.h - descriptions of an instruction, derived from its row in insn.def.
 *
 * Texts are constant and have one line. A missing description is an empty text.
 */
#ifndef ASM_CMD_ISA_H
#define ASM_CMD_ISA_H

#include "asm/command/session.h"
#include "vm/text.h"

/* Writes the operation code, as in "82", or as in "9D.1" if bits of G belong to the
 * code. */
enum { ISA_CODE = 8 };
void isa_code(const c205_insn *insn, char text[ISA_CODE]);

/* Writes the fields of an instruction format with their numbers of bits, as in "| F 8 |
 * R 8 | I 16 |". */
enum { ISA_DRAWING = 64 };
void isa_drawing(const c205_insn *insn, char text[ISA_DRAWING]);

/* One operand in the syntax of an instruction, as isa_next_operand returns it. */
struct isa_operand {
    const char *written; /* text in the syntax of the format */
    int length;          /* number of characters of `written` */
    const char *meaning; /* NULL: the letter has no explanation */
};
/* Returns the next operand; false: there are no more. *letter must be NULL before the
 * first call. */
bool isa_next_operand(const c205_insn *insn, const char **letter,
                      struct isa_operand *operand);

/* A rule of an instruction. Its name in the terminal differs from its name in the
 * reference. */
struct isa_rule {
    const char *name, *page_name;
    const char *text; /* NULL: it has no explanation */
};
/* The rules of an instruction: length, padding of a short source, effect of a control
 * vector, special values, the operands with ",H", and notes. Rules that do not apply
 * are omitted. */
enum { MAX_ISA_RULES = 16, ISA_HALF = 200 };
struct isa_rules {
    size_t count;
    struct isa_rule rule[MAX_ISA_RULES];
    char half[ISA_HALF]; /* the text about ",H" */
};
void isa_list_rules(const c205_insn *insn, struct isa_rules *rules);

/* isa_clocked returns the meaning of n in the formula of the clocks, or "" if n is the
 * number of results. isa_provenance returns the meaning of a letter of the column
 * "source". */
const char *isa_clocked(const c205_insn *insn);
const char *isa_provenance(char letter);

/* Returns the heading that precedes the row of an instruction in the reference, or
 * NULL. */
const char *isa_family(const c205_insn *insn);

/* Returns a constant of the model by its kind and class, such as "startup" and "vadd",
 * or NULL. */
const c205_constant *isa_constant(const c205_model *model, const char *kind,
                                  const char *timing);
/* Returns the clocks per element. `stream` is a constant stream.NAME of the model. If
 * its unit contains "*pipe", its value is divided by the number of pipes, and half
 * words are faster than words. */
double isa_per_element(const c205_model *model, const c205_constant *stream, bool half);

/* Returns the lines of a short example program, or NULL. */
const char *const *isa_example(const c205_insn *insn);

/* Prints the reference in Markdown on stdout, with the clocks of the model. Returns
 * CMD_FAILED if a row has no example or has an operand or flag without an
 * explanation. */
int isa_page(const char *command, const c205_model *model);

/* Prints a card of two pages for groff on stdout, with the clocks of the model. */
void isa_card(const c205_model *model);

/* Prints a TextMate grammar on stdout. Returns the exit code. */
int isa_grammar(const char *command);

#endif
