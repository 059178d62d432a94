/* cmd_dis.c - c205 dis: prints a program as text that assembles to the same words. */
#include "asm/command/c205_command.h"
#include "asm/object/disassemble.h"

static int disassemble_file(void *given)
{
    const struct c205_arguments *arguments = given;
    struct sink sink = visible_stream(stdout);
    struct sink report = visible_stream(stderr);
    struct object *object = cmd_read_program(arguments, arguments->file, &report);
    if (!object) {
        return CMD_FAILED;
    }
    bool good = disassemble(object, &sink);
    object_free(object);
    return good ? CMD_DONE : cmd_failed(arguments->command, "out of memory");
}

static const struct command_option options[] = { CMD_DEFINE, CMD_INCLUDE, COMMAND_END };
static const struct command_option operands[] = { CMD_PROGRAM, COMMAND_END };

const struct command dis_command = {
    .name = "dis",
    .summary = "disassemble a program",
    .function = disassemble_file,
    .arguments_size = sizeof(struct c205_arguments),
    .options = options,
    .operands = operands,
};
