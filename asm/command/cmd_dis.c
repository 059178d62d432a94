/* cmd_dis.c - c205 dis: prints a program as text that assembles to the same words. */
#include "asm/command/session.h"
#include "asm/object/disassemble.h"

struct dis_arguments {
    const char *command;
    struct source_arguments source;
    const char *file;
};

static int cmd_dis(void *given)
{
    const struct dis_arguments *args = given;
    struct session session = { .command = args->command };
    struct sink sink = visible_stream(stdout);
    int code = CMD_FAILED;
    if (session_program(&session, &args->source, args->file)) {
        code = disassemble(session.object, &sink)
                   ? CMD_DONE
                   : cmd_failed(args->command, "out of memory");
    }
    return session_close(&session, code);
}

#define PLACE(member) offsetof(struct dis_arguments, member)

static const struct command_option options[] = { CMD_DEFINE(PLACE(source)),
                                                 CMD_INCLUDE(PLACE(source)),
                                                 COMMAND_END };
static const struct command_option operands[] = { CMD_PROGRAM(PLACE(file)),
                                                  COMMAND_END };

const struct command dis_command = {
    COMMAND_ROW("dis", cmd_dis, struct dis_arguments, "disassemble a program"),
};
