/* session.h - shared parts of the c205 commands: groups of arguments, the rows of their
 * options, and the session of a command.
 *
 *   struct session session = { .command = args->shared.command };
 *   bool good = session_program(&session, &args->source, args->file)
 *               && session_model(&session, args->shared.model);
 *   return session_close(&session, good ? work(&session, args) : CMD_FAILED);
 *
 * The file of a command defines a structure of its arguments. It begins with struct
 * shared_arguments or with the first member of that structure, and contains the other
 * groups of the command.
 */
#ifndef ASM_SESSION_H
#define ASM_SESSION_H

#include <stddef.h>

#include "asm/command/commands.h"
#include "asm/text/assemble.h"
#include "base/command_options.h"
#include "base/command_output.h"
#include "base/named_model.h"
#include "base/provenance.h"
#include "base/visible_text.h"

/* ---- Groups of arguments ------------------------------------------------- */

struct shared_arguments {
    const char *command, *model;
    struct command_output results;
};

enum { CMD_DEFINES = 64 };
struct cmd_defines {
    size_t count;
    struct asm_define items[CMD_DEFINES + 1]; /* the last has a NULL name */
};

struct cmd_warnings {
    struct warning_choice choice;
    bool list; /* print only the list of warnings */
};

/* The arguments that determine how a program text is assembled. */
struct source_arguments {
    struct cmd_defines defines;
    struct command_texts folders;
    struct cmd_warnings warnings;
};

/* Prints the list of warnings for -W list. Returns the exit code. */
int cmd_list_warnings(void);
/* Reads a program from its text or from an object file. Returns NULL on failure, after
 * writing all errors to the report. cmd_read_program reports names that are defined
 * with -D but not used; cmd_read_any does not. */
struct object *cmd_read_any(const struct source_arguments *source, const char *path,
                            const struct sink *report);
struct object *cmd_read_program(const struct source_arguments *source, const char *path,
                                const struct sink *report);

/* ---- Rows of options ----------------------------------------------------- */

/* Reads NAME=VALUE into a struct cmd_defines. */
command_take cmd_take_define;
bool cmd_is_defined(const struct cmd_defines *defines, const char *name);
/* Reads the argument of -W into a struct cmd_warnings. */
command_take cmd_take_warning;

/* clang-format off */
#define CMD_MODEL OPTION_MODEL(offsetof(struct shared_arguments, model))
#define CMD_RESULTS OUTPUT_OPTIONS(struct shared_arguments, results)
/* The options of commands whose results depend on a model. */
#define CMD_FIGURES \
    CMD_RESULTS, OUTPUT_OPTION_PROVENANCE(struct shared_arguments, results)

/* Options of commands that read programs. `source` is the offset of the struct
 * source_arguments in the arguments of the command. */
#define CMD_INCLUDE(source) \
    OPTION_INCLUDE((source) + offsetof(struct source_arguments, folders))
#define CMD_DEFINE_WANTS "NAME=VALUE, a name and an integer, each name once"
#define CMD_DEFINE(source) \
    { OPTION_ROW("define", "NAME=VALUE", COMMAND_CUSTOM, \
                 (source) + offsetof(struct source_arguments, defines), \
                 "define an integer for the program text, like .equ"), \
      .take = cmd_take_define, .wants = CMD_DEFINE_WANTS }
#define CMD_WARN(source) \
    { .name = "warn", .letter = 'W', .value = "NAME|no-NAME", \
      .kind = COMMAND_CUSTOM, \
      .offset = (source) + offsetof(struct source_arguments, warnings), \
      .take = cmd_take_warning, \
      .wants = "the name of a warning (-W list prints them), all or error, " \
               "or no- and one of these", \
      .help = "report a warning, or with no- suppress it: -Wno-run-off; all; " \
              "error: warnings are errors; list: print the names" }
#define CMD_PROGRAM(file) \
    { OPERAND_ROW("FILE", COMMAND_INPUT, file, \
                  "a program text, or an object of c205 asm") }
/* clang-format on */

/* ---- Session ------------------------------------------------------------- */

/* Default limit of a run in clocks: 20 seconds of machine time. Few programs need more,
 * and endless loops are frequent. */
#define CMD_LIMIT UINT64_C(1000000000)

/* The session of a command. Initially only `command` is set. */
struct session {
    const char *command;
    struct object *object;
    c205_model *model;
    c205 *machine;
    struct command_output results;
};

/* Each of these functions opens one part of the session, and returns false after an
 * error message. `output` is another file that the command writes, or NULL. */
bool session_program(struct session *session, const struct source_arguments *source,
                     const char *path);
bool session_model(struct session *session, const char *name);
bool session_output(struct session *session, const struct command_output *results,
                    const char *output);
/* Creates a machine of the model and loads the program. warm: all pages of the program
 * are in memory at the start. Returns false with the reason in the error. */
bool session_load(struct session *session, bool warm, c205_error *error);
/* Closes everything that the session has open. The JSON results are written if the code
 * is CMD_DONE, and discarded otherwise. Returns the exit code. */
int session_close(struct session *session, int code);

#endif
