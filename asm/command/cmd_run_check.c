/* cmd_run_check.c - c205 run --check: runs test programs and compares them
 * with their expectations.
 *
 * The arguments may name the model. Otherwise, a program runs on the model of its
 * expect-model, or on the default model if there is none.
 */
#include <string.h>

#include "asm/check/expect.h"
#include "asm/check/runtime_check.h"
#include "asm/command/cmd_run.h"
#include "asm/object/object_file.h"
#include "asm/view/print.h"
#include "base/named_model.h"

/* Default limit of the clocks of a test program. A program that exceeds the limit
 * fails. */
static const uint64_t patience = 100000000;

struct checker {
    const struct run_arguments *args;
    const struct command_output *results;
    struct table *table; /* NULL if results are text */
    c205_model *model;   /* model of the last program, reused if the next program has
                            the same model */
    c205 *machine;
    struct printer printer;
    struct runtime_checker *watch; /* checker of the current program, or NULL */
    struct text_buffer printed;    /* output of the program */
    struct text_buffer report;     /* the errors of the program */
    size_t failures;
};

static bool fail(struct checker *checker, const char *reason)
{
    struct sink sink = text_buffer_sink(&checker->report);
    sink_print(&sink, "%s\n", reason);
    return false;
}

static bool meets(struct checker *checker, const struct object *object,
                  const c205_stop *stop)
{
    struct sink sink = text_buffer_sink(&checker->report);
    const char *printed = checker->printed.text;
    warning_set warned = object->warned | runtime_warned(checker->watch);
    if (!expect_anything(object))
        return fail(checker, "the program has no expectations");
    return expect_check(object, checker->machine, stop, printed ? printed : "", warned,
                        &sink)
           && runtime_errors(checker->watch) == 0;
}

/* ---- The machine for a program ------------------------------------------ */

static void drop_machine(struct checker *checker)
{
    c205_free(checker->machine);
    c205_model_free(checker->model);
    checker->machine = NULL;
    checker->model = NULL;
}

/* Calls the checker of the current program. The machine is reused for other programs,
 * but each program has its own checker. */
static void listen(void *context, const c205 *machine, const c205_event *event)
{
    const struct checker *checker = context;
    runtime_listen(checker->watch, machine, event);
}

static bool make_machine(struct checker *checker, const char *model)
{
    c205_error error;
    drop_machine(checker);
    checker->model = model_find(model, &error);
    checker->machine = checker->model ? c205_new(checker->model, &error) : NULL;
    if (!checker->machine) {
        drop_machine(checker);
        return fail(checker, error.message);
    }
    return c205_listen(checker->machine, printer_listen, &checker->printer)
           && c205_listen(checker->machine, listen, checker);
}

static const char *model_for(const struct checker *checker, const struct object *object)
{
    const char *given = checker->args->shared.model;
    const char *named = expect_model(object);
    return given ? given : named ? named : C205_DEFAULT_MODEL;
}

static bool have_machine(struct checker *checker, const struct object *object)
{
    const char *model = model_for(checker, object);
    return (checker->model && strcmp(c205_model_name(checker->model), model) == 0)
           || make_machine(checker, model);
}

static bool run_watched(struct checker *checker, const struct object *object)
{
    uint64_t limit = checker->args->limit;
    runtime_begin(checker->watch, checker->machine);
    c205_stop stop = c205_run(checker->machine,
                              limit != C205_NO_LIMIT ? limit : patience);
    return meets(checker, object, &stop);
}

static bool run(struct checker *checker, const struct object *object, const char *path)
{
    struct sink report = text_buffer_sink(&checker->report);
    c205_error error;
    if (!have_machine(checker, object))
        return false;
    if (!object_check(object, &error)
        || !c205_load(checker->machine, &object->program, &error))
        return fail(checker, error.message);
    checker->watch = runtime_new(object, path, &checker->args->source.warnings.choice,
                                 &report);
    bool good = checker->watch ? run_watched(checker, object)
                               : fail(checker, "out of memory");
    runtime_free(checker->watch);
    checker->watch = NULL;
    return good;
}

/* ---- Results ------------------------------------------------------------- */

