/* c205.c - the command c205, which runs, assembles and examines
 * programs of the machine.
 */
#include "asm/command/commands.h"
#include "vm/c205.h"

int main(int argc, char **argv)
{
    static const struct command *const commands[] = { COMMANDS(COMMAND_ADDRESS) NULL };
    static const struct command_example files[] = {
        { "NAME.s",
          "A program text. The library files that it includes by name, such as "
          "print.s, are built into c205." },
        { "NAME.model",
          "A machine model: time constants, each with its unit and source; or "
          "changes to a built-in model." },
        { NULL, NULL }
    };
    static const struct command_program program = {
        .name = "c205",
        .summary = "run and examine programs of a CYBER 205 style machine",
        .version = C205_VERSION,
        .commands = commands,
        .files = files,
    };
    return command_main(&program, argc, argv);
}
