/* rt205.c - the command: scenes traced by programs of the machine. */
#include "rt/command/rt205_command.h"

int main(int argc, char **argv)
{
    static const struct command *const commands[] = {
        &render_command, &profile_command, &speedup_command,
        &sweep_command,  &quartic_command, NULL
    };
    static const struct command_program program = {
        .name = "rt205",
        .summary = "a ray tracer on a CYBER 205 style machine",
        .version = C205_VERSION,
        .commands = commands,
        .arguments_size = sizeof(struct cmd_arguments),
    };

    return command_main(&program, argc, argv);
}
