/* cmd_isa.h - what can be told of an instruction from its row in insn.def.
 *
 * The texts are constant and in one line; where there is nothing to tell,
 * they are empty, not NULL.
 */
#ifndef ASM_CMD_ISA_H
#define ASM_CMD_ISA_H

#include "asm/command/c205_command.h"
#include "vm/text.h"

/* "82", or "9D.1" where bits of G belong to the operation. */
enum { ISA_CODE = 8 };
void isa_code(const c205_insn *insn, char text[ISA_CODE]);

/* "| F 8 | R 8 | I 16 |": the fields of a format and their bits. */
enum { ISA_DRAWING = 64 };
void isa_drawing(const c205_insn *insn, char text[ISA_DRAWING]);

/* The operands as they are written, one after another. */
struct isa_operand {
    const char *written; /* in the syntax of the format .. */
    int length;          /* .. so many characters */
    const char *meaning; /* NULL: a letter that nobody has explained */
};
/* NULL as the first *letter: begin.  False: there are no more. */
bool isa_next_operand(const c205_insn *insn, const char **letter,
                      struct isa_operand *operand);

/* How many elements there are, and what a short source continues with. */
const char *isa_length(const c205_insn *insn);
const char *isa_padding(const c205_insn *insn);
/* Which elements the clock counts, where those are others. */
const char *isa_clocked(const c205_insn *insn);
/* What becomes of the elements that the control vector shuts out. */
const char *isa_control(const c205_insn *insn);
/* What becomes of machine zeros and indefinites, and of what is out of range
 * where that is not as everywhere. */
const char *isa_specials(const c205_insn *insn);

/* What becomes of the operands with ",H"; empty: the row has no such form. */
enum { ISA_FIELDS = 16, ISA_HALF = 200 };
void isa_half(const c205_insn *insn, char text[ISA_HALF]);

/* Flags that isa_padding and isa_half tell of. */
#define ISA_TOLD (C205_INSN_PADZ | C205_INSN_PADO | C205_INSN_HALF)
/* What another flag of a row means; NULL: nobody has explained it. */
const char *isa_flag(const c205_insn *insn, unsigned flag);
/* Whether it can be linked; empty: no. */
const char *isa_link(const c205_insn *insn);
const char *isa_provenance(char letter);

/* The heading of the reference that stands above the row; NULL: none does. */
const char *isa_family(const c205_insn *insn);

/* "startup", "vadd": that constant of the model, or NULL. */
const c205_constant *isa_constant(const c205_model *model, const char *kind,
                                  const char *timing);
/* Of a stream: clocks per element; one that the pipes share is faster for half
 * words. */
double isa_per_element(const c205_model *model, const c205_constant *stream, bool half);

/* The lines of a short program that shows it; NULL: there is none. */
const char *const *isa_example(const c205_insn *insn);

/* The whole reference in Markdown on stdout, with the clocks of the model.
 * CMD_FAILED where a row lacks an example or something unexplained. */
int isa_page(const char *command, const c205_model *model);

/* A card of two pages, for groff, on stdout, with the clocks of the model. */
void isa_card(const c205_model *model);

/* A TextMate grammar on stdout. */
int isa_grammar(const char *command);

#endif
