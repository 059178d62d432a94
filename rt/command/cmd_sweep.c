/* cmd_sweep.c - rt205 sweep: measures the cost of a ray while one parameter changes. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "vm/error.h"
#include "base/file.h"
#include "base/outputs.h"
#include "base/provenance.h"
#include "rt/command/session.h"
#include "rt/study/sweep/plot_file.h"
#include "rt/study/sweep/sweep_types.h"

/* Queue lengths, in increasing order. */
struct points {
    size_t count;
    size_t items[MAX_SWEEP_LENGTHS];
};

struct sweep_arguments {
    struct trace_arguments shared;
    struct scene_arguments scene; /* a scene file or the name of a primitive */
    struct speedup_view view;     /* angle 0: not specified */
    struct points points;
    int sweep; /* index of the sweep type */
};

/* ---- The request --------------------------------------------------------- */

static bool names_scene(const char *name)
{
    size_t length = strlen(name);
    return strcmp(name, "-") == 0 || strchr(name, '/') != NULL
           || (length > 4 && strcmp(name + length - 4, ".pov") == 0);
}

static int check_lengths(const struct sweep_arguments *args,
                         const struct sweep_kind *kind)
{
    size_t rays = args->shared.trace.width * args->shared.trace.height;
    size_t longest = args->points.count > 0 ? args->points.items[args->points.count - 1]
                                            : 0;
    if (longest > 0 && !kind->takes_lengths)
        return cmd_usage(args->shared.command,
                         "--points requires a sweep of queue or length");
    if (kind->takes_lengths && args->shared.trace.queue != TRACE_QUEUE)
        return cmd_usage(args->shared.command,
                         "--queue requires a sweep of pipes or hits; use --points "
                         "for lengths");
    if (kind == &sweep_queue && longest > rays)
        return cmd_usage(args->shared.command, "%zu ray%s not fill a queue of %zu",
                         rays, rays == 1 ? " does" : "s do", longest);
    return CMD_DONE;
}

static int check_subject(const struct sweep_arguments *args,
                         const struct sweep_kind *kind)
{
    const char *name = args->scene.path;
    if (kind->primitive_only && names_scene(name))
        return cmd_usage(args->shared.command, "%s requires a primitive, not a scene",
                         kind->name);
    if (!names_scene(name) && !speedup_subject_named(name))
        return cmd_usage(args->shared.command,
                         "%s: expected a primitive of Table 1 (sphere, cylinder, "
                         "Steiner, torus) or a .pov file",
                         name);
    return CMD_DONE;
}

/* Checks the paths of the plot and of the JSON. */
static int check_files(const struct sweep_arguments *args)
{
    char svg[PLOT_PATH];
    const char *const paths[] = { args->shared.output, svg };
    c205_error error;
    if (!args->shared.output)
        return CMD_DONE;
    if (!plot_check_path(args->shared.output, &error))
        return plot_is_named(args->shared.output)
                   ? cmd_failed(args->shared.command, "%s", error.message)
                   : cmd_usage(args->shared.command, "%s", error.message);
    plot_svg_path(args->shared.output, svg);
    for (size_t i = 0; i < 2; i++) {
        if (args->shared.results.path
            && file_is_one(paths[i], args->shared.results.path))
            return cmd_usage(args->shared.command, "-o and --json name the same file");
        if (!outputs_add(paths[i]))
            return cmd_failed(args->shared.command, "out of memory");
    }
    return CMD_DONE;
}

static int check(const struct sweep_arguments *args)
{
    const struct sweep_kind *kind = sweep_kinds[args->sweep];
    int code;
    code = check_subject(args, kind);
    if (code == CMD_DONE)
        code = check_lengths(args, kind);
    return code == CMD_DONE ? check_files(args) : code;
}

/* ---- Results ------------------------------------------------------------- */

/* Returns true if the sweep uses the requested frame. The sweep of queue lengths uses
 * frames of one queue instead. */
static bool has_frame(const struct sweep_kind *kind)
{
    return kind != &sweep_length;
}