static const struct table_column columns[] = {
    { "program", "program", TABLE_TEXT, 0 },
    { "passed", "passed", TABLE_TEXT, 0 },
    { "clocks", "clocks", TABLE_TEXT, 0 },
    { "report", "report", TABLE_TEXT, 0 },
};

/* The result of one program. */
struct verdict {
    const char *path;
    bool good;
    const char *other_model; /* model whose clocks are not compared with the expected
                                clocks, or NULL */
    const char *report;
};

static void print_row(struct table *table, const struct verdict *verdict)
{
    table_text(table, verdict->path);
    table_text(table, verdict->good ? "yes" : "no");
    table_text(table, verdict->other_model ? "not compared" : "");
    table_text(table, verdict->report);
}

/* Prints the result, and the reasons indented below it. */
static void print_text(const struct command_output *results,
                       const struct verdict *verdict)
{
    const char *text = verdict->report;
    const char *other = verdict->other_model;
    output_printf(results, "%s %s%s%s%s\n", verdict->good ? "PASS" : "FAIL",
                  verdict->path, other ? " (clocks not compared on " : "",
                  other ? other : "", other ? ")" : "");
    while (*text) {
        size_t length = strcspn(text, "\n");
        output_printf(results, "    %.*s\n", (int)length, text);
        text += length + (text[length] != '\0');
    }
}

static void print_json(struct json *json, const c205_model *model,
                       const struct verdict *verdict)
{
    json_object(json, NULL);
    json_text(json, "program", verdict->path);
    json_bool(json, "passed", verdict->good);
    json_bool(json, "clocks_compared", !verdict->other_model);
    json_text(json, "report", verdict->report);
    if (model)
        provenance_json(model, json);
    json_end(json);
}

static void check_one(struct checker *checker, const char *path)
{
    struct sink sink = text_buffer_sink(&checker->report);
    struct object *object = cmd_read_program(&checker->args->source, path, &sink);
    struct verdict verdict = { path, object && run(checker, object, path), NULL, "" };
    if (object && checker->machine && expect_other_model(object, checker->machine))
        verdict.other_model = c205_model_name(checker->model);
    object_free(object);
    if (checker->report.text)
        verdict.report = checker->report.text;
    if (checker->printed.failed || checker->report.failed) {
        verdict.good = false;
        verdict.report = "out of memory";
    }
    if (checker->table)
        print_row(checker->table, &verdict);
    else
        print_text(checker->results, &verdict);
    if (checker->results->json)
        print_json(checker->results->json, checker->model, &verdict);
    checker->failures += !verdict.good;
    text_buffer_free(&checker->printed);
    text_buffer_free(&checker->report);
}

static int check_all(struct checker *checker)
{
    const struct run_arguments *args = checker->args;
    const struct command_output *results = checker->results;
    bool tabular = results->file && results->format != OUTPUT_TEXT;
    if (tabular && !(checker->table = table_new(TABLE_COLUMNS(columns))))
        return cmd_failed(args->shared.command, "out of memory");
    if (results->json)
        json_array(results->json, "programs");
    for (size_t i = 0; i < args->files.count; i++)
        check_one(checker, args->files.items[i]);
    if (results->json)
        json_end(results->json);
    bool good = !tabular
                || table_write(checker->table, output_table_format(results),
                               results->file);
    table_free(checker->table);
    output_printf(results, "%zu passed, %zu failed\n",
                  args->files.count - checker->failures, checker->failures);
    return !good                   ? cmd_failed(args->shared.command, "out of memory")
           : checker->failures > 0 ? CMD_FAILED
                                   : CMD_DONE;
}

/* Checks that the model of the arguments exists. */
static bool check_model(const struct run_arguments *args)
{
    c205_model *model = model_open(args->shared.command, args->shared.model);
    c205_model_free(model);
    return model != NULL;
}

/* Runs all programs. The JSON is written in any case, because failures are results,
 * too. */
int cmd_run_check(const struct run_arguments *args)
{
    struct command_output results = args->shared.results;
    struct checker checker = { .args = args, .results = &results };
    checker.printer.sink = text_buffer_sink(&checker.printed);
    if (!check_model(args) || !output_open(&results, args->shared.command, NULL))
        return CMD_FAILED;
    int code = check_all(&checker);
    drop_machine(&checker);
    int kept = output_close(&results, CMD_DONE);
    return code == CMD_DONE ? kept : code;
}
