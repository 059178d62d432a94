/* repl.h - reads and executes the lines of a debugger, from a terminal, a pipe or
 * scripts. */
#ifndef ASM_REPL_H
#define ASM_REPL_H

#include "asm/debug/debugger.h"
#include "base/command.h"

struct repl_setup {
    const char *command; /* name of the command, for error messages */
    const char *prompt;
    const char *(*verb)(size_t i);       /* returns the names for completion by Tab */
    const struct command_texts *scripts; /* files of commands; none: stdin */
};

/* Makes a debugger and executes lines until the end of the input or the verb quit.
 * Ctrl-C is caught. Returns the exit code. It is CMD_FAILED if the debugger cannot be
 * made, or if a line of a script or a pipe failed. Errors at a terminal do not
 * count. */
int repl_run(const struct repl_setup *setup, const struct debugger_setup *of_debugger);
/* The function for debugger_setup.interrupted. Returns true if Ctrl-C was pressed. */
bool repl_interrupted(void *asked);

#endif
