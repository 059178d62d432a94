/* c205.c - the command: run, assemble and look into programs of the machine.
 */
#include <stdio.h>
#include <string.h>

#include "asm/command/cmd.h"

const char cmd_program[] = "c205";

#define OPTION_MODEL \
    "  --model NAME|FILE    machine model (" CMD_DEFAULT_MODEL ")\n"
#define OPTION_JSON \
    "  --json FILE          write the results to a file as well\n"
#define OPTION_DEFINE \
    "  --define NAME=VALUE  an integer for the program text, as by .equ\n" \
    "  -I, --include DIR    look for included files there as well\n"

static const struct command {
    const char *name;
    cmd_function *function;
    const char *options; /* letters, see cmd_arguments.c */
    size_t least, most;  /* arguments that are no options */
    const char *summary;
    const char *help;
} commands[] = {
    { "run", cmd_run, "mjdIlctsr", 0, SIZE_MAX,
      "run a program and account for its clocks",
      "c205 run FILE           run a program, text or an object of c205 asm\n"
      "c205 run --check FILE.. run test programs; a line each, PASS or FAIL\n"
      "c205 run --restore STATE [FILE]\n"
      "                        go on with a program that was saved; a FILE\n"
      "                        must be that program\n" OPTION_MODEL
      "  --limit CLOCKS       stop the program after so many\n"
      "  --save STATE         save the machine when the limit stops it\n" OPTION_DEFINE
      "  --trace              print each instruction as it is executed\n" OPTION_JSON },
    { "asm", cmd_asm, "odIL", 1, 1, "assemble a program",
      "c205 asm FILE           look for errors\n"
      "  -o, --output FILE    write the object there\n"
      "  --listing            print the listing\n" OPTION_DEFINE },
    { "dis", cmd_dis, "dI", 1, 1, "a program as text again",
      "c205 dis FILE           an object of c205 asm, or a text\n" OPTION_DEFINE },
    { "isa", cmd_isa, "jnmM", 0, SIZE_MAX, "the instructions",
      "c205 isa                all instructions, one line each\n"
      "c205 isa MNEMONIC..     all that is known of these\n"
      "  --names              the mnemonics alone\n"
      "  --markdown           the whole reference, docs/isa.md\n" OPTION_MODEL
          OPTION_JSON },
    { "model", cmd_model, "j", 0, 1, "the machine models",
      "c205 model              the models that are built in\n"
      "c205 model NAME|FILE    its constants, each with unit and source\n" OPTION_JSON },
    { "time", cmd_time, "mjp", 0, SIZE_MAX, "measure the vector instructions",
      "c205 time [MNEMONIC..]  start-up, clocks per element, r-infinity and\n"
      "                        n-half of these, or of all; TRIAD is the\n"
      "                        linked triad B + s A; ,H behind a name: on\n"
      "                        32-bit operands\n" OPTION_MODEL
      "  --points             print each measured point, too\n" OPTION_JSON },
};
enum { COMMANDS = sizeof commands / sizeof *commands };

static void print_summary(FILE *file)
{
    fputs("c205 COMMAND [OPTIONS] [FILES] - a CYBER 205 style machine\n",
          file);
    for (size_t i = 0; i < COMMANDS; i++) {
        fprintf(file, "  %-6s %s\n", commands[i].name, commands[i].summary);
    }
    fputs("c205 COMMAND --help tells more of each\n", file);
}

static bool asks_for_help(int argc, char **argv)
{
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++) {
        if (strcmp(argv[i], "--help") == 0) {
            return true;
        }
    }
    return false;
}

static int start(const struct command *command, int argc, char **argv)
{
    struct cmd_arguments arguments;
    if (asks_for_help(argc, argv)) {
        printf("c205 %s - %s\n\n", command->name, command->summary);
        fputs(command->help, stdout);
        return CMD_DONE;
    }
    if (!cmd_parse(argc, argv, command->options, &arguments)) {
        return CMD_USAGE;
    }
    if (arguments.file_count < command->least) {
        return cmd_usage(command->name, "name a file");
    }
    if (arguments.file_count > command->most) {
        return cmd_usage(command->name, "too many arguments: %s",
                         arguments.files[command->most]);
    }
    return command->function(&arguments);
}

static int finish(const char *name, int code)
{
    if (fflush(stdout) != 0 || ferror(stdout)) {
        return cmd_failed(name, "standard output: write error");
    }
    return code;
}

int main(int argc, char **argv)
{
    if (argc < 2) {
        print_summary(stderr);
        return CMD_USAGE;
    }
    if (strcmp(argv[1], "--help") == 0) {
        print_summary(stdout);
        return finish("--help", CMD_DONE);
    }
    for (size_t i = 0; i < COMMANDS; i++) {
        if (strcmp(argv[1], commands[i].name) == 0) {
            return finish(argv[1], start(&commands[i], argc - 1, argv + 1));
        }
    }
    fprintf(stderr, "c205: no such command: %s\n", argv[1]);
    print_summary(stderr);
    return CMD_USAGE;
}
