/* cmd_shared.c - see cmd.h. */
#include "rt/command/cmd.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static bool open_json(const struct cmd_arguments *arguments,
                      struct json **json, c205_error *error)
{
    *json = NULL;
    if (arguments->format == FORMAT_JSON)
        *json = json_open_stream(stdout, arguments->json, error);
    else if (arguments->json)
        *json = json_open(arguments->json, error);
    else
        return true;
    return *json != NULL;
}

static int end_json(const struct cmd_arguments *arguments, struct json *json,
                    int code)
{
    bool whole = code == CMD_DONE || code == CMD_UNDRAWN;
    c205_error error;

    if (json && !whole)
        json_discard(json);
    else if (json && !json_close(json, &error))
        return cmd_failed(arguments->command, "%s", error.message);
    return code == CMD_UNDRAWN ? CMD_FAILED : code;
}

int cmd_with_machine(struct cmd_arguments *arguments, cmd_work *work)
{
    c205_error error;
    struct json *json;
    c205_model *model = c205_model_find(arguments->model, &error);
    int code;

    if (!model)
        return cmd_failed(arguments->command, "%s", error.message);
    if (c205_model_is_projection(model)) {
        code = cmd_failed(arguments->command,
                          "%s is a projection, on which nothing runs",
                          c205_model_name(model));
    } else if (open_json(arguments, &json, &error)) {
        arguments->trace.model = model;
        cmd_watch(&arguments->trace);
        code = end_json(arguments, json, work(arguments, json));
    } else {
        code = cmd_failed(arguments->command, "%s", error.message);
    }
    c205_model_free(model);
    return code;
}

static bool go_on(void *context)
{
    (void)context;
    return !cmd_interrupted();
}

struct scene *cmd_read_scene(const struct cmd_arguments *arguments)
{
    struct scene_options options = {
        .width = (int)arguments->trace.width,
        .height = (int)arguments->trace.height,
        .strict = arguments->strict,
        .search = arguments->search,
        .go_on = go_on,
    };
    struct diagnostics reports = { 0 };
    struct scene *scene = scene_read(arguments->scene, &options, &reports);

    diagnostics_print(&reports, stderr);
    diagnostics_free(&reports);
    return scene;
}

/* The folder that a path names a file in, and the file's name there; false:
 * there is no such folder. */
static bool find_place(const char *path, struct stat *folder,
                       const char **name)
{
    const char *slash = strrchr(path, '/');
    char text[4096];
    int length = !slash ? 0 : (int)(slash - path) + 1;

    *name = path + length;
    if (length >= (int)sizeof text)
        return false;
    snprintf(text, sizeof text, "%.*s.", length, path);
    return stat(text, folder) == 0;
}

bool cmd_is_one_file(const char *a, const char *b)
{
    struct stat in_a, in_b;
    const char *name_a, *name_b;

    return a && b && find_place(a, &in_a, &name_a)
           && find_place(b, &in_b, &name_b) && in_a.st_dev == in_b.st_dev
           && in_a.st_ino == in_b.st_ino && strcmp(name_a, name_b) == 0;
}
