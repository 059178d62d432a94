/* cmd_shared.c - see cmd.h. */
#include "rt/cmd.h"

static bool open_json(const struct cmd_arguments *arguments,
                      struct json **json, c205_error *error)
{
    *json = NULL;
    if (arguments->json != NULL)
        *json = json_open(arguments->json, error);
    return arguments->json == NULL || *json != NULL;
}

static int end_json(const struct cmd_arguments *arguments, struct json *json,
                    int code)
{
    c205_error error;

    if (json != NULL && code != CMD_DONE)
        json_discard(json);
    else if (json != NULL && !json_close(json, &error))
        return cmd_failed(arguments->command, "%s", error.message);
    return code;
}

int cmd_with_machine(struct cmd_arguments *arguments, cmd_work *work)
{
    c205_error error;
    struct json *json;
    c205_model *model = c205_model_find(arguments->model, &error);
    int code;

    if (model == NULL)
        return cmd_failed(arguments->command, "%s", error.message);
    if (open_json(arguments, &json, &error)) {
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
    struct reports reports = { 0, 0, NULL };
    struct scene *scene = scene_read(arguments->scene, &options, &reports);

    reports_print(stderr, &reports);
    reports_free(&reports);
    return scene;
}
