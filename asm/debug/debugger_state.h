/* debugger_state.h - where a debugger's program stands, and what its last instruction did, for
 * who shows that otherwise than in lines.
 */
#ifndef ASM_DEBUG_DEBUGGER_STATE_H
#define ASM_DEBUG_DEBUGGER_STATE_H

#include "asm/debug/debugger.h"

/* Instructions since the beginning: now, and the most that there were. */
uint64_t debugger_step(const struct debugger *debugger);
uint64_t debugger_known(const struct debugger *debugger);
/* Why the program cannot go on; NULL: it can. */
const c205_stop *debugger_halt(const struct debugger *debugger);
/* The last instruction with its time; NULL: there is none. */
const c205_event *debugger_last(const struct debugger *debugger);
/* What was in flight when the program ended with it; NULL: it has not, or there was nothing
 * to tell. */
const c205_times *debugger_end(const struct debugger *debugger);

/* The constant of the model that made a phase of the last instruction, a vector instruction;
 * NULL: no single one did. */
const c205_constant *debugger_constant(const struct debugger *debugger,
                                       c205_cause phase);
/* What a piece of time was spent to wait for; nothing: for nothing. */
void show_wait(const struct debugger *debugger, const c205_piece *piece,
               const struct sink *sink);
/* Why the program cannot go on, to the debugger's sink. */
void show_halt(struct debugger *debugger);

/* The name that the program gave a register last; "": none. */
const char *debug_register_name(const struct debugger *debugger, unsigned number);

/* From now on it stops where code of a source line begins, or of the next that has code:
 * which one that is.  False after telling why not.  All that were set so are forgotten
 * again at once. */
bool debugger_break_line(struct debugger *debugger, const char *file, size_t number,
                         size_t *line);
void debugger_forget_lines(struct debugger *debugger);

#endif
