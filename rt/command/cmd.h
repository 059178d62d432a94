/* cmd.h - what the commands of rt205 share.
 *
 * A command gets its arguments parsed and returns the exit code.  Results go
 * to stdout, all else to stderr.
 */
#ifndef RT_CMD_H
#define RT_CMD_H

#include "base/complain.h"
#include "base/json.h"
#include "base/table.h"
#include "rt/roots/roots.h"
#include "rt/scene/language/scene_read.h"
#include "rt/study/sweep/kinds.h"

/* In what form results go to stdout: as text; tables as CSV or Markdown; or
 * nothing but the JSON document. */
enum cmd_format {
    FORMAT_TEXT = TABLE_PLAIN,
    FORMAT_CSV = TABLE_CSV,
    FORMAT_MARKDOWN = TABLE_MARKDOWN,
    FORMAT_JSON
};

struct cmd_arguments {
    const char *command;
    const char *sweep;         /* what is swept, or NULL */
    const char *scene;         /* the file to work on, or NULL; of a sweep
                                   perhaps a primitive */
    const char *output, *json; /* NULL: not wanted */
    const char *resume;        /* keeps finished bands, or NULL */
    const char *model;
    enum cmd_format format;
    struct trace_options trace;        /* its model is not yet set */
    struct speedup_view view;          /* angle 0: not given */
    size_t points[SWEEP_LENGTHS_MOST]; /* lengths of the queue, rising */
    size_t point_count;
    bool strict, half;
    bool first, compare; /* of polynomials: --first, --falsi all */
    bool passes; /* of the root solver, one by one, in the speedup table */
    enum falsi falsi;
    const char **search; /* folders for includes; NULL at the end */
};

typedef int cmd_function(struct cmd_arguments *arguments);
cmd_function cmd_render, cmd_profile, cmd_speedup, cmd_sweep, cmd_quartic;

/* What a command does with its model, which is found and set, and with the
 * JSON that the user asked for, NULL if none.  With FORMAT_JSON there is one,
 * which goes to stdout, and the work prints nothing else there.  The exit code,
 * or CMD_UNDRAWN: all results are there, but not their picture. */
typedef int cmd_work(const struct cmd_arguments *arguments,
                     struct json *json);
enum { CMD_UNDRAWN = CMD_USAGE + 1 };
/* Do that.  The JSON is kept if the work ends with CMD_DONE or CMD_UNDRAWN,
 * else dropped.  The exit code: of what is not drawn CMD_FAILED. */
int cmd_with_machine(struct cmd_arguments *arguments, cmd_work *work);

/* The scene of the arguments; its reports go to stderr.  NULL: it has errors,
 * which have been told. */
struct scene *cmd_read_scene(const struct cmd_arguments *arguments);

/* Whether two paths name one file, however they are written; either may be
 * NULL. */
bool cmd_is_one_file(const char *a, const char *b);

/* Let Ctrl-C ask a trace to stop, and show progress when stderr is a
 * terminal: a trace_options.progress function and its context. */
void cmd_watch(struct trace_options *options);
/* Whether Ctrl-C has been pressed since. */
bool cmd_interrupted(void);

#endif
