/* cmd_shared.c - see cmd.h. */
#include "asm/command/c205_command.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
    struct asm_options options = { .defines = arguments->defines.items,
                                   .search = arguments->folders.items };
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

/* The name is cut off in place. */
bool cmd_take_define(char *text, void *value)
{
    struct cmd_defines *defines = value;
    struct asm_define *define = &defines->items[defines->count];
    char *equals = strchr(text, '='), *end;
    if (!equals || equals == text || defines->count == CMD_DEFINES) {
        return false;
    }
    errno = 0;
    define->value = strtoll(equals + 1, &end, 0);
    if (errno != 0 || end == equals + 1 || *end != '\0') {
        return false;
    }
    *equals = '\0';
    define->name = text;
    defines->count++;
    return true;
}
