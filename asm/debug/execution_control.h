/* execution_control.h - executes the program of a debugger forward and back, for
 * callers that do not use debugger commands.
 *
 * Each function reports an error once, to the debugger's sink, and returns
 * EXECUTION_FAILED. It returns EXECUTION_INTERRUPTED if the member `interrupted` of the
 * debugger ended it, after at least one instruction. Another call then continues at the
 * point of the interruption.
 */
#ifndef ASM_DEBUG_EXECUTION_CONTROL_H
#define ASM_DEBUG_EXECUTION_CONTROL_H

#include "asm/debug/debugger.h"

/* The ends of an execution. After EXECUTION_AT_STOP the caller must call
 * breakpoints_pass. */
enum execution_end {
    EXECUTION_COMPLETE, /* executed as far as requested */
    EXECUTION_AT_STOP,
    EXECUTION_HALTED,   /* the program has ended or trapped */
    EXECUTION_AT_START, /* at the first step */
    EXECUTION_INTERRUPTED,
    EXECUTION_OUT_OF_RANGE,
    EXECUTION_FAILED
};

/* Acknowledges the breakpoints that stopped the program, and deletes those whose member
 * `once` is set. If reported is true, each is first reported. */
void breakpoints_pass(struct debugger *debugger, bool reported);

enum execution_end execution_steps(struct debugger *debugger, uint64_t count);
/* Executes one instruction. A call counts as one instruction and is executed up to its
 * return. */
enum execution_end execution_next(struct debugger *debugger);
/* Returns true if the next instruction is a call. Sets *behind to its return
 * address. */
bool execution_is_call(const struct debugger *debugger, uint64_t *behind);
/* Like execution_next, but the instructions of one expansion of a line, such as a macro
 * call, count as one instruction. */
enum execution_end execution_line(struct debugger *debugger);
/* Executes at least one instruction, up to an address. */
enum execution_end execution_to(struct debugger *debugger, uint64_t address);
/* Executes at least one instruction, until is_there returns true. */
enum execution_end execution_until(struct debugger *debugger,
                                   bool (*is_there)(void *context, const c205 *machine),
                                   void *context);
/* Leaves the current outermost macro call, or the current region if there is no call.
 * execution_can_go_out reports an error and returns false if there is neither. */
bool execution_can_go_out(struct debugger *debugger);
enum execution_end execution_out(struct debugger *debugger);
enum execution_end execution_run(struct debugger *debugger); /* from the start */
enum execution_end execution_back(struct debugger *debugger, uint64_t count);
/* Goes back by one instruction. If this is within the expansion of a line, goes back to
 * the first instruction of the expansion. */
enum execution_end execution_back_line(struct debugger *debugger);
/* The state of a search back to the last stop before the current step. It must be zero
 * at the start. After an interruption the program is at an arbitrary step. Another call
 * with the same state continues the search. */
struct back_search {
    bool begun;
    uint64_t end;     /* the search covers steps before this step */
    uint64_t stretch; /* length of the current interval in steps */
    bool inside;      /* the interval is partly replayed */
    uint64_t begin;   /* first step of the interval */
    uint64_t found;   /* last step with a breakpoint in the interval; 0: none */
};
enum execution_end execution_search_back(struct debugger *debugger,
                                         struct back_search *search);
enum execution_end execution_back_to_stop(struct debugger *debugger);
/* Goes forward or back to a step, or to the first step at or after a clock, without
 * checking for breakpoints. */
enum execution_end execution_to_step(struct debugger *debugger, uint64_t step);
enum execution_end execution_to_clock(struct debugger *debugger, uint64_t clock);

#endif
