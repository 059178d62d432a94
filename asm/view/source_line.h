/* source_line.h - prints the source line of an instruction, for debuggers and
 * timelines. */
#ifndef ASM_SOURCE_LINE_H
#define ASM_SOURCE_LINE_H

#include "asm/object/object.h"

/* Prints FILE:LINE, without the folder of the file. */
void source_line_place(const struct asm_place *place, const struct sink *sink);
/* Prints the line at which an instruction is shown, as in "torus.s:41 (vector): plus a,
 * b, c". The form is omitted if there is none. */
void source_line_shown(const struct asm_line *line, const struct sink *sink);
/* Prints the innermost line of a macro that contains an instruction. */
void source_line_innermost(const struct asm_line *line, const struct sink *sink);

#endif
