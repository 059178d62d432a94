/* cmd_sweep.c - rt205 sweep: what a ray costs as one thing changes. */
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "base/provenance.h"
#include "rt/command/cmd.h"

/* ---- What is asked for --------------------------------------------------- */

static bool names_scene(const char *name)
{
    size_t length = strlen(name);

    return strchr(name, '/') != NULL
           || (length > 4 && strcmp(name + length - 4, ".pov") == 0);
}

/* Whole, or as far as its comma, in capitals or not; the first that fits. */
static const struct speedup_subject *subject_named(const char *name)
{
    for (size_t i = 0; i < speedup_subject_count; i++) {
        const struct speedup_subject *subject = &speedup_subjects[i];
        size_t stem = strcspn(subject->name, ",");

        if (strcasecmp(subject->name, name) == 0
            || (strlen(name) == stem
                && strncasecmp(subject->name, name, stem) == 0))
            return subject;
    }
    return NULL;
}

static int check_lengths(const struct cmd_arguments *arguments,
                         const struct sweep_kind *kind)
{
    size_t rays = arguments->trace.width * arguments->trace.height;
    size_t longest = arguments->point_count > 0
                         ? arguments->points[arguments->point_count - 1]
                         : 0;

    if (longest > 0 && !kind->takes_lengths)
        return cmd_usage(arguments->command,
                         "--points are lengths: of queue and length");
    if (kind->takes_lengths && arguments->trace.queue != TRACE_QUEUE)
        return cmd_usage(arguments->command,
                         "--queue is for pipes and hits; --points names "
                         "lengths");
    if (kind == &sweep_queue && longest > rays)
        return cmd_usage(arguments->command,
                         "%zu rays do not fill a queue of %zu", rays,
                         longest);
    return CMD_DONE;
}

static int check_subject(const struct cmd_arguments *arguments,
                         const struct sweep_kind *kind)
{
    const char *name = arguments->scene;

    if (kind->primitive_only && names_scene(name))
        return cmd_usage(arguments->command,
                         "%s takes a primitive: what a "
                         "scene's rays hit is its own",
                         kind->name);
    if (!names_scene(name) && !subject_named(name))
        return cmd_usage(arguments->command,
                         "%s: no primitive of Table 1 "
                         "(sphere, cylinder, Steiner, torus), and no .pov",
                         name);
    return CMD_DONE;
}

/* The plot's three files, and the JSON. */
static int check_files(const struct cmd_arguments *arguments)
{
    static const char *const endings[] = { "svg", "dat", "gp" };
    c205_error error;

    if (!arguments->output)
        return CMD_DONE;
    if (!plot_check_path(arguments->output, &error))
        return cmd_failed(arguments->command, "%s", error.message);
    for (int i = 0; i < 3; i++) {
        char path[4096];

        snprintf(path, sizeof path, "%.*s%s",
                 (int)strlen(arguments->output) - 3, arguments->output,
                 endings[i]);
        if (cmd_is_one_file(path, arguments->json))
            return cmd_usage(arguments->command,
                             "-o and --json name one file");
    }
    return CMD_DONE;
}

static int check(const struct cmd_arguments *arguments)
{
    const struct sweep_kind *kind = sweep_kind_named(arguments->sweep);
    int code;

    if (!kind)
        return cmd_usage(arguments->command,
                         "%s: sweep queue, pipes, hits or length",
                         arguments->sweep);
    if (arguments->trace.mode == TRACE_SCALAR)
        return cmd_usage(arguments->command,
                         "--mode of the queues: kernels or vector");
    code = check_subject(arguments, kind);
    if (code == CMD_DONE)
        code = check_lengths(arguments, kind);
    return code == CMD_DONE ? check_files(arguments) : code;
}

/* ---- Results ------------------------------------------------------------- */

/* A sweep of lengths makes frames of its own, of one queue each. */
static bool has_frame(const struct sweep_kind *kind)
{
    return kind != &sweep_length;
}

static void print_head(const struct cmd_arguments *arguments,
                       const struct sweep *sweep,
                       const struct sweep_kind *kind)
{
    const struct trace_options *trace = &arguments->trace;
    const char *remark = table_remark((enum table_format)arguments->format);

    printf("%s%s of %s, %s", remark, kind->name,
           sweep->subject ? sweep->subject->name : arguments->scene,
           trace_mode_name(trace->mode));
    if (!kind->takes_lengths)
        printf(", a queue of %zu", trace->queue);
    if (has_frame(kind))
        printf(", %zu x %zu rays", trace->width, trace->height);
    if (sweep->subject)
        printf(", %g degrees across from a distance of %g;\n%sthe kernel and "
               "its calls alone.\n",
               sweep->base.view.angle, sweep->base.view.distance, remark);
    else
        printf(";\n%sthe whole frame.\n", remark);
    printf("%sAt each point the scalar and the other frame are equal, bit "
           "for bit.\n",
           remark);
    provenance_print(trace->model, remark);
}

