/* session.c - reads the programs and options of c205 commands, and opens and closes
 * their sessions. */
#include "asm/command/session.h"

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
    if (!object)
        sink_print(report, "%s: %s\n", path, error.message);
    return object;
}

static struct object *assemble(const struct source_arguments *source, const char *path,
                               const char *text, size_t length,
                               const struct sink *report)
{
    struct asm_options options = { .defines = source->defines.items,
                                   .search = source->folders.items,
                                   .warnings = source->warnings.choice };
    struct diagnostics errors = { 0 };
    struct object *object = assemble_bytes(path, text, length, &options, &errors);
    diagnostics_put(&errors, report);
    if (!object && errors.count == 0)
        sink_print(report, "%s: error: out of memory\n", path);
    diagnostics_free(&errors);
    return object;
}

struct object *cmd_read_any(const struct source_arguments *source, const char *path,
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
                                : assemble(source, path, text, length, report);
    free(text);
    return object;
}

struct object *cmd_read_program(const struct source_arguments *source, const char *path,
                                const struct sink *report)
{
    struct object *object = cmd_read_any(source, path, report);
    const char *unused = object ? asm_unused_define(source->defines.items, &object, 1)
                                : NULL;
    if (!unused)
        return object;
    sink_print(report, "%s: error: '%s' is defined, but the program does not use it\n",
               path, unused);
    object_free(object);
    return NULL;
}

bool cmd_is_defined(const struct cmd_defines *defines, const char *name)
{
    for (size_t i = 0; i < defines->count; i++)
        if (strcmp(defines->items[i].name, name) == 0)
            return true;
    return false;
}

/* Reads NAME=VALUE. The text is modified: a NUL replaces the "=". */
bool cmd_take_define(char *text, void *value)
{
    struct cmd_defines *defines = value;
    struct asm_define *define = &defines->items[defines->count];
    char *equals = strchr(text, '='), *end;
    if (!equals || equals == text || defines->count == CMD_DEFINES)
        return false;
    errno = 0;
    define->value = strtoll(equals + 1, &end, 0);
    if (errno != 0 || end == equals + 1 || *end != '\0')
        return false;
    *equals = '\0';
    if (cmd_is_defined(defines, text)) {
        *equals = '=';
        return false;
    }
    define->name = text;
    defines->count++;
    return true;
}

/* ---- Session ------------------------------------------------------------- */

bool session_program(struct session *session, const struct source_arguments *source,
                     const char *path)
{
    struct sink report = visible_stream(stderr);
    session->object = cmd_read_program(source, path, &report);
    return session->object;
}

bool session_model(struct session *session, const char *name)
{
    session->model = model_open(session->command, name);
    return session->model;
}

bool session_load(struct session *session, bool warm, c205_error *error)
{
    session->machine = c205_new(session->model, error);
    if (!session->machine || !object_check(session->object, error)
        || !c205_load(session->machine, &session->object->program, error))
        return false;
    if (warm)
        c205_warm(session->machine);
    return true;
}

bool session_output(struct session *session, const struct command_output *results,
                    const char *output)
{
    session->results = *results;
    return output_open(&session->results, session->command, output);
}

int session_close(struct session *session, int code)
{
    code = output_close(&session->results, code);
    c205_free(session->machine);
    c205_model_free(session->model);
    object_free(session->object);
    return code;
}
