/* cmd.h - what the commands of rt205 share.
 *
 * A command gets its arguments parsed and returns the exit code.  Results go
 * to stdout, all else to stderr.
 */
#ifndef RT_CMD_H
#define RT_CMD_H

#include "asm/complain.h"
#include "asm/json.h"
#include "rt/roots.h"
#include "rt/speedup.h"

struct cmd_arguments {
    const char *command;
    const char *scene;          /* the file to work on, or NULL */
    const char *output, *json;  /* NULL: not wanted */
    const char *resume;         /* keeps finished bands, or NULL */
    const char *model;
    struct trace_options trace; /* its model is not yet set */
    struct speedup_view view;
    bool strict, half;
    bool first, compare; /* of polynomials: --first, --falsi all */
    bool passes; /* of the root solver, one by one, in the speedup table */
    enum falsi falsi;
    const char **search;        /* folders for includes; NULL at the end */
};

typedef int cmd_function(struct cmd_arguments *arguments);
cmd_function cmd_render, cmd_profile, cmd_speedup, cmd_quartic;

/* What a command does with its model, which is found and set, and with the
 * JSON file that the user asked for, NULL if none. */
typedef int cmd_work(const struct cmd_arguments *arguments,
                     struct json *json);
/* Do that.  The file is kept if the work ends with CMD_DONE, else dropped.
 * The exit code. */
int cmd_with_machine(struct cmd_arguments *arguments, cmd_work *work);

/* The scene of the arguments; its reports go to stderr.  NULL: it has errors,
 * which have been told. */
struct scene *cmd_read_scene(const struct cmd_arguments *arguments);

/* Let Ctrl-C ask a trace to stop, and show progress when stderr is a
 * terminal: a trace_options.progress function and its context. */
void cmd_watch(struct trace_options *options);
/* Whether Ctrl-C has been pressed since. */
bool cmd_interrupted(void);

#endif
