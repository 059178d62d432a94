/* commands.h - the table of the commands of c205, in the order of its help. A row NAME
 * stands for the file cmd_NAME.c, which defines NAME_command.
 */
#ifndef ASM_COMMANDS_H
#define ASM_COMMANDS_H

#include "base/command.h"

#define COMMANDS(ROW) \
    ROW(run) \
    ROW(debug) \
    ROW(asm) \
    ROW(dis) \
    ROW(isa) \
    ROW(model) \
    ROW(time) \
    ROW(compare) \
    ROW(timeline) \
    ROW(sweep) \
    ROW(check)

COMMANDS(COMMAND_DECLARE)

#endif
