/* cmd_compare.c - c205 compare: compares two programs, or two
 * settings of one program. */
#include <stdio.h>
#include <string.h>

#include "asm/command/session.h"
#include "asm/compare/compared.h"
#include "vm/error.h"

struct compare_arguments {
    struct shared_arguments shared;
    struct source_arguments source;
    struct command_texts files;
    const char *other_model; /* model of the second program; NULL: the same model */
    struct cmd_defines other_defines;
    bool warm;
};

struct two_runs {
    const struct compare_arguments *args;
    const char *path[COMPARED_RUNS];
    struct session session[COMPARED_RUNS]; /* the first session has the output */
    struct compared_run run[COMPARED_RUNS];
};

/* ---- Runs ------------------------------------------------------------------ */

static bool read_side(struct two_runs *runs, int which)
{
    const struct compare_arguments *args = runs->args;
    struct source_arguments source = args->source;
    struct session *session = &runs->session[which];
    struct sink report = visible_stream(stderr);
    bool second = which == COMPARED_SECOND;
    runs->path[which] = args->files.items[args->files.count == 1 ? 0 : which];
    session->command = args->shared.command;
    if (second && args->other_defines.count > 0)
        source.defines = args->other_defines;
    session->object = cmd_read_any(&source, runs->path[which], &report);
    return session->object
           && session_model(session, second && args->other_model ? args->other_model
                                                                 : args->shared.model);
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

/* Checks that each constant that -D defines is used by a program for which it is
 * defined. */
static bool uses_defines(const struct two_runs *runs)
{
    const struct compare_arguments *args = runs->args;
    bool own = args->other_defines.count > 0;
    struct object *const objects[] = { runs->session[COMPARED_FIRST].object,
                                       runs->session[COMPARED_SECOND].object };
    const char *unused = asm_unused_define(args->source.defines.items, objects,
                                           own ? 1 : COMPARED_RUNS);
    if (!unused) {
        unused = asm_unused_define(args->other_defines.items, objects + COMPARED_SECOND,
                                   1);
    }
    if (unused) {
        cmd_failed(args->shared.command,
                   "'%s' is defined, but the program does not use it", unused);
    }
    return !unused;
}

/* Runs one of the two programs and discards its output. */
static bool run_side(struct two_runs *runs, int which)
{
    struct session *session = &runs->session[which];
    c205_error error;
    bool good = session_load(session, runs->args->warm, &error)
                && run_to_end(&runs->run[which], session->machine, &error);
    if (!good)
        cmd_failed(session->command, "%s: %s", runs->path[which], error.message);
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
        output_printf(results, "%s: %s on %s\n", i ? "second" : "first", runs->path[i],
                      c205_model_name(runs->session[i].model));
    }
    code = show_next(results, compared_causes(runs->run), "causes", "Causes", CMD_DONE);
    code = show_next(results, compared_regions(runs->run), "regions", "Regions", code);
    code = show_next(results, compared_figures(runs->run), "figures", "Figures", code);
    output_gap(results);
    compared_sentence(runs->run, sentence);
    output_printf(results, "%s\n", sentence);
    for (int i = 0; i < COMPARED_RUNS; i++)
        if (i == COMPARED_FIRST
            || strcmp(c205_model_name(runs->session[i].model),
                      c205_model_name(runs->session[COMPARED_FIRST].model))
                   != 0)
            output_model(results, runs->session[i].model);
    return code;
}

static int cmd_compare(void *given)
{
    const struct compare_arguments *args = given;
    struct two_runs runs = { .args = args };
    struct session *first = &runs.session[COMPARED_FIRST];
    if (args->files.count == 0 || args->files.count > COMPARED_RUNS)
        return cmd_usage(args->shared.command, "expected one or two programs");
    if (args->files.count == 1 && !args->other_model
        && args->other_defines.count == 0) {
        return cmd_usage(args->shared.command,
                         "expected a second program, --other-model or --other-define");
    }
    bool good = read_side(&runs, COMPARED_FIRST) && read_side(&runs, COMPARED_SECOND)
                && uses_defines(&runs) && run_side(&runs, COMPARED_FIRST)
                && run_side(&runs, COMPARED_SECOND)
                && session_output(first, &args->shared.results, NULL);
    int code = session_close(first, good ? show(&runs, &first->results) : CMD_FAILED);
    session_close(&runs.session[COMPARED_SECOND], code);
    for (int i = 0; i < COMPARED_RUNS; i++)
        compared_free(&runs.run[i]);
    return code;
}

#define PLACE(member) offsetof(struct compare_arguments, member)

static const struct command_option options[] = {
    CMD_MODEL,
    { OPTION_ROW("other-model", "NAME|FILE", COMMAND_INPUT, PLACE(other_model),
                 "machine model of the second program"),
      .choice = command_model_choice },
    CMD_DEFINE(PLACE(source)),
    { OPTION_ROW(
          "other-define", "NAME=VALUE", COMMAND_CUSTOM, PLACE(other_defines),
          "define an integer for the second program, which then ignores --define"),
      .take = cmd_take_define, .wants = CMD_DEFINE_WANTS },
    OPTION_FLAG("warm", PLACE(warm), "all pages are in memory when the programs begin"),
    CMD_INCLUDE(PLACE(source)),
    CMD_FIGURES,
    COMMAND_END
};
static const struct command_option operands[] = {
    { OPERAND_ROW("FILE", COMMAND_INPUT, PLACE(files),
                  "two programs, or one to run with two settings"),
      .many = true },
    COMMAND_END
};
static const struct command_example examples[] = {
    { "c205 compare --warm FILE FILE", "show why one is faster" },
    { "c205 compare FILE --other-model cyber205-4pipe",
      "the same program on another machine" },
    { NULL, NULL }
};

const struct command compare_command = {
    COMMAND_ROW("compare", cmd_compare, struct compare_arguments,
                "compare two programs and show the cause of the difference"),
    .examples = examples,
};
