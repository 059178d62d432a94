/* cmd_compare.c - c205 compare: compares two programs, or two
 * settings of one program. */
#include <stdio.h>
#include <string.h>

#include "asm/command/c205_command.h"
#include "asm/compare/compared.h"
#include "base/error.h"

struct side {
    const char *path;
    c205_model *model;
    struct object *object;
};

struct two_runs {
    const struct c205_arguments *arguments;
    struct side side[COMPARED_RUNS];
    struct compared_run run[COMPARED_RUNS];
};

/* ---- Runs ------------------------------------------------------------------ */

static bool read_side(struct two_runs *runs, int which)
{
    const struct c205_arguments *arguments = runs->arguments;
    struct c205_arguments own = *arguments;
    struct side *side = &runs->side[which];
    struct sink report = visible_stream(stderr);
    bool other = which == COMPARED_SECOND && arguments->files.count == 1;
    side->path = arguments->files.items[other ? COMPARED_FIRST : which];
    if (which == COMPARED_SECOND && arguments->other_defines.count > 0) {
        own.defines = arguments->other_defines;
    }
    side->object = cmd_read_any(&own, side->path, &report);
    side->model = side->object
                      ? model_open(arguments->command,
                                   which == COMPARED_SECOND && arguments->other_model
                                       ? arguments->other_model
                                       : arguments->model)
                      : NULL;
    return side->model;
}

static bool run_to_end(struct compared_run *run, c205 *machine, c205_error *error)
{
    c205_stop stop = c205_run(machine, CMD_LIMIT);
    if (stop.trap != C205_TRAP_NONE) {
        c205_describe_stop(machine, &stop, error);
        return false;
    }
    error_set(error, "out of memory");
    return compared_take(run, machine);
}

/* Checks that each definition is used by at least one of the
 * programs that receive it. */
static bool uses_defines(const struct two_runs *runs)
{
    const struct c205_arguments *arguments = runs->arguments;
    bool own = arguments->other_defines.count > 0;
    struct object *const objects[] = { runs->side[COMPARED_FIRST].object,
                                       runs->side[COMPARED_SECOND].object };
    const char *unused = asm_unused_define(arguments->defines.items, objects,
                                           own ? 1 : COMPARED_RUNS);
    if (!unused) {
        unused = asm_unused_define(arguments->other_defines.items,
                                   objects + COMPARED_SECOND, 1);
    }
    if (unused) {
        cmd_failed(arguments->command, "'%s' is defined, and not used", unused);
    }
    return !unused;
}

/* Runs a program. Its output is discarded. */
static bool run_side(struct two_runs *runs, int which)
{
    struct side *side = &runs->side[which];
    c205_error error;
    c205 *machine = cmd_load(runs->arguments, side->object, side->model, &error);
    bool good;
    good = machine && run_to_end(&runs->run[which], machine, &error);
    c205_free(machine);
    if (!good) {
        cmd_failed(runs->arguments->command, "%s: %s", side->path, error.message);
    }
    return good;
}

/* ---- The command ----------------------------------------------------------- */

static int show_next(const struct command_output *results, struct table *table,
                     const char *key, const char *heading, int code)
{
    if (code != CMD_DONE) {
        table_free(table);
        return code;
    }
    output_gap(results);
    return output_show(results, table, key, heading);
}

static int show(const struct two_runs *runs, const struct command_output *results)
{
    char sentence[COMPARED_SENTENCE];
    int code;
    for (int i = 0; i < COMPARED_RUNS; i++) {
        const struct side *side = &runs->side[i];
        output_printf(results, "%s: %s on %s\n", i ? "second" : "first", side->path,
                      c205_model_name(side->model));
    }
    code = show_next(results, compared_causes(runs->run), "causes", "Causes", CMD_DONE);
    code = show_next(results, compared_regions(runs->run), "regions", "Regions", code);
    code = show_next(results, compared_figures(runs->run), "figures", "Figures", code);
    output_gap(results);
    compared_sentence(runs->run, sentence);
    output_printf(results, "%s\n", sentence);
    for (int i = 0; i < COMPARED_RUNS; i++) {
        if (i == COMPARED_FIRST
            || strcmp(c205_model_name(runs->side[i].model),
                      c205_model_name(runs->side[COMPARED_FIRST].model))
                   != 0) {
            output_model(results, runs->side[i].model);
        }
    }
    return code;
}

static int compare(struct two_runs *runs)
{
    struct command_output results = runs->arguments->results;
    int code;
    if (!read_side(runs, COMPARED_FIRST) || !read_side(runs, COMPARED_SECOND)
        || !uses_defines(runs) || !run_side(runs, COMPARED_FIRST)
        || !run_side(runs, COMPARED_SECOND)) {
        return CMD_FAILED;
    }
    if (!output_open(&results, runs->arguments->command, NULL)) {
        return CMD_FAILED;
    }
    code = show(runs, &results);
    return output_close(&results, code);
}

static int run(void *given)
{
    const struct c205_arguments *arguments = given;
    struct two_runs runs = { .arguments = arguments };
    int code;
    if (arguments->files.count == 0 || arguments->files.count > COMPARED_RUNS) {
        return cmd_usage(arguments->command, "expected one or two programs");
    }
    if (arguments->files.count == 1 && !arguments->other_model
        && arguments->other_defines.count == 0) {
        return cmd_usage(arguments->command,
                         "expected a second program, --other-model or --other-define");
    }
    code = compare(&runs);
    for (int i = 0; i < COMPARED_RUNS; i++) {
        compared_free(&runs.run[i]);
        object_free(runs.side[i].object);
        c205_model_free(runs.side[i].model);
    }
    return code;
}

static const struct command_option options[] = {
    CMD_MODEL,
    { .name = "other-model",
      .value = "NAME|FILE",
      .kind = COMMAND_INPUT,
      .offset = CMD_PLACE(other_model),
      .choice = command_model_choice,
      .help = "machine model of the second program" },
    CMD_DEFINE,
    { .name = "other-define",
      .value = "NAME=VALUE",
      .kind = COMMAND_CUSTOM,
      .offset = CMD_PLACE(other_defines),
      .take = cmd_take_define,
      .wants = "NAME=VALUE, a name and an integer, each name once",
      .help = "define an integer for the second program, which then ignores --define" },
    CMD_FLAG(warm, "all pages are in memory when the programs begin"),
    CMD_INCLUDE,
    CMD_FIGURES,
    COMMAND_END
};
static const struct command_option operands[] = {
    { .value = "FILE",
      .kind = COMMAND_INPUT,
      .many = true,
      .offset = CMD_PLACE(files),
      .help = "two programs, or one to run with two settings" },
    COMMAND_END
};
static const struct command_example examples[] = {
    { "c205 compare --warm FILE FILE", "show why one is faster" },
    { "c205 compare FILE --other-model cyber205-4pipe",
      "the same program on another machine" },
    { NULL, NULL }
};

const struct command compare_command = {
    .name = "compare",
    .summary = "compare two programs and show the cause of the difference",
    .function = run,
    .arguments_size = sizeof(struct c205_arguments),
    .options = options,
    .operands = operands,
    .examples = examples,
};
