/* cmd_asm.c - c205 asm: assemble a program. */
#include "asm/command/cmd.h"
#include "asm/listing.h"
#include "asm/object.h"

int cmd_asm(const struct cmd_arguments *arguments)
{
    c205_error error;
    struct sink report = stream_sink(stderr);
    struct object *object = cmd_read_program(arguments, arguments->files[0],
                                             &report);
    if (!object) {
        return CMD_FAILED;
    }
    int code = CMD_DONE;
    if (arguments->listing) {
        struct sink sink = stream_sink(stdout);
        listing(object, &sink);
    }
    if (arguments->output
        && !object_save(object, arguments->output, &error)) {
        code = cmd_failed(arguments->command, "%s", error.message);
    }
    object_free(object);
    return code;
}
