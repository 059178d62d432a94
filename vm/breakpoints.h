/* breakpoints.h - checks after each instruction whether a breakpoint or watchpoint
 * stops the run; see c205_machine.h. */
#ifndef C205_BREAKPOINTS_H
#define C205_BREAKPOINTS_H

#include "vm/machine.h"

/* Copies the watched words. Later checks compare memory with these copies. */
void machine_sample_watchpoints(struct c205 *machine);
/* Checks for breakpoints and watchpoints after an instruction. Returns C205_TRAP_NONE,
 * or the trap with its *address. */
c205_trap machine_hits_breakpoint(struct c205 *machine, uint64_t *address);
void machine_free_breakpoints(struct machine_breakpoints *breakpoints);

/* Returns true for a trap that ends a run after a completed instruction. */
static inline bool trap_is_behind(c205_trap trap)
{
    return trap == C205_TRAP_PAUSED || trap == C205_TRAP_BREAKPOINT
           || trap == C205_TRAP_WATCHPOINT;
}

#endif
