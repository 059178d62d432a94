/* execution_control.h - a debugger's program forward and back, for who does not speak to it in
 * lines.
 *
 * A motion tells what is wrong to the debugger's sink, once, and is EXECUTION_FAILED then.  One that
 * the debugger's `interrupted` has ended, EXECUTION_INTERRUPTED, is where it has come to, by an
 * instruction at least, and continues from there if it is asked for again.
 */
#ifndef ASM_DEBUG_EXECUTION_CONTROL_H
#define ASM_DEBUG_EXECUTION_CONTROL_H

#include "asm/debug/debugger.h"

/* How one ended.  Of stops that were met breakpoints_pass is still to be told. */
enum execution_end {
    EXECUTION_COMPLETE, /* as far as it was to go */
    EXECUTION_AT_STOP,
    EXECUTION_HALTED,   /* the program has ended, or a trap */
    EXECUTION_AT_START, /* there is no way farther back */
    EXECUTION_INTERRUPTED,
    EXECUTION_OUT_OF_RANGE,
    EXECUTION_FAILED
};

/* Those that were met have been, and what is once is over.  With a word of each, or
 * without. */
void breakpoints_pass(struct debugger *debugger, bool reported);

enum execution_end execution_steps(struct debugger *debugger, uint64_t count);
/* One instruction, a call and all that it does being one. */
enum execution_end execution_next(struct debugger *debugger);
/* Whether the next instruction is a call, and where that comes back to. */
bool execution_is_call(const struct debugger *debugger, uint64_t *behind);
/* The same, a macro call being one as well. */
enum execution_end execution_line(struct debugger *debugger);
/* On to an address, behind one instruction at least. */
enum execution_end execution_to(struct debugger *debugger, uint64_t address);
/* .. to where a caller says so. */
enum execution_end execution_until(struct debugger *debugger,
                                   bool (*is_there)(void *context, const c205 *machine),
                                   void *context);
/* Out of the macro call in which the program stands, or else out of its region; it must
 * be in one. */
bool execution_can_go_out(struct debugger *debugger);
enum execution_end execution_out(struct debugger *debugger);
enum execution_end execution_run(struct debugger *debugger); /* from the beginning */
enum execution_end execution_back(struct debugger *debugger, uint64_t count);
/* To the beginning of a macro call, if that is where it comes from. */
enum execution_end execution_back_line(struct debugger *debugger);
/* To the stop before this place.  The search is zero when it begins, and is kept by who continues
 * with one that was interrupted: that stands anywhere. */
struct back_search {
    bool begun;
    uint64_t end;     /* stops before this step are looked for .. */
    uint64_t stretch; /* .. from so many back */
    bool inside;      /* a stretch has been begun .. */
    uint64_t begin;   /* .. there .. */
    uint64_t found;   /* .. and this is the last stop in it; 0: none */
};
enum execution_end execution_search_back(struct debugger *debugger,
                                         struct back_search *search);
enum execution_end execution_back_to_stop(struct debugger *debugger);
/* Wherever that is, without a look at stops; a clock: to the first step that has it
 * or more behind it. */
enum execution_end execution_to_step(struct debugger *debugger, uint64_t step);
enum execution_end execution_to_clock(struct debugger *debugger, uint64_t clock);

#endif
