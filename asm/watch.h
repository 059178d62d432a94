/* watch.h - looks at a program while it runs, for what is no trap but hardly
 * meant: the warnings of asm/warning.def that a text does not show.
 *
 * It looks at the operands of each instruction before it is executed, in full
 * the first 16 times and then the 32nd, the 64th ..; each warning is told once
 * for a source line.  It changes nothing: results and clocks are those of a
 * program that nobody watches.
 */
#ifndef ASM_WATCH_H
#define ASM_WATCH_H

#include "asm/assemble.h"

struct program_watch;

/* The object and the choice must outlive it.  name is that of the program, for
 * objects that do not know their source lines.  NULL: no memory. */
struct program_watch *watch_new(const struct object *object, const char *name,
                                const struct warning_choice *choice,
                                const struct sink *report);
void watch_free(struct program_watch *watch);

/* Before a machine with the program runs, and after it was restored. */
void watch_begin(struct program_watch *watch, const c205 *machine);
/* The listener; its context is the watch. */
c205_listener watch_listen;

/* What it warned of, the program's own expectations included. */
warning_set watch_warned(const struct program_watch *watch);
/* How many of them are errors. */
size_t watch_errors(const struct program_watch *watch);

#endif
