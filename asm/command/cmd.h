/* cmd.h - what the commands of c205 share.
 *
 * A command gets its arguments parsed and returns the exit code.  Results go
 * to stdout, all else to stderr.
 */
#ifndef ASM_CMD_H
#define ASM_CMD_H

#include "asm/assemble.h"
#include "base/complain.h"
#include "base/json.h"
#include "base/provenance.h"
#include "base/table.h"

#define CMD_DEFAULT_MODEL "cyber205-2pipe"
enum { CMD_DEFINES = 64, CMD_FOLDERS = 16 };

struct cmd_arguments {
    const char *command;
    const char *model;
    const char *json, *output, *save, *restore; /* NULL: not wanted */
    uint64_t limit;
    bool check, trace, listing, names, points, markdown;
    size_t define_count;
    struct asm_define defines[CMD_DEFINES + 1]; /* the last has no name */
    size_t folder_count;
    const char *folders[CMD_FOLDERS + 1]; /* the last is NULL */
    size_t file_count;
    char **files; /* what is no option */
};

typedef int cmd_function(const struct cmd_arguments *arguments);
cmd_function cmd_run, cmd_check, cmd_asm, cmd_dis, cmd_isa, cmd_model,
    cmd_time;

/* argv[0] is the command; allowed holds the letters of its options (see
 * cmd_arguments.c).  False after telling what is wrong. */
bool cmd_parse(int argc, char **argv, const char *allowed,
               struct cmd_arguments *arguments);

/* A program from its text or from an object file; NULL after all errors have
 * gone to the report. */
struct object *cmd_read_program(const struct cmd_arguments *arguments,
                                const char *path, const struct sink *report);

/* A model, or NULL after telling why not. */
c205_model *cmd_find_model(const char *command, const char *name);

/* The JSON file that the user asked for, NULL if none.  False after telling
 * why it cannot be written. */
bool cmd_open_json(const struct cmd_arguments *arguments, struct json **json);
/* Closes the file if code is CMD_DONE, drops it otherwise.  The code. */
int cmd_end_json(const struct cmd_arguments *arguments, struct json *json,
                 int code);

/* Print a table, add it to the JSON file if there is one, and free it. */
int cmd_show(const char *command, struct table *table, struct json *json,
             const char *key);

#endif
