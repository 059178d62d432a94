/* repl.h - what a person, a pipe or scripts say to a debugger. */
#ifndef ASM_REPL_H
#define ASM_REPL_H

#include "asm/debug/debugger.h"
#include "base/command.h"

struct repl_setup {
    const char *command; /* for complaints */
    const char *prompt;
    const char *(*verb)(size_t i);       /* those that Tab completes */
    const struct command_texts *scripts; /* files; none: stdin */
};

/* All of it, until somebody quits; Ctrl-C is caught.  The exit code: of a script or a pipe
 * CMD_FAILED after a fault, a person's mistakes are none. */
int repl_hold(const struct repl_setup *setup, struct debugger *debugger);
/* For a debugger's setup: Ctrl-C has come. */
bool repl_interrupted(void *asked);

#endif
