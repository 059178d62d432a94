/* debugger.h - executes a program forward and back, with breakpoints and watchpoints,
 * and shows its registers, its memory and the causes of its time.
 *
 * The debugger reads commands one line at a time, from a user, a pipe or a script, and
 * writes all its output to a sink. `help` lists the verbs; docs/debugging.md has a
 * session. A caller may add verbs.
 */
#ifndef ASM_DEBUGGER_H
#define ASM_DEBUGGER_H

#include "asm/object/object.h"

struct debugger;

struct debugger_verb {
    const char *name; /* NULL at the end */
    const char *arguments, *help;
    /* Executes the verb. cursor is the text after its name, and debugger_out receives
     * the output. Returns false with the error if it fails. */
    bool (*obey)(void *context, struct debugger *debugger, const char *cursor,
                 c205_error *error);
};

struct debugger_setup {
    const struct object *object; /* must outlive the debugger, like name and model */
    const char *name;            /* name of the program's file */
    const c205_model *model;
    struct sink out;
    struct sink printed;  /* output of the program; NULL put: equal to out */
    bool printed_apart;   /* this output and the replies have different destinations */
    bool warm;            /* start with all pages in memory */
    uint64_t clocks_most; /* limit of one command, because a script has no Ctrl-C */
    size_t history;       /* maximum bytes of snapshots; 0: the default */
    bool (*interrupted)(void *asked); /* called regularly while the program runs; true
                                         stops it; NULL: never stop */
    void *asked;
    /* Creates a machine with the loaded program before its first instruction. NULL: the
     * debugger creates a machine of the model. */
    c205 *(*machine)(void *context, c205_error *error);
    const struct debugger_verb *verbs; /* additional verbs, or NULL */
    void *context;                     /* context of the machine function and the
                                          verbs */
};

/* Returns a debugger whose program is before its first instruction, or NULL if the
 * program cannot be loaded or memory is exhausted. */
struct debugger *debugger_new(const struct debugger_setup *setup, c205_error *error);
void debugger_free(struct debugger *debugger);

/* Prints the current location. */
void debugger_greet(struct debugger *debugger);
/* Executes a line. An empty line repeats the last execution command. Returns false
 * after the verb quit. */
bool debugger_obey(struct debugger *debugger, const char *line);
/* Returns the number of errors of commands, including failed assertions. */
size_t debugger_faults(const struct debugger *debugger);

/* Returns the name of built-in verb i, or NULL after the last. */
const char *debugger_verb(size_t i);

/* ---- For additional verbs ------------------------------------------------- */

const c205 *debugger_machine(const struct debugger *debugger);
const struct sink *debugger_out(const struct debugger *debugger);
/* Executes at least one instruction. Stops at a breakpoint or when is_there returns
 * true. Prints the new location. */
void debugger_seek(struct debugger *debugger,
                   bool (*is_there)(void *context, const c205 *machine), void *context);

#endif
