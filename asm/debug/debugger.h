/* debugger.h - a program under control: forward and back, where it stops, what it
 * holds, and why it took its time.
 *
 * It is told one line at a time, by a person, a pipe or a script, and says all
 * that it says to a sink.  `help` lists the verbs; docs/debugging.md has a session.
 */
#ifndef ASM_DEBUGGER_H
#define ASM_DEBUGGER_H

#include "asm/assemble.h"

struct debugger;

struct debugger_setup {
    const struct object *object; /* these outlive it */
    const char *name;            /* of the program's file */
    const c205_model *model;
    struct sink out;
    struct sink printed; /* by the program; the same if it has no put */
    bool warm;           /* all pages are in memory when the program begins */
    uint64_t
        clocks_most; /* that one movement takes: a script has no Ctrl-C */
    bool (*interrupted)(void *asked); /* asked while the program runs: shall
                                         it stop?  NULL: never */
    void *asked;
};

/* The program stands before its first instruction.  NULL: it cannot be loaded, no
 * memory. */
struct debugger *debugger_new(const struct debugger_setup *setup,
                              c205_error *error);
void debugger_free(struct debugger *debugger);

/* Where the program stands. */
void debugger_greet(struct debugger *debugger);
/* Do what a line says; an empty one does the last movement again.  False: it said
 * quit. */
bool debugger_obey(struct debugger *debugger, const char *line);
/* Lines that could not be done, and assertions that failed. */
size_t debugger_faults(const struct debugger *debugger);

/* The verbs, NULL behind the last. */
const char *debugger_verb(size_t i);

#endif
