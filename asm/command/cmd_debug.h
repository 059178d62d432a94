/* cmd_debug.h - c205 debug, by lines and by messages. */
#ifndef ASM_CMD_DEBUG_H
#define ASM_CMD_DEBUG_H

#include "asm/command/c205_command.h"

/* debug --dap: for an editor, by messages on stdin and stdout. */
int cmd_debug_dap(const struct c205_arguments *arguments);

#endif
