/* runtime_check.h - checks a program while it runs. It finds legal operations that are
 * probably mistakes and that the assembler cannot detect (asm/object/warning.def).
 *
 * The operands of each instruction are examined before it is executed. Expensive checks
 * run at the first 16 executions, then at the 32nd, the 64th and so on. Each warning is
 * reported once for a source line. The checks change neither results nor clocks.
 */
#ifndef ASM_RUNTIME_CHECK_H
#define ASM_RUNTIME_CHECK_H

#include "asm/object/object.h"

struct runtime_checker;

/* Returns a checker, or NULL if memory is exhausted. The object and the choice must
 * outlive it, and so must the report, to which each warning is printed; NULL: none. name
 * is the name of the program, which is printed if there are no source lines. */
struct runtime_checker *runtime_new(const struct object *object, const char *name,
                                    const struct warning_choice *choice,
                                    const struct sink *report);
void runtime_free(struct runtime_checker *watch);

/* Prepares the checks. Must be called before a machine with the program starts, and
 * after a machine was restored. */
void runtime_begin(struct runtime_checker *watch, const c205 *machine);
/* Checks each instruction while the program runs. The context is the struct
 * runtime_checker. */
c205_listener runtime_listen;

/* Returns the warnings that occurred, including those that the program declares as
 * intended. */
warning_set runtime_warned(const struct runtime_checker *watch);
/* Returns the number of warnings that count as errors. */
size_t runtime_errors(const struct runtime_checker *watch);
/* Returns the reported warnings in the order of their occurrence. */
const struct diagnostics *runtime_found(const struct runtime_checker *watch);
/* Removes all reported warnings after the first `count`, so they can be reported
 * again. */
void runtime_forget(struct runtime_checker *watch, size_t count);

#endif
