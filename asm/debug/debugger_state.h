/* debugger_state.h - the state of the debugged program, for callers that format it: its
 * step, its last instruction and the reason of its halt. */
#ifndef ASM_DEBUG_DEBUGGER_STATE_H
#define ASM_DEBUG_DEBUGGER_STATE_H

#include "asm/debug/debugger.h"

/* debugger_step returns the number of instructions since the start. debugger_known
 * returns the largest such number so far. */
uint64_t debugger_step(const struct debugger *debugger);
uint64_t debugger_known(const struct debugger *debugger);
/* Returns the reason for which the program cannot continue, or NULL if it can. */
const c205_stop *debugger_halt(const struct debugger *debugger);
/* Returns the last instruction with its times, or NULL if there is none. */
const c205_event *debugger_last(const struct debugger *debugger);
/* Returns the times of the results in flight at the end of the program. Returns NULL if
 * the program has not ended with the last instruction or if there is no record. */
const c205_times *debugger_end(const struct debugger *debugger);

/* Returns the constant of the model that determines the length of a phase of the last
 * vector instruction. NULL: no single constant does. */
const c205_constant *debugger_constant(const struct debugger *debugger,
                                       c205_cause phase);
/* Prints the reason for a piece of waiting time. Prints nothing for other pieces. */
void show_wait(const struct debugger *debugger, const c205_piece *piece,
               const struct sink *sink);
/* Prints the reason for which the program cannot continue. */
void show_halt(struct debugger *debugger);
/* Returns what the debugger has reported to the buffer, without the prefix "error: "
 * and the last newline. The text is valid until the buffer changes. */
const char *debugger_report(struct text_buffer *said);

/* Sets a breakpoint at a source line or at the next line that has code, and sets *line
 * to that line. Reports an error and returns false if there is none.
 * debugger_forget_lines deletes all breakpoints that this function has set. */
bool debugger_break_line(struct debugger *debugger, const char *file, size_t number,
                         size_t *line);
void debugger_forget_lines(struct debugger *debugger);

#endif
