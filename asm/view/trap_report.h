/* trap_report.h - reports why a program stopped: the line, the rule that was broken,
 * and the values of the operands.
 */
#ifndef ASM_TRAP_REPORT_H
#define ASM_TRAP_REPORT_H

#include "asm/object/object.h"

/* Adds the trap that stopped a machine to the diagnostics: the line and the violated
 * rule. object may be NULL. name is the name of the program, for objects without source
 * lines. */
void trap_diagnose(const struct object *object, const char *name, const c205 *machine,
                   const c205_stop *stop, struct diagnostics *diagnostics);
/* Reports the trap and the values of the operands. */
void trap_report(const struct object *object, const char *name, const c205 *machine,
                 const c205_stop *stop, const struct sink *sink);

/* Prints a line for each operand of the instruction at an address, or of both
 * instructions of a linked pair. Registers that the instruction names have their names,
 * as in "x (r10)". object may be NULL. */
void trap_report_operands(const struct object *object, const c205 *machine, uint64_t pc,
                          const struct sink *sink);

#endif
