/* cmd_shared.c - options and functions that several commands of c205 use. */
#include "asm/command/c205_command.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/object/object_file.h"
#include "base/text_file.h"

bool cmd_take_warning(char *text, void *value)
{
    struct cmd_warnings *warnings = value;
    bool list = strcmp(text, "list") == 0;
    warnings->list |= list;
    return list || warning_choose(&warnings->choice, text);
}

int cmd_list_warnings(void)
{
    for (unsigned i = 0; i < WARNINGS; i++) {
        printf("%-18s %s\n", warning_name((enum warning)i),
               warning_text((enum warning)i));
    }
    return CMD_DONE;
}

static struct object *read_object(const char *path, const char *text, size_t length,
                                  const struct sink *report)
{
    c205_error error;
    struct object *object = object_read(text, length, &error);
    if (!object) {
        sink_print(report, "%s: %s\n", path, error.message);
    }
    return object;
}

static struct object *assemble(const struct c205_arguments *arguments, const char *path,
                               const char *text, size_t length,
                               const struct sink *report)
{
    struct asm_options options = { .defines = arguments->defines.items,
                                   .search = arguments->folders.items,
                                   .warnings = arguments->warnings.choice };
    struct diagnostics errors = { 0 };
    struct object *object = assemble_bytes(path, text, length, &options, &errors);
    diagnostics_put(&errors, report);
    if (!object && errors.count == 0) {
        sink_print(report, "%s: error: out of memory\n", path);
    }
    diagnostics_free(&errors);
    return object;
}

struct object *cmd_read_any(const struct c205_arguments *arguments, const char *path,
                            const struct sink *report)
{
    c205_error error;
    size_t length;
    char *text = text_file_read(path, FILE_LARGEST, &length, &error);
    if (!text) {
        sink_print(report, "%s: error: %s\n", path, error.message);
        return NULL;
    }
    struct object *object = object_recognise(text, length)
                                ? read_object(path, text, length, report)
                                : assemble(arguments, path, text, length, report);
    free(text);
    return object;
}

struct object *cmd_read_program(const struct c205_arguments *arguments,
                                const char *path, const struct sink *report)
{
    struct object *object = cmd_read_any(arguments, path, report);
    const char *unused = object
                             ? asm_unused_define(arguments->defines.items, &object, 1)
                             : NULL;
    if (!unused) {
        return object;
    }
    sink_print(report, "%s: error: '%s' is defined, and not used\n", path, unused);
    object_free(object);
    return NULL;
}

c205 *cmd_load(const struct c205_arguments *arguments, const struct object *object,
               const c205_model *model, c205_error *error)
{
    c205 *machine = c205_new(model, error);
    if (machine
        && (!object_check(object, error)
            || !c205_load(machine, &object->program, error))) {
        c205_free(machine);
        return NULL;
    }
    if (machine && arguments->warm) {
        c205_warm(machine);
    }
    return machine;
}

bool cmd_open(const struct c205_arguments *arguments, struct object **object,
              c205_model **model)
{
    struct sink report = visible_stream(stderr);
    *object = cmd_read_program(arguments, arguments->file, &report);
    *model = *object ? model_open(arguments->command, arguments->model) : NULL;
    return *model;
}

static bool is_defined(const struct cmd_defines *defines, const char *name)
{
    for (size_t i = 0; i < defines->count; i++) {
        if (strcmp(defines->items[i].name, name) == 0) {
            return true;
        }
    }
    return false;
}

/* Reads NAME=VALUE. The text is modified: the name ends at the "=". */
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
    if (is_defined(defines, text)) {
        *equals = '=';
        return false;
    }
    define->name = text;
    defines->count++;
    return true;
}
