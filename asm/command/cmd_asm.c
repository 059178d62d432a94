/* cmd_asm.c - c205 asm: assembles a program. */
#include "asm/command/c205_command.h"
#include "asm/object/object_file.h"
#include "asm/view/listing.h"

static int assemble(void *given)
{
    const struct c205_arguments *arguments = given;
    if (arguments->warnings.list) {
        return cmd_list_warnings();
    }
    if (!arguments->file) {
        return cmd_usage(arguments->command, "FILE is missing");
    }
    c205_error error;
    struct sink report = visible_stream(stderr);
    struct object *object = cmd_read_program(arguments, arguments->file, &report);
    if (!object) {
        return CMD_FAILED;
    }
    int code = CMD_DONE;
    if (arguments->listing) {
        struct sink sink = visible_stream(stdout);
        listing(object, &sink);
    }
    if (arguments->output && !object_save(object, arguments->output, &error)) {
        code = cmd_failed(arguments->command, "%s", error.message);
    }
    object_free(object);
    return code;
}

static const struct command_option options[] = { { .name = "output",
                                                   .letter = 'o',
                                                   .value = "FILE",
                                                   .kind = COMMAND_OUTPUT,
                                                   .offset = CMD_PLACE(output),
                                                   .help = "write the object to FILE" },
                                                 CMD_FLAG(listing, "print the listing"),
                                                 CMD_WARN,
                                                 CMD_DEFINE,
                                                 CMD_INCLUDE,
                                                 COMMAND_END };
static const struct command_option operands[] = { { .value = "FILE",
                                                    .kind = COMMAND_INPUT,
                                                    .optional = true,
                                                    .offset = CMD_PLACE(file),
                                                    .help = "a program text" },
                                                  COMMAND_END };

const struct command asm_command = {
    .name = "asm",
    .summary = "assemble a program",
    .function = assemble,
    .arguments_size = sizeof(struct c205_arguments),
    .options = options,
    .operands = operands,
    .details =
        "Checks a program for errors. Nothing is written without -o or --listing.",
};
