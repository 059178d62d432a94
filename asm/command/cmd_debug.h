/* cmd_debug.h - shared by the files of c205 debug. */
#ifndef ASM_CMD_DEBUG_H
#define ASM_CMD_DEBUG_H

#include "asm/command/c205_command.h"

/* Runs the debugger for an editor, with messages on stdin and stdout (debug --dap). */
int cmd_debug_dap(const struct c205_arguments *arguments);

#endif
