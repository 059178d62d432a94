/* cmd_check.c - c205 run --check: test programs and what they expect. */
#include <string.h>

#include "asm/command/c205_command.h"
#include "asm/expect.h"
#include "asm/print.h"

/* A program that never ends is a failure, too. */
static const uint64_t patience = 100000000;

/* What the program printed, and what is wrong. */
struct findings {
    struct text_buffer printed, report;
};

static void fail(struct findings *findings, const char *reason)
{
    struct sink sink = text_buffer_sink(&findings->report);
    sink_print(&sink, "%s\n", reason);
}

static bool meets(const struct object *object, c205 *machine,
                  const c205_stop *stop, struct findings *findings)
{
    struct sink sink = text_buffer_sink(&findings->report);
    const char *printed = findings->printed.text;
    if (object->expectation_count == 0) {
        fail(findings, "the program expects nothing");
        return false;
    }
    return expect_check(object, machine, stop, printed ? printed : "", &sink);
}

static bool try(const struct cmd_arguments *arguments, c205 *machine,
                const char *path, struct findings *findings)
{
    c205_error error;
    struct sink sink = text_buffer_sink(&findings->report);
    struct object *object = cmd_read_program(arguments, path, &sink);
    bool good = object && c205_load(machine, &object->program, &error);
    if (good) {
        bool given = arguments->limit != C205_NO_LIMIT;
        c205_stop stop = c205_run(machine,
                                  given ? arguments->limit : patience);
        good = meets(object, machine, &stop, findings);
    } else if (object) {
        fail(findings, error.message);
    }
    object_free(object);
    return good && !findings->printed.failed && !findings->report.failed;
}

/* ---- What is told of them ------------------------------------------------ */

static const struct table_column columns[] = {
    { "program", "program", TABLE_TEXT, 0 },
    { "passed", "passed", TABLE_TEXT, 0 },
    { "report", "report", TABLE_TEXT, 0 },
};

struct tally {
    const struct results *results;
    struct table *table; /* where results are not text */
    size_t failures;
};

/* The reasons, each line a little to the right. */
static void print_report(const struct results *results, const char *text)
{
    while (*text) {
        size_t length = strcspn(text, "\n");
        results_say(results, "    %.*s\n", (int)length, text);
        text += length + (text[length] != '\0');
    }
}

static void tell(struct tally *tally, const char *path, bool good,
                 const char *report)
{
    struct json *json = tally->results->json;
    if (tally->table) {
        table_text(tally->table, path);
        table_text(tally->table, good ? "yes" : "no");
        table_text(tally->table, report);
    } else {
        results_say(tally->results, "%s %s\n", good ? "PASS" : "FAIL", path);
        print_report(tally->results, report);
    }
    if (json) {
        json_object(json, NULL);
        json_text(json, "program", path);
        json_truth(json, "passed", good);
        json_text(json, "report", report);
        json_end(json);
    }
}

static void check_all(const struct cmd_arguments *arguments, c205 *machine,
                      struct findings *findings, struct tally *tally)
{
    for (size_t i = 0; i < arguments->files.count; i++) {
        const char *path = arguments->files.items[i];
        bool good = try(arguments, machine, path, findings);
        bool complete = !findings->printed.failed && !findings->report.failed;
        const char *report = findings->report.text;
        tell(tally, path, good,
             !complete ? "no memory"
             : report  ? report
                       : "");
        tally->failures += !good;
        text_buffer_free(&findings->printed);
        text_buffer_free(&findings->report);
    }
}

static int check_and_tell(const struct cmd_arguments *arguments,
                          c205 *machine, const struct results *results)
{
    struct findings findings = { { 0 }, { 0 } };
    struct printer printer = { text_buffer_sink(&findings.printed) };
    bool tabular = results->file && results->format != RESULTS_TEXT;
    struct tally tally = { results, NULL, 0 };
    if (tabular && !(tally.table = table_new(TABLE_COLUMNS(columns)))) {
        return cmd_failed(arguments->command, "no memory");
    }
    c205_listen(machine, printer_listen, &printer);
    if (results->json) {
        provenance_json(c205_machine_model(machine), results->json);
        json_array(results->json, "programs");
    }
    check_all(arguments, machine, &findings, &tally);
    if (results->json) {
        json_end(results->json);
    }
    bool good = !tabular
                || table_write(tally.table, results_table_format(results),
                               results->file);
    table_free(tally.table);
    results_say(results, "%zu passed, %zu failed\n",
                arguments->files.count - tally.failures, tally.failures);
    return !good                ? cmd_failed(arguments->command, "no memory")
           : tally.failures > 0 ? CMD_FAILED
                                : CMD_DONE;
}

/* What failed is a result, too: the JSON is kept. */
static int check_on(const struct cmd_arguments *arguments, c205 *machine)
{
    struct results results = arguments->results;
    if (!results_open(&results, arguments->command, NULL)) {
        return CMD_FAILED;
    }
    int code = check_and_tell(arguments, machine, &results);
    int kept = results_close(&results, CMD_DONE);
    return code == CMD_DONE ? kept : code;
}

int cmd_check(const struct cmd_arguments *arguments)
{
    c205_error error;
    c205_model *model = cmd_find_model(arguments->command, arguments->model);
    if (!model) {
        return CMD_FAILED;
    }
    c205 *machine = c205_new(model, &error);
    int code = machine ? check_on(arguments, machine)
                       : cmd_failed(arguments->command, "%s", error.message);
    c205_free(machine);
    c205_model_free(model);
    return code;
}
