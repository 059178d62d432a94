/* shown_line.h - the rule for the line at which an instruction of a macro is shown.
 *
 * Profiles, debuggers and timelines show each instruction at one line of the program:
 *
 *   An instruction is shown at the innermost line that is in the file of the outermost
 *   macro call, or in a formula. An instruction outside of all macros is shown at its
 *   line.
 *
 * An operation is a macro that scalar_form or vector_form of asm/lib/forms.s defines,
 * or a macro of a file whose name ends in _scalar.s or _vector.s. It has this form. A
 * formula is another macro that calls an operation, itself or through macros of its file
 * or of asm/lib. Macros of asm/lib are no formulas.
 *
 * So a line of a kernel that is written once has the clocks of its operations, even if
 * the kernel is a macro of another file. A macro that loads a word for many kernels is
 * shown where a kernel calls it.
 */
#ifndef ASM_SHOWN_LINE_H
#define ASM_SHOWN_LINE_H

#include "asm/text/expand.h"

/* A call of a macro or a .rept, which produced lines. */
struct call {
    const struct line *line;
    const struct macro *macro; /* NULL: .rept */
    unsigned forms;            /* forms of the operations that are called, a set of enum
                                  asm_form */
};

/* Sets the form and the other properties of a macro for the rule. It is defined at a
 * line. */
void shown_line_define(const struct expander *expander, const struct line *line,
                       struct macro *macro);
/* Records the call of a macro, whose frame is on top of the stack. */
void shown_line_call(const struct expander *expander);

/* Returns the line at which a line is shown. */
const struct line *shown_line(const struct line *line);
/* Returns the outermost macro call that contains a line, or the line. */
const struct line *outermost_line(const struct line *line);
/* Returns the form of the operation that contains a line, within the line at which it is
 * shown, or of the formula that contains the shown line. Returns ASM_NO_FORM if there is
 * none, or if the formula calls operations of both forms. */
enum asm_form form_of_line(const struct line *line);

#endif
