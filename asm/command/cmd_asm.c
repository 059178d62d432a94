/* cmd_asm.c - c205 asm: assembles a program. */
#include "asm/command/session.h"
#include "asm/object/object_file.h"
#include "asm/view/listing.h"

struct asm_arguments {
    const char *command;
    struct source_arguments source;
    const char *file, *output; /* output is NULL if there is no -o */
    bool listing;
};

static int cmd_asm(void *given)
{
    const struct asm_arguments *args = given;
    struct session session = { .command = args->command };
    if (args->source.warnings.list)
        return cmd_list_warnings();
    if (!args->file)
        return cmd_usage(args->command, "FILE is missing");
    struct sink sink = visible_stream(stdout);
    c205_error error;
    int code = session_program(&session, &args->source, args->file) ? CMD_DONE
                                                                    : CMD_FAILED;
    if (code == CMD_DONE && args->listing)
        listing(session.object, &sink);
    if (code == CMD_DONE && args->output
        && !object_save(session.object, args->output, &error))
        code = cmd_failed(args->command, "%s", error.message);
    return session_close(&session, code);
}

#define PLACE(member) offsetof(struct asm_arguments, member)

static const struct command_option options[] = {
    OPTION_OUTPUT(PLACE(output), "write the object to FILE"),
    OPTION_FLAG("listing", PLACE(listing), "print the listing"),
    CMD_WARN(PLACE(source)),
    CMD_DEFINE(PLACE(source)),
    CMD_INCLUDE(PLACE(source)),
    COMMAND_END
};
static const struct command_option operands[] = {
    { OPERAND_ROW("FILE", COMMAND_INPUT, PLACE(file), "a program text"),
      .optional = true },
    COMMAND_END
};

const struct command asm_command = {
    COMMAND_ROW("asm", cmd_asm, struct asm_arguments, "assemble a program"),
    .details =
        "Checks a program for errors. Nothing is written without -o or --listing.",
};
