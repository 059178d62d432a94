/* runtime_check.h - looks at a program while it runs, for what is no trap but hardly
 * meant: the warnings of asm/warning.def that a text does not show.
 *
 * It looks at the operands of each instruction before it is executed, in full
 * the first 16 times and then the 32nd, the 64th ..; each warning is told once
 * for a source line.  It changes nothing: results and clocks are those of a
 * program that nobody watches.
 */
#ifndef ASM_RUNTIME_CHECK_H
#define ASM_RUNTIME_CHECK_H

#include "asm/assemble.h"

struct runtime_checker;

/* The object and the choice must outlive it.  name is that of the program, for
 * objects that do not know their source lines.  NULL: no memory. */
struct runtime_checker *runtime_new(const struct object *object, const char *name,
                                    const struct warning_choice *choice,
                                    const struct sink *report);
void runtime_free(struct runtime_checker *watch);

/* Before a machine with the program runs, and after it was restored. */
void runtime_begin(struct runtime_checker *watch, const c205 *machine);
/* The listener; its context is the watch. */
c205_listener runtime_listen;

/* What it warned of, the program's own expectations included. */
warning_set runtime_warned(const struct runtime_checker *watch);
/* How many of them are errors. */
size_t runtime_errors(const struct runtime_checker *watch);

#endif
