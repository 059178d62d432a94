/* debug_internal.h - the verbs of a debugger, and what they share.  Not public.
 *
 * A verb gets the rest of its line; each part reads of it what it knows, by a
 * struct rest that moves on.
 */
#ifndef ASM_DEBUG_DEBUG_INTERNAL_H
#define ASM_DEBUG_DEBUG_INTERNAL_H

#include "asm/debug/engine.h"

/* move.c */
debug_verb verb_step, verb_next, verb_continue, verb_reverse_step,
    verb_reverse_continue, verb_until, verb_goto, verb_run;
/* breaks.c */
debug_verb verb_break, verb_tbreak, verb_watch, verb_delete;
/* show.c */
debug_verb verb_where, verb_list, verb_disassemble;
/* print.c */
debug_verb verb_assert, verb_x;
/* info.c */
debug_verb verb_info;
/* time.c */
debug_verb verb_why, verb_account;

/* Step, clock and region, then the next instruction: where the program stands, or that it has ended. */
void show_place(struct debugger *debugger);
/* An instruction, and its source line if it is known. */
void show_instruction(struct debugger *debugger, uint64_t address, const char *before);

#endif
