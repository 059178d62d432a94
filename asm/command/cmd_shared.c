/* cmd_shared.c - see cmd.h. */
#include "asm/command/cmd.h"

#include <stdio.h>

#include "asm/object.h"

c205_model *cmd_find_model(const char *command, const char *name)
{
    c205_error error;
    c205_model *model = c205_model_find(name, &error);
    if (!model) {
        cmd_failed(command, "%s", error.message);
    }
    return model;
}

struct object *cmd_read_program(const struct cmd_arguments *arguments,
                                const char *path, const struct sink *report)
{
    struct asm_options options = { .defines = arguments->defines,
                                   .search = arguments->folders };
    struct diagnostics errors = { 0 };
    c205_error error;
    struct object *object;
    if (object_recognise(path)) {
        object = object_load(path, &error);
        if (!object) {
            sink_print(report, "%s\n", error.message);
        }
        return object;
    }
    object = assemble_file(path, &options, &errors);
    diagnostics_put(&errors, report);
    if (!object && errors.count == 0) {
        sink_print(report, "%s: error: no memory\n", path);
    }
    diagnostics_free(&errors);
    return object;
}

bool cmd_open_json(const struct cmd_arguments *arguments, struct json **json)
{
    c205_error error;
    *json = NULL;
    if (arguments->json && !(*json = json_open(arguments->json, &error))) {
        cmd_failed(arguments->command, "%s", error.message);
        return false;
    }
    return true;
}

int cmd_end_json(const struct cmd_arguments *arguments, struct json *json,
                 int code)
{
    c205_error error;
    if (json && code != CMD_DONE) {
        json_discard(json);
    } else if (json && !json_close(json, &error)) {
        return cmd_failed(arguments->command, "%s", error.message);
    }
    return code;
}

int cmd_show(const char *command, struct table *table, struct json *json,
             const char *key)
{
    bool good = table && table_print(table, stdout);
    if (good && json) {
        good = table_json(table, json, key);
    }
    table_free(table);
    return good ? CMD_DONE : cmd_failed(command, "no memory");
}
