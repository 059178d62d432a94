/* trap_report.h - why a program was stopped, as its author needs it: the line,
 * the rule that was broken, and what the operands held.
 */
#ifndef ASM_TRAP_REPORT_H
#define ASM_TRAP_REPORT_H

#include "asm/assemble.h"

/* Of a machine that a trap has stopped.  The object may be NULL; name is that
 * of the program, for objects that do not know their source lines. */
void trap_report(const struct object *object, const char *name, const c205 *machine,
                 const c205_stop *stop, const struct sink *sink);

/* What the operands of the instruction at an address hold, a line each; of a linked pair
 * those of both. */
void trap_report_operands(const c205 *machine, uint64_t pc, const struct sink *sink);

#endif
