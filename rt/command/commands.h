/* commands.h - the commands of rt205 in the order of its help. A row is the NAME of a
 * file cmd_NAME.c, which defines NAME_command.
 */
#ifndef RT_COMMANDS_H
#define RT_COMMANDS_H

#include "base/command.h"

#define COMMANDS(ROW) \
    ROW(render) \
    ROW(profile) \
    ROW(speedup) \
    ROW(sweep) \
    ROW(quartic) \
    ROW(heat) \
    ROW(mass) \
    ROW(timeline)

COMMANDS(COMMAND_DECLARE)

#endif
