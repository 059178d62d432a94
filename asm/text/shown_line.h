/* shown_line.h - the rule for the line at which an instruction of a macro is shown.
 *
 * Profiles, debuggers and timelines show each instruction at one line of the program:
 *
 *   An instruction is shown at the innermost line that is in the file of the outermost
 *   macro call, or in a formula. An instruction outside of all macros is shown at its
 *   line.
 *
 * An operation is a macro in scalar or vector form: scalar_form or vector_form of
 * asm/lib/forms.s defines it, or the name of its file ends in _scalar.s or _vector.s. A
 * formula is another macro that calls an operation, itself or through macros of its
 * file or of asm/lib. Macros of asm/lib are never formulas.
 *
 * If a kernel is written once for both forms, each of its lines therefore has the
 * clocks of the operations on the line. This is also true if the kernel is a macro of
 * another file. A macro without operations, such as one that loads a word, is shown at
 * its call in the kernel.
 */
#ifndef ASM_SHOWN_LINE_H
#define ASM_SHOWN_LINE_H

#include "asm/text/expand.h"

/* A macro call or .rept that produced lines. */
struct call {
    const struct line *line;
    const struct macro *macro; /* NULL: .rept */
    unsigned forms;            /* forms of the operations that are called, a set of enum
                                  asm_form */
};

/* Sets the properties of a macro that determine its shown lines: its file and form.
 * line is the first line of its definition. */
void shown_line_define(const struct expander *expander, const struct line *line,
                       struct macro *macro);
/* Records a macro call. The frame of the macro must be on top of the stack. */
void shown_line_call(const struct expander *expander);

/* Returns the line at which profiles and debuggers show the code of a line. */
const struct line *shown_line(const struct line *line);
/* Returns the line at which an error in a line is reported: the innermost line around it
 * that is not in a macro of asm/lib. */
const struct line *reported_line(const struct line *line);
/* Returns the outermost macro call that contains a line, or the line. */
const struct line *outermost_line(const struct line *line);
/* Returns the form of a line's code, scalar or vector. If operations were called
 * between the line and its shown line, it is the form of the innermost one; otherwise
 * it is that of the formula that contains the shown line. Returns ASM_NO_FORM if there
 * is neither, or if the formula calls operations of both forms. */
enum asm_form form_of_line(const struct line *line);

#endif
