/* c205_command.h - shared by the commands of c205.
 *
 * Each command is a file with its entry of the table, its options and its
 * function (command.h).
 */
#ifndef ASM_C205_COMMAND_H
#define ASM_C205_COMMAND_H

#include <stddef.h>

#include "asm/sweep/swept.h"
#include "asm/text/assemble.h"
#include "base/command_options.h"
#include "base/command_output.h"
#include "base/named_model.h"
#include "base/provenance.h"
#include "base/visible_text.h"

extern const struct command run_command, asm_command, dis_command, isa_command,
    model_command, time_command, debug_command, compare_command, timeline_command,
    sweep_command, check_command;

enum { CMD_DEFINES = 64 };
struct cmd_defines {
    size_t count;
    struct asm_define items[CMD_DEFINES + 1]; /* the last has a NULL name */
};

/* The constants of a sweep: one has a range, the others are fixed. */
struct cmd_swept {
    struct cmd_defines fixed;
    const char *name;
    struct swept_range range;
    size_t ranges; /* number of ranges on the command line */
};

struct cmd_warnings {
    struct warning_choice choice;
    bool list; /* print the list of warnings and nothing else */
};

struct c205_arguments {
    const char *command;
    const char *model;
    struct command_output results;
    const char *other_model;             /* for the second program; NULL: the same */
    const char *output, *save, *restore; /* NULL: not requested */
    uint64_t limit, from;
    bool check, trace, listing, names, points, markdown, grammar, card;
    bool no_limit, exit_status, profile, in_order, warm, dap, start, hints;
    struct cmd_defines defines, other_defines;
    struct cmd_swept swept;
    size_t point_count;
    struct cmd_warnings warnings;
    const char *lesson, *folder; /* folder: with answers */
    struct command_texts folders;
    const char *file;           /* the operand, of commands with one */
    struct command_texts files; /* the operands, of the others */
    struct command_texts scripts;
};

/* ---- Options of several commands ---------------------------------------- */

#define CMD_PLACE(member) offsetof(struct c205_arguments, member)

/* Reads NAME=VALUE into a struct cmd_defines. */
command_take cmd_take_define;
/* Reads the argument of -W into a struct cmd_warnings. */
command_take cmd_take_warning;

/* clang-format off */
#define CMD_MODEL OPTION_MODEL(CMD_PLACE(model))
#define CMD_RESULTS OUTPUT_OPTIONS(struct c205_arguments, results)
/* The options of results that depend on a model. */
#define CMD_FIGURES \
    CMD_RESULTS, OUTPUT_OPTION_PROVENANCE(struct c205_arguments, results)
#define CMD_INCLUDE OPTION_INCLUDE(CMD_PLACE(folders))
#define CMD_DEFINE \
    { .name = "define", .value = "NAME=VALUE", .kind = COMMAND_CUSTOM, \
      .offset = CMD_PLACE(defines), .take = cmd_take_define, \
      .wants = "NAME=VALUE, a name and an integer, each name once", \
      .help = "define an integer for the program text, like .equ" }
#define CMD_WARN \
    { .name = "warn", .letter = 'W', .value = "NAME|no-NAME", \
      .kind = COMMAND_CUSTOM, .offset = CMD_PLACE(warnings), \
      .take = cmd_take_warning, \
      .wants = "the name of a warning (-W list prints them), all or error, " \
               "or no- and one of these", \
      .help = "report a warning, or with no- suppress it: -Wno-run-off; all; " \
              "error: warnings are errors; list: print the names" }
#define CMD_FLAG(flag, text) \
    { .name = #flag, .kind = COMMAND_FLAG, .offset = CMD_PLACE(flag), \
      .help = text }
#define CMD_PROGRAM \
    { .value = "FILE", .kind = COMMAND_INPUT, .offset = CMD_PLACE(file), \
      .help = "a program text, or an object of c205 asm" }
/* clang-format on */

/* ---- Functions of the commands ------------------------------------------ */

/* Runs test programs and compares them with their expectations (run --check). */
int cmd_run_check(const struct c205_arguments *arguments);

/* Reads a program from its text or from an object file. Returns NULL after all errors
 * were written to the report. cmd_read_program requires that the program uses all
 * defined names; cmd_read_any does not. */
struct object *cmd_read_any(const struct c205_arguments *arguments, const char *path,
                            const struct sink *report);
struct object *cmd_read_program(const struct c205_arguments *arguments,
                                const char *path, const struct sink *report);

/* Default limit of clocks: 20 seconds of the machine. Few programs need more, and
 * endless loops are frequent. */
#define CMD_LIMIT UINT64_C(1000000000)
/* Returns a machine with the program, with warm pages if the arguments request it; NULL
 * and the error if it fails. */
c205 *cmd_load(const struct c205_arguments *arguments, const struct object *object,
               const c205_model *model, c205_error *error);
/* Opens the program and the model of the arguments. Returns false after a report. The
 * caller frees both in either case. */
bool cmd_open(const struct c205_arguments *arguments, struct object **object,
              c205_model **model);


/* Prints the warnings: -W list. */
int cmd_list_warnings(void);

#endif
