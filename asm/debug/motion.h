/* motion.h - a debugger's program forward and back, for who does not speak to it in
 * lines.
 *
 * A motion tells what is wrong to the debugger's sink, once, and is MOVED_NOT then.  One that
 * the debugger's `interrupted` has ended, MOVED_INTERRUPTED, is where it has come to, by an
 * instruction at least, and continues from there if it is asked for again.
 */
#ifndef ASM_DEBUG_MOTION_H
#define ASM_DEBUG_MOTION_H

#include "asm/debug/debugger.h"

/* How one ended.  Of stops that were met stops_pass is still to be told. */
enum moved {
    MOVED_ON, /* as far as it was to go */
    MOVED_TO_STOP,
    MOVED_TO_HALT,  /* the program has ended, or a trap */
    MOVED_TO_START, /* there is no way farther back */
    MOVED_INTERRUPTED,
    MOVED_TOO_FAR,
    MOVED_NOT
};

/* Those that were met have been, and what is once is over.  With a word of each, or
 * without. */
void stops_pass(struct debugger *debugger, bool reported);

enum moved motion_steps(struct debugger *debugger, uint64_t count);
/* One instruction, a call and all that it does being one. */
enum moved motion_next(struct debugger *debugger);
/* Whether the next instruction is a call, and where that comes back to. */
bool motion_is_call(const struct debugger *debugger, uint64_t *behind);
/* The same, a macro call being one as well. */
enum moved motion_line(struct debugger *debugger);
/* On to an address, behind one instruction at least. */
enum moved motion_to(struct debugger *debugger, uint64_t address);
/* .. to where a caller says so. */
enum moved motion_until(struct debugger *debugger,
                        bool (*is_there)(void *context, const c205 *machine),
                        void *context);
/* Out of the macro call in which the program stands, or else out of its region; it must
 * be in one. */
bool motion_can_go_out(struct debugger *debugger);
enum moved motion_out(struct debugger *debugger);
enum moved motion_run(struct debugger *debugger); /* from the beginning */
enum moved motion_back(struct debugger *debugger, uint64_t count);
/* To the beginning of a macro call, if that is where it comes from. */
enum moved motion_back_line(struct debugger *debugger);
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
enum moved motion_search_back(struct debugger *debugger, struct back_search *search);
enum moved motion_back_to_stop(struct debugger *debugger);
/* Wherever that is, without a look at stops; a clock: to the first step that has it
 * or more behind it. */
enum moved motion_to_step(struct debugger *debugger, uint64_t step);
enum moved motion_to_clock(struct debugger *debugger, uint64_t clock);

#endif
