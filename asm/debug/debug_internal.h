/* debug_internal.h - the verbs of the debugger and their shared functions. Not public.
 *
 * A verb receives the rest of its line as a struct text_cursor. Each reading function
 * advances the cursor past the text that it has read.
 */
#ifndef ASM_DEBUG_DEBUG_INTERNAL_H
#define ASM_DEBUG_DEBUG_INTERNAL_H

#include "asm/debug/debugger_engine.h"

/* step_verbs.c */
debug_verb verb_step, verb_next, verb_continue, verb_reverse_step,
    verb_reverse_continue, verb_until, verb_goto, verb_run;
/* break_verbs.c */
debug_verb verb_break, verb_tbreak, verb_watch, verb_delete;
/* show.c */
debug_verb verb_where, verb_list, verb_disassemble;
/* print.c */
debug_verb verb_assert, verb_x;
/* info.c */
debug_verb verb_info;
/* time.c */
debug_verb verb_why, verb_account;

/* Prints the current location: step, clock, region, and the next instruction unless the
 * program has ended. If the program cannot continue, also prints the reason. */
void show_place(struct debugger *debugger);
/* Prints the text `before`, the instruction at an address, and its source line if it is
 * known. */
void show_instruction(struct debugger *debugger, uint64_t address, const char *before);

#endif