static void print_head(const struct sweep_arguments *args, const struct sweep *sweep,
                       const struct sweep_kind *kind,
                       const struct command_output *results)
{
    const struct trace_options *trace = &args->shared.trace;
    char queue[48] = "", rays[64] = "", view[96] = "";
    if (!kind->takes_lengths)
        snprintf(queue, sizeof queue, ", a queue of %zu", trace->queue);
    if (has_frame(kind))
        snprintf(rays, sizeof rays, ", %zu x %zu rays", trace->width, trace->height);
    if (sweep->subject)
        snprintf(view, sizeof view, ", %g degrees across from a distance of %g",
                 sweep->base.view.angle, sweep->base.view.distance);
    output_printf(results,
                  "%s of %s, %s%s%s%s;\n%s.\nAt each point the scalar and the "
                  "other frame are equal, bit for bit.\n",
                  kind->name, sweep->subject ? sweep->subject->name : args->scene.path,
                  trace_mode_name(trace->mode), queue, rays, view,
                  sweep->subject ? "the kernel and its calls alone"
                                 : "the whole frame");
    output_model(results, trace->model);
}

/* Writes the parameters of the sweep, except those that it does not use. */
static void write_head(const struct sweep_arguments *args, const struct sweep *sweep,
                       const struct sweep_kind *kind, struct json *json)
{
    const struct trace_options *trace = &args->shared.trace;
    json_text(json, "sweep", kind->name);
    json_text(json, sweep->subject ? "primitive" : "scene",
              sweep->subject ? sweep->subject->name : args->scene.path);
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

static bool draw(const struct sweep_arguments *args, const struct sweep *sweep,
                 const struct sweep_kind *kind, const struct sweep_report *report,
                 c205_error *error)
{
    const c205_model *model = args->shared.trace.model;
    char title[160], on[160], belief[PROVENANCE_LINE];
    const char *const subtitles[] = { on, belief };
    struct plot plot = report->plot;
    snprintf(title, sizeof title, "%s: %.100s", kind->title,
             sweep->subject ? sweep->subject->name : args->scene.path);
    snprintf(on, sizeof on,
             "form %s; cycle-accounted, not cycle-accurate, "
             "on the model %.60s",
             trace_mode_name(args->shared.trace.mode), c205_model_name(model));
    provenance_line(model, belief);
    plot.title = title;
    plot.subtitles = subtitles;
    plot.subtitle_count = 2;
    return plot_write(&plot, report->plotted, args->shared.output, error);
}

/* Prints all results except the plot. */
static bool report_progress(const struct sweep_arguments *args,
                            const struct sweep *sweep, const struct sweep_kind *kind,
                            const struct sweep_report *report,
                            const struct command_output *results, c205_error *error)
{
    bool good = true;
    error_set(error, "out of memory");
    print_head(args, sweep, kind, results);
    if (results->file)
        good = sweep_report_write(report, output_table_format(results), results->file);
    if (good && results->json) {
        write_head(args, sweep, kind, results->json);
        good = sweep_report_json(report, sweep, results->json);
    }
    return good;
}

static struct sweep sweep_of(const struct sweep_arguments *args,
                             const struct scene *scene, const struct sweep_kind *kind)
{
    struct sweep sweep = {
        .subject = !scene ? speedup_subject_named(args->scene.path) : NULL,
        .scene = scene,
        .base = { .trace = args->shared.trace, .view = args->view },
        .lengths = args->points.items,
        .length_count = args->points.count,
    };
    if (sweep.base.view.angle == 0)
        sweep.base.view.angle = kind->angle;
    return sweep;
}

/* Measures the sweep, prints it and draws the plot. If only the plot fails, the other
 * results are valid: *drawn is then false, and the exit code is CMD_DONE. */
static int measure_and_draw(struct trace_session *session,
                            const struct sweep_arguments *args, bool *drawn)
{
    const struct sweep_kind *kind = sweep_kinds[args->sweep];
    bool of_scene = names_scene(args->scene.path);
    const struct scene *scene = of_scene ? session_scene(session, &args->scene) : NULL;
    struct sweep sweep = sweep_of(args, scene, kind);
    struct sweep_report report = { .part_count = 0 };
    c205_error error;
    bool good;
    if (of_scene && !scene)
        return CMD_FAILED;
    good = kind->measure(&sweep, &error) && kind->report(&sweep, &report, &error)
           && report_progress(args, &sweep, kind, &report, &session->results, &error);
    *drawn = good
             && (!args->shared.output || draw(args, &sweep, kind, &report, &error));
    if (!*drawn)
        cmd_failed(args->shared.command, "%s", error.message);
    sweep_report_free(&report);
    sweep_free(&sweep);
    return good ? CMD_DONE : CMD_FAILED;
}

static int cmd_sweep(void *given)
{
    struct sweep_arguments *args = given;
    struct trace_session session;
    bool drawn = true;
    int code = check(args);
    if (code != CMD_DONE)
        return code;
    code = session_open(&session, &args->shared, NULL);
    if (code == CMD_DONE)
        code = measure_and_draw(&session, args, &drawn);
    code = session_close(&session, code);
    return drawn ? code : CMD_FAILED;
}

/* ---- The command line ---------------------------------------------------- */

static const char *kind_choice(size_t number)
{
    return sweep_kinds[number] ? sweep_kinds[number]->name : NULL;
}

/* Returns the name of a mode. The scalar mode is omitted, because it has no queue. */
static const char *queue_mode_choice(size_t number)
{
    return number == TRACE_SCALAR ? "" : cmd_mode_choice(number);
}

/* Parses a list of increasing numbers, separated by commas. */
static bool take_points(char *text, void *value)
{
    struct points *points = value;
    size_t last = 0;
    points->count = 0;
    do {
        char *end;
        unsigned long length = strtoul(text, &end, 10);
        if (*text < '0' || *text > '9' || length <= last || length > MAX_TRACE_QUEUE
            || points->count == MAX_SWEEP_LENGTHS || (*end != ',' && *end != '\0'))
            return false;
        points->items[points->count++] = last = (size_t)length;
        text = end;
    } while (*text++ == ',');
    return true;
}

#define PLACE(member) offsetof(struct sweep_arguments, member)

static const struct command_option options[] = {
    { OPTION_ROW(
          "output", "FILE", COMMAND_FILE, CMD_SHARED(output),
          "draw a plot, .svg or .png; a .png also has a .svg, and needs rsvg-convert"),
      .letter = 'o' },
    { OPTION_ROW("points", "N,N,..", COMMAND_CUSTOM, PLACE(points),
                 "lengths for queue and length (1, 2, 4 .. 65535, 2000)"),
      .take = take_points,
      .wants = "ascending numbers up to 65535, separated by commas" },
    CMD_SIZE(256, 256),
    CMD_VIEW(PLACE(view), 0, "10; hits: 37"),
    CMD_MODE(queue_mode_choice, "form of the queues; kernels is that of 1984"),
    CMD_QUEUE("rays in the queue (pipes, hits)"),
    CMD_ORDER(ORDER_ROWS),
    CMD_MODEL,
    CMD_BOUNDS,
    CMD_JOBS("frames traced at a time"),
    CMD_READ(PLACE(scene)),
    CMD_RESULTS,
    COMMAND_END
};
static const struct command_option operands[] = {
    { OPERAND_ROW("WHAT", COMMAND_CHOICE, PLACE(sweep), "the quantity that changes"),
      .choice = kind_choice },
    { OPERAND_ROW("SCENE|PRIMITIVE", COMMAND_INPUT, PLACE(scene.path),
                  "a scene file or a primitive") },
    COMMAND_END
};
static const struct command_example examples[] = {
    { "rt205 sweep queue SCENE|PRIMITIVE", "lengths of the queue" },
    { "rt205 sweep pipes SCENE|PRIMITIVE", "1, 2, 4 pipes; 64, 32 bits" },
    { "rt205 sweep hits PRIMITIVE", "the share of the rays that hit it" },
    { "rt205 sweep length SCENE|PRIMITIVE",
      "one queue of rays: the length from which queues cost less than scalar code" },
    { NULL, NULL }
};

const struct command sweep_command = {
    COMMAND_ROW("sweep", cmd_sweep, struct sweep_arguments,
                "clocks per ray against one quantity, as table and plot"),
    .details = "A primitive is sphere, cylinder, Steiner, 'Steiner, ours' or torus; "
               "its kernel and calls count. A scene is a name with a /, or ending in "
               ".pov, or -; all of its frame counts. Scalar and vector frames must be "
               "equal.",
    .examples = examples,
};
