/* cmd_dis.c - c205 dis: a program as text that assembles to the same. */
#include "asm/command/cmd.h"
#include "asm/disassemble.h"

int cmd_dis(const struct cmd_arguments *arguments)
{
    struct sink sink = stream_sink(stdout);
    struct sink report = stream_sink(stderr);
    struct object *object = cmd_read_program(arguments, arguments->files[0],
                                             &report);
    if (!object) {
        return CMD_FAILED;
    }
    bool good = disassemble(&object->program, &sink);
    object_free(object);
    return good ? CMD_DONE : cmd_failed(arguments->command, "no memory");
}
