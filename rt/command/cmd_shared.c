/* cmd_shared.c - see cmd.h. */
#include "rt/command/rt205_command.h"

#include <stdio.h>

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
    c205_model *model;
    int code;

    if (arguments->trace.height > 0
        && arguments->trace.width
               > TRACE_PIXELS_MOST / arguments->trace.height)
        return cmd_usage(arguments->command, "at most %zu pixels",
                         TRACE_PIXELS_MOST);
    model = c205_model_find(arguments->model, &error);

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
        .search = arguments->search.items,
        .go_on = go_on,
    };
    struct diagnostics reports = { 0 };
    struct scene *scene = scene_read(arguments->scene, &options, &reports);

    diagnostics_print(&reports, stderr);
    diagnostics_free(&reports);
    return scene;
}

/* ---- The names of what options choose ------------------------------------ */

const char *cmd_mode_choice(size_t number)
{
    return number < TRACE_MODES ? trace_mode_name((enum trace_mode)number)
                                : NULL;
}

const char *cmd_visible_choice(size_t number)
{
    return number < VISIBLE_WAYS ? visible_name((enum visible)number) : NULL;
}

const char *cmd_format_choice(size_t number)
{
    static const char *const names[] = { [FORMAT_TEXT] = "text",
                                         [FORMAT_CSV] = "csv",
                                         [FORMAT_MARKDOWN] = "md",
                                         [FORMAT_JSON] = "json" };

    return number <= FORMAT_JSON ? names[number] : NULL;
}
