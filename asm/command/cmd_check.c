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

/* The reasons, each line a little to the right. */
static void print_report(const char *text)
{
    while (text && *text) {
        size_t length = strcspn(text, "\n");
        printf("    %.*s\n", (int)length, text);
        text += length + (text[length] != '\0');
    }
}

static void check_all(const struct cmd_arguments *arguments, c205 *machine,
                      struct findings *findings, struct json *json,
                      size_t *failures)
{
    for (size_t i = 0; i < arguments->files.count; i++) {
        const char *path = arguments->files.items[i];
        bool good = try(arguments, machine, path, findings);
        const char *report = findings->report.text;
        printf("%s %s\n", good ? "PASS" : "FAIL", path);
        print_report(report);
        if (findings->printed.failed || findings->report.failed) {
            puts("    no memory");
        }
        if (json) {
            json_object(json, NULL);
            json_text(json, "program", path);
            json_truth(json, "passed", good);
            json_text(json, "report", report ? report : "");
            json_end(json);
        }
        *failures += !good;
        text_buffer_free(&findings->printed);
        text_buffer_free(&findings->report);
    }
}

static int check_on(const struct cmd_arguments *arguments, c205 *machine)
{
    struct findings findings = { { 0 }, { 0 } };
    struct printer printer = { text_buffer_sink(&findings.printed) };
    struct json *json;
    size_t failures = 0;
    if (!cmd_open_json(arguments, &json)) {
        return CMD_FAILED;
    }
    c205_listen(machine, printer_listen, &printer);
    if (json) {
        provenance_json(c205_machine_model(machine), json);
        json_array(json, "programs");
    }
    check_all(arguments, machine, &findings, json, &failures);
    if (json) {
        json_end(json);
    }
    printf("%zu passed, %zu failed\n", arguments->files.count - failures,
           failures);
    int code = cmd_end_json(arguments, json, CMD_DONE);
    return failures ? CMD_FAILED : code;
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
