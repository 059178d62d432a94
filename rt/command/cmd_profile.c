/* cmd_profile.c - rt205 profile: compares the costs of a frame in the scalar form, the
 * form of 1984 and the vector form. */
#include <stdio.h>

#include "base/provenance.h"
#include "rt/command/session.h"
#include "rt/study/profile.h"

struct profile_arguments {
    struct trace_arguments shared;
    struct scene_arguments scene;
};

static void print_head(const struct profile_arguments *args, const struct trace *trace,
                       const struct command_output *results)
{
    const struct trace_options *options = &args->shared.trace;
    struct json *json = results->json;
    char text[17];
    snprintf(text, sizeof text, "%016llX", (unsigned long long)trace_checksum(trace));
    output_printf(results,
                  "%s: %zu x %zu, a queue of %zu; frame checksum %s in all stages\n",
                  args->scene.path, options->width, options->height, options->queue,
                  text);
    output_model(results, options->model);
    if (!json)
        return;
    json_text(json, "scene", args->scene.path);
    json_count(json, "width", options->width);
    json_count(json, "height", options->height);
    json_count(json, "samples", trace_samples(trace));
    json_count(json, "queue", options->queue);
    json_text(json, "checksum", text);
    provenance_json(options->model, json);
}

/* Disables the outputs of a table that another table replaces. Text has three groups of
 * parts, in millions of clocks; CSV and JSON have the exact clocks of each part. */
static struct command_output results_of(enum profile_table kind,
                                        const struct command_output *results)
{
    struct command_output chosen = *results;
    bool exact = results->format == OUTPUT_CSV;
    if (kind == PROFILE_GROUPS)
        chosen.json = NULL;
    if (kind == (exact ? PROFILE_GROUPS : PROFILE_CLOCKS))
        chosen.file = NULL;
    return chosen;
}

static bool print_table(enum profile_table kind, const struct profile *profile,
                        const struct command_output *results)
{
    struct command_output chosen = results_of(kind, results);
    return output_part(&chosen, profile_table(kind, profile), profile_table_key(kind),
                       profile_table_heading(kind));
}

static bool print_result(const struct profile_arguments *args,
                         const struct profile *profile,
                         const struct command_output *results)
{
    bool good = true;
    print_head(args, profile->traces[0], results);
    for (int kind = 0; kind < PROFILE_TABLES && good; kind++)
        good = print_table((enum profile_table)kind, profile, results);
    return good;
}

static int profile_scene(struct trace_session *session,
                         const struct profile_arguments *args)
{
    const struct scene *scene = session_scene(session, &args->scene);
    struct profile profile = { .traces = { NULL } };
    c205_error error = { "out of memory" };
    bool good;
    if (!scene)
        return CMD_FAILED;
    good = profile_run(&profile, scene, &args->shared.trace, &error)
           && print_result(args, &profile, &session->results);
    profile_free(&profile);
    return good ? CMD_DONE : cmd_failed(args->shared.command, "%s", error.message);
}

static int cmd_profile(void *given)
{
    struct profile_arguments *args = given;
    struct trace_session session;
    int code = session_open(&session, &args->shared, NULL);
    if (code == CMD_DONE)
        code = profile_scene(&session, args);
    return session_close(&session, code);
}

#define PLACE(member) offsetof(struct profile_arguments, member)

static const struct command_option options[] = {
    CMD_SIZE(320, 240),
    CMD_QUEUE("rays in the vector queue"),
    CMD_SAMPLES,
    CMD_THRESHOLD,
    CMD_ORDER(ORDER_DEFAULT),
    CMD_MODEL,
    CMD_BOUNDS,
    CMD_JOBS("bands of the frame traced at a time"),
    CMD_READ(PLACE(scene)),
    CMD_RESULTS,
    COMMAND_END
};
static const struct command_option operands[] = { CMD_SCENE(PLACE(scene)),
                                                  COMMAND_END };

const struct command profile_command = {
    COMMAND_ROW("profile", cmd_profile, struct profile_arguments,
                "clocks of each part of a frame, in three stages"),
    .details = "Traces the frame three times: scalar; kernels, as in 1984 "
               "(vector intersection, all else serial); vector. The frames "
               "must be equal. Prints clocks part by part, speedups, Amdahl's "
               "prediction.",
};
