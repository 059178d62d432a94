/* breakpoints.h - break and watch points of a machine; see c205.h. */
#ifndef C205_STOPS_H
#define C205_STOPS_H

#include "vm/machine.h"

/* What is watched is from now on as it is. */
void machine_sample_watchpoints(struct c205 *machine);
/* Behind an instruction: NONE, or the trap of the stop that was met, and its address. */
c205_trap machine_hits_breakpoint(struct c205 *machine, uint64_t *address);
void machine_free_breakpoints(struct machine_breakpoints *breakpoints);

/* Whether a run ended with it behind an instruction that was done. */
static inline bool trap_is_behind(c205_trap trap)
{
    return trap == C205_TRAP_PAUSED || trap == C205_TRAP_BREAKPOINT
           || trap == C205_TRAP_WATCHPOINT;
}

#endif
