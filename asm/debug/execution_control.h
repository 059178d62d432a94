/* execution_control.h - executes the program of a debugger forward and back, for
 * callers that do not use command lines.
 *
 * Each function reports an error once, to the debugger's sink, and returns
 * EXECUTION_FAILED. If the debugger's `interrupted` ends it, it returns
 * EXECUTION_INTERRUPTED after at least one instruction. The program is then where it
 * was interrupted; another call of the function continues from there.
 */
#ifndef ASM_DEBUG_EXECUTION_CONTROL_H
#define ASM_DEBUG_EXECUTION_CONTROL_H

#include "asm/debug/debugger.h"

/* How an execution ended. After EXECUTION_AT_STOP the caller must call
 * breakpoints_pass. */
enum execution_end {
    EXECUTION_COMPLETE, /* as far as requested */
    EXECUTION_AT_STOP,
    EXECUTION_HALTED,   /* the program has ended or trapped */
    EXECUTION_AT_START, /* at the first step, no step is before it */
    EXECUTION_INTERRUPTED,
    EXECUTION_OUT_OF_RANGE,
    EXECUTION_FAILED
};

/* Acknowledges the stops that were met and deletes those with `once`. reported: reports
 * each of them first. */
void breakpoints_pass(struct debugger *debugger, bool reported);

enum execution_end execution_steps(struct debugger *debugger, uint64_t count);
/* Executes one instruction; a call counts as one, to its return. */
enum execution_end execution_next(struct debugger *debugger);
/* Returns whether the next instruction is a call, and its return address. */
bool execution_is_call(const struct debugger *debugger, uint64_t *behind);
/* Like execution_next; a macro call counts as one instruction too. */
enum execution_end execution_line(struct debugger *debugger);
/* Executes at least one instruction, and ends at an address. */
enum execution_end execution_to(struct debugger *debugger, uint64_t address);
/* Executes at least one instruction, and ends when is_there returns true. */
enum execution_end execution_until(struct debugger *debugger,
                                   bool (*is_there)(void *context, const c205 *machine),
                                   void *context);
/* Leaves the current macro call, or the current region if there is none.
 * execution_can_go_out reports an error and returns false if there is neither. */
bool execution_can_go_out(struct debugger *debugger);
enum execution_end execution_out(struct debugger *debugger);
enum execution_end execution_run(struct debugger *debugger); /* from the beginning */
enum execution_end execution_back(struct debugger *debugger, uint64_t count);
/* Goes one instruction back, or to the start of the macro call that contains that
 * instruction. */
enum execution_end execution_back_line(struct debugger *debugger);
/* The state of a search back to the last stop before the current step. It must be zero
 * at the start. If the search is interrupted the program is at an arbitrary step; the
 * caller keeps the state and calls again to continue. */
struct back_search {
    bool begun;
    uint64_t end;     /* stops before this step are searched */
    uint64_t stretch; /* steps of the current interval */
    bool inside;      /* the interval is partly replayed */
    uint64_t begin;   /* first step of the interval */
    uint64_t found;   /* last stop found in the interval; 0: none */
};
enum execution_end execution_search_back(struct debugger *debugger,
                                         struct back_search *search);
enum execution_end execution_back_to_stop(struct debugger *debugger);
/* Goes to a step, or to the first step at or after a clock, forward or back. Stops are
 * not checked. */
enum execution_end execution_to_step(struct debugger *debugger, uint64_t step);
enum execution_end execution_to_clock(struct debugger *debugger, uint64_t clock);

#endif
