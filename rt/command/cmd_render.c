/* cmd_render.c - rt205 render: a scene in, a picture out, clocks told. */
#include <stdio.h>

#include "base/accounts.h"
#include "base/provenance.h"
#include "rt/command/rt205_command.h"

static bool write_picture(const struct cmd_arguments *arguments,
                          const struct trace *trace, c205_error *error)
{
    const struct accounts *accounts = trace_accounts(trace);
    struct frame frame = { 0 };
    struct picture_error why;
    char clocks[32];
    const struct picture_note notes[] = {
        { "Software", "rt205" },
        { "rt205:scene", arguments->scene },
        { "rt205:model", c205_model_name(accounts->model) },
        { "rt205:mode", trace_mode_name(arguments->trace.mode) },
        { "rt205:clocks", clocks },
        { NULL, NULL },
    };
    bool good;

    snprintf(clocks, sizeof clocks, "%llu",
             (unsigned long long)accounts->clocks);
    if (!trace_read(trace, &frame, error))
        return false;
    good = picture_write(arguments->output, &frame, notes, arguments->half,
                         &why);
    if (!good)
        snprintf(error->message, sizeof error->message, "%s", why.message);
    frame_free(&frame);
    return good;
}

/* What a run has to tell, for print and for JSON. */
struct result {
    const struct cmd_arguments *arguments;
    const c205_model *model;
    uint64_t clocks;
    char checksum[17];
    struct table *regions, *causes; /* printed */
    struct table *detail;           /* causes by region, for JSON */
};

static void print_result(const struct result *result)
{
    const struct trace_options *trace = &result->arguments->trace;

    printf("%s: %zu x %zu, %s", result->arguments->scene, trace->width,
           trace->height, trace_mode_name(trace->mode));
    if (trace->mode != TRACE_SCALAR)
        printf(", a queue of %zu", trace->queue);
    printf(": %llu clocks, %.4f s on the machine\n",
           (unsigned long long)result->clocks,
           accounts_seconds(result->model, result->clocks));
    printf("frame checksum %s\n", result->checksum);
    provenance_print(result->model, "");
}

static bool write_result(const struct result *result, struct json *json)
{
    const struct trace_options *trace = &result->arguments->trace;

    json_text(json, "scene", result->arguments->scene);
    json_text(json, "mode", trace_mode_name(trace->mode));
    json_count(json, "width", trace->width);
    json_count(json, "height", trace->height);
    json_count(json, "queue", trace->queue);
    json_count(json, "clocks", result->clocks);
    json_number(json, "seconds",
                accounts_seconds(result->model, result->clocks));
    json_text(json, "checksum", result->checksum);
    provenance_json(result->model, json);
    return table_json(result->regions, json, "regions")
           && table_json(result->detail, json, "causes");
}

static bool tell(const struct cmd_arguments *arguments,
                 const struct trace *trace, struct json *json)
{
    const struct accounts *accounts = trace_accounts(trace);
    struct result result = { .arguments = arguments,
                             .model = accounts->model,
                             .clocks = accounts->clocks,
                             .regions = accounts_by_region(accounts),
                             .causes = accounts_of_run(accounts),
                             .detail = accounts_by_cause(accounts) };
    bool good = result.regions && result.causes && result.detail;

    if (good) {
        snprintf(result.checksum, sizeof result.checksum, "%016llX",
                 (unsigned long long)trace_checksum(trace));
        print_result(&result);
        good = table_print(result.regions, stdout) && putchar('\n') != EOF
               && table_print(result.causes, stdout);
    }
    if (good && json)
        good = write_result(&result, json);
    table_free(result.regions);
    table_free(result.causes);
    table_free(result.detail);
    return good;
}

/* What is finished of a frame that did not come to its end stays in the file
 * that --resume names. */
static bool run(const struct cmd_arguments *arguments, struct trace *trace,
                c205_error *error)
{
    const char *keep = arguments->resume;
    c205_error why;

    if (keep && !trace_keep(trace, keep, error))
        return false;
    if (trace_run(trace, &why))
        return true;
    snprintf(error->message, sizeof error->message, "%.120s%s%.100s",
             why.message, keep ? "; --resume goes on from " : "",
             keep ? keep : "");
    return false;
}

static int render(const struct cmd_arguments *arguments,
                  const struct scene *scene, struct json *json)
{
    c205_error error = { "no memory" };
    struct trace *trace = trace_new(scene, &arguments->trace, &error);
    bool good = trace && run(arguments, trace, &error)
                && write_picture(arguments, trace, &error);

    if (good) {
        trace_forget(trace);
        good = tell(arguments, trace, json);
    }
    trace_free(trace);
    return good ? CMD_DONE
                : cmd_failed(arguments->command, "%s", error.message);
}

static int render_scene(const struct cmd_arguments *arguments,
                        struct json *json)
{
    struct scene *scene = cmd_read_scene(arguments);
    int code = !scene ? CMD_FAILED : render(arguments, scene, json);

    scene_free(scene);
    return code;
}

/* What is wrong with the files asked for: the exit code, CMD_DONE if
 * nothing. */
static int check_files(const struct cmd_arguments *arguments)
{
    struct picture_error why;

    if (!arguments->output)
        return cmd_usage(arguments->command, "name the picture with -o");
    if (!picture_check_path(arguments->output, &why))
        return cmd_failed(arguments->command, "%s", why.message);
    if (arguments->half && !picture_holds_half(arguments->output))
        return cmd_usage(arguments->command, "--half is for .exr alone");
    return CMD_DONE;
}

static int run_command_line(void *given)
{
    struct cmd_arguments *arguments = given;
    int code = check_files(arguments);

    return code == CMD_DONE ? cmd_with_machine(arguments, render_scene)
                            : code;
}

static const struct command_option options[] = {
    { .name = "output",
      .letter = 'o',
      .value = "FILE",
      .kind = COMMAND_FILE,
      .offset = CMD_PLACE(output),
      .help = "the picture: .png .jpg (8-bit sRGB), .exr .tif (linear, with "
              "depth, normal and id)" },
    CMD_SIZE(640, 480),
    CMD_MODE(cmd_mode_choice, "in which form; kernels is that of 1984"),
    CMD_QUEUE("rays in the vector queue"),
    CMD_MODEL,
    CMD_BOUNDS,
    CMD_JOBS("bands of the frame traced at a time"),
    { .name = "resume",
      .value = "FILE",
      .kind = COMMAND_FILE,
      .offset = CMD_PLACE(resume),
      .help = "keep finished bands there; go on from those it has" },
    CMD_FLAG("half", half, "16-bit colours in an .exr"),
    CMD_READ,
    CMD_JSON,
    COMMAND_END
};
static const struct command_option operands[] = { CMD_SCENE, COMMAND_END };
static const struct command_example examples[] = {
    { "rt205 render SCENE -o PICTURE",
      "the picture, and where the machine's clocks went" },
    { NULL, NULL }
};

const struct command render_command = {
    .name = "render",
    .summary = "trace a scene, write a picture",
    .function = run_command_line,
    .options = options,
    .operands = operands,
    .examples = examples,
};
