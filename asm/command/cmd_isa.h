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

/* Describe the number of elements, and the continuation of a short source. */
const char *isa_length(const c205_insn *insn);
const char *isa_padding(const c205_insn *insn);
/* Describes the elements that the clock counts, if these are not the results. */
const char *isa_clocked(const c205_insn *insn);
/* Describes the effect of the control vector on the elements it does not select. */
const char *isa_control(const c205_insn *insn);
/* Describes the results for machine zeros and indefinites, and out of range if the
 * general rule does not apply. */
const char *isa_specials(const c205_insn *insn);

/* Describes the operands with ",H"; empty if the instruction has no such form. */
enum { ISA_FIELDS = 16, ISA_HALF = 200 };
void isa_half(const c205_insn *insn, char text[ISA_HALF]);

/* Flags that isa_padding and isa_half describe. */
#define ISA_TOLD (C205_INSN_PADZ | C205_INSN_PADO | C205_INSN_HALF)
/* Describes another flag of a row. Returns NULL if it has no explanation. */
const char *isa_flag(const c205_insn *insn, unsigned flag);
/* Describes how the instruction can be linked; empty if it cannot. */
const char *isa_link(const c205_insn *insn);
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
