/* debugger.h - a program under control: forward and back, where it stops, what it
 * holds, and why it took its time.
 *
 * It is told one line at a time, by a person, a pipe or a script, and says all
 * that it says to a sink.  `help` lists the verbs; docs/debugging.md has a session.
 * Who knows more of the program than that it is one may have verbs besides.
 */
#ifndef ASM_DEBUGGER_H
#define ASM_DEBUGGER_H

#include "asm/assemble.h"

struct debugger;

struct debugger_verb {
    const char *name; /* NULL behind the last */
    const char *arguments, *help;
    /* What is behind the name on its line; says what it says to debugger_out.  False: it
     * cannot be done, the error says why. */
    bool (*obey)(void *context, struct debugger *debugger, const char *cursor,
                 c205_error *error);
};

struct debugger_setup {
    const struct object *object; /* these outlive it */
    const char *name;            /* of the program's file */
    const c205_model *model;
    struct sink out;
    struct sink printed;  /* by the program; the same if it has no put */
    bool printed_apart;   /* replies are not among the output of the program */
    bool warm;            /* all pages are in memory when the program begins */
    uint64_t clocks_most; /* that one movement takes: a script has no Ctrl-C */
    size_t history;       /* bytes for the way back at most; 0: as many as usual */
    bool (*interrupted)(void *asked); /* asked while the program runs: shall
                                         it stop?  NULL: never */
    void *asked;
    /* The machine before it begins, loaded with the object's program.  NULL: one with that
      * program alone. */
    c205 *(*machine)(void *context, c205_error *error);
    const struct debugger_verb *verbs; /* besides, or NULL */
    void *context;                     /* of these two */
};

/* The program is before its first instruction.  NULL: it cannot be loaded, no
 * memory. */
struct debugger *debugger_new(const struct debugger_setup *setup, c205_error *error);
void debugger_free(struct debugger *debugger);

/* Where the program stands. */
void debugger_greet(struct debugger *debugger);
/* Do what a line says; an empty one does the last movement again.  False: it said
 * quit. */
bool debugger_obey(struct debugger *debugger, const char *line);
/* Lines that could not be done, and assertions that failed. */
size_t debugger_faults(const struct debugger *debugger);

/* The debugger's own verbs, NULL behind the last. */
const char *debugger_verb(size_t i);

/* ---- For verbs besides ---------------------------------------------------- */

const c205 *debugger_machine(const struct debugger *debugger);
const struct sink *debugger_out(const struct debugger *debugger);
/* On, by one instruction at least, to where the machine is there, or to a stop; where
 * that is is told. */
void debugger_seek(struct debugger *debugger,
                   bool (*is_there)(void *context, const c205 *machine), void *context);

#endif
