/* cmd_profile.c - rt205 profile: a frame in the three stages side by side. */
#include <stdio.h>

#include "base/provenance.h"
#include "rt/command/cmd.h"
#include "rt/study/profile.h"

static bool trace_stages(const struct cmd_arguments *arguments,
                         const struct scene *scene,
                         struct trace *traces[TRACE_MODES], c205_error *error)
{
    struct trace_options options = arguments->trace;

    options.watch_vectors = true;
    for (int i = 0; i < TRACE_MODES; i++) {
        options.mode = profile_stages[i];
        traces[i] = trace_new(scene, &options, error);
        if (!traces[i] || !trace_run(traces[i], error))
            return false;
    }
    return true;
}

static bool equal(struct trace *const traces[TRACE_MODES], c205_error *error)
{
    uint64_t first = trace_checksum(traces[0]);

    for (int i = 1; i < TRACE_MODES; i++) {
        if (trace_checksum(traces[i]) == first)
            continue;
        snprintf(error->message, sizeof error->message,
                 "the frames of the stages %s and %s do not agree",
                 trace_mode_name(profile_stages[0]),
                 trace_mode_name(profile_stages[i]));
        return false;
    }
    return true;
}

static void tell_head(const struct cmd_arguments *arguments,
                      uint64_t checksum, struct json *json)
{
    const struct trace_options *options = &arguments->trace;
    char text[17];

    snprintf(text, sizeof text, "%016llX", (unsigned long long)checksum);
    printf("%s: %zu x %zu, a queue of %zu; frame checksum %s in all stages\n",
           arguments->scene, options->width, options->height, options->queue,
           text);
    provenance_print(options->model, "");
    if (!json)
        return;
    json_text(json, "scene", arguments->scene);
    json_count(json, "width", options->width);
    json_count(json, "height", options->height);
    json_count(json, "queue", options->queue);
    json_text(json, "checksum", text);
    provenance_json(options->model, json);
}

static bool tell_table(enum profile_table kind,
                       const struct trace *const traces[TRACE_MODES],
                       struct json *json)
{
    struct table *table = profile_table(kind, traces);
    bool good = table != NULL;

    printf("\n%s\n\n", profile_table_heading(kind));
    good = good && table_print(table, stdout);
    if (good && json)
        good = table_json(table, json, profile_table_key(kind));
    table_free(table);
    return good;
}

static bool tell(const struct cmd_arguments *arguments,
                 struct trace *const traces[TRACE_MODES], struct json *json)
{
    const struct trace *finished[TRACE_MODES];
    bool good = true;

    for (int i = 0; i < TRACE_MODES; i++)
        finished[i] = traces[i];
    tell_head(arguments, trace_checksum(traces[0]), json);
    for (int kind = 0; kind < PROFILE_TABLES && good; kind++)
        good = tell_table((enum profile_table)kind, finished, json);
    return good;
}

static int profile(const struct cmd_arguments *arguments, struct json *json)
{
    struct scene *scene = cmd_read_scene(arguments);
    struct trace *traces[TRACE_MODES] = { NULL };
    c205_error error = { "no memory" };
    bool good = scene != NULL
                && trace_stages(arguments, scene, traces, &error)
                && equal(traces, &error) && tell(arguments, traces, json);

    for (int i = 0; i < TRACE_MODES; i++)
        trace_free(traces[i]);
    if (!scene)
        return CMD_FAILED;
    scene_free(scene);
    return good ? CMD_DONE
                : cmd_failed(arguments->command, "%s", error.message);
}

int cmd_profile(struct cmd_arguments *arguments)
{
    return cmd_with_machine(arguments, profile);
}