/* What has no part in this sweep is left out. */
static void write_head(const struct cmd_arguments *arguments,
                       const struct sweep *sweep,
                       const struct sweep_kind *kind, struct json *json)
{
    const struct trace_options *trace = &arguments->trace;

    json_text(json, "sweep", kind->name);
    json_text(json, sweep->subject ? "primitive" : "scene",
              sweep->subject ? sweep->subject->name : arguments->scene);
    json_text(json, "mode", trace_mode_name(trace->mode));
    if (!kind->takes_lengths)
        json_count(json, "queue", trace->queue);
    if (has_frame(kind)) {
        json_count(json, "width", trace->width);
        json_count(json, "height", trace->height);
    }
    if (sweep->subject) {
        json_number(json, "distance", sweep->base.view.distance);
        json_number(json, "angle", sweep->base.view.angle);
    }
    provenance_json(trace->model, json);
}

static bool draw(const struct cmd_arguments *arguments,
                 const struct sweep *sweep, const struct sweep_kind *kind,
                 const struct sweep_report *report, c205_error *error)
{
    const c205_model *model = arguments->trace.model;
    char title[160], on[160], belief[PROVENANCE_LINE];
    const char *const subtitles[] = { on, belief };
    struct plot plot = report->plot;

    snprintf(title, sizeof title, "%s: %.100s", kind->title,
             sweep->subject ? sweep->subject->name : arguments->scene);
    snprintf(on, sizeof on,
             "form %s; cycle-accounted, not cycle-accurate, "
             "on the model %.60s",
             trace_mode_name(arguments->trace.mode), c205_model_name(model));
    provenance_line(model, belief);
    plot.title = title;
    plot.subtitles = subtitles;
    plot.subtitle_count = 2;
    return plot_write(&plot, report->plotted, arguments->output, error);
}

/* All but the plot. */
static bool tell(const struct cmd_arguments *arguments,
                 const struct sweep *sweep, const struct sweep_kind *kind,
                 const struct sweep_report *report, struct json *json,
                 c205_error *error)
{
    bool good = true;

    snprintf(error->message, sizeof error->message, "no memory");
    if (arguments->format != FORMAT_JSON) {
        print_head(arguments, sweep, kind);
        good = sweep_report_write(report,
                                  (enum table_format)arguments->format,
                                  stdout);
    }
    if (good && json) {
        write_head(arguments, sweep, kind, json);
        good = sweep_report_json(report, sweep, json);
    }
    return good;
}

static struct sweep sweep_of(const struct cmd_arguments *arguments,
                             const struct scene *scene,
                             const struct sweep_kind *kind)
{
    struct sweep sweep = {
        .subject = !scene ? subject_named(arguments->scene) : NULL,
        .scene = scene,
        .base = { .trace = arguments->trace, .view = arguments->view },
        .lengths = arguments->points,
        .length_count = arguments->point_count,
    };

    if (sweep.base.view.angle == 0)
        sweep.base.view.angle = kind->angle;
    return sweep;
}

static int sweep_target(const struct cmd_arguments *arguments,
                        const struct scene *scene, struct json *json)
{
    const struct sweep_kind *kind = sweep_kind_named(arguments->sweep);
    struct sweep sweep = sweep_of(arguments, scene, kind);
    struct sweep_report report = { .part_count = 0 };
    c205_error error;
    int code = CMD_DONE;

    if (!kind->measure(&sweep, &error)
        || !kind->report(&sweep, &report, &error)
        || !tell(arguments, &sweep, kind, &report, json, &error))
        code = CMD_FAILED;
    else if (arguments->output
             && !draw(arguments, &sweep, kind, &report, &error))
        code = CMD_UNDRAWN;
    if (code != CMD_DONE)
        cmd_failed(arguments->command, "%s", error.message);
    sweep_report_free(&report);
    sweep_free(&sweep);
    return code;
}

static int sweep(const struct cmd_arguments *arguments, struct json *json)
{
    struct scene *scene;
    int code;

    if (!names_scene(arguments->scene))
        return sweep_target(arguments, NULL, json);
    scene = cmd_read_scene(arguments);
    code = !scene ? CMD_FAILED : sweep_target(arguments, scene, json);
    scene_free(scene);
    return code;
}

int cmd_sweep(struct cmd_arguments *arguments)
{
    int code = check(arguments);

    return code == CMD_DONE ? cmd_with_machine(arguments, sweep) : code;
}
